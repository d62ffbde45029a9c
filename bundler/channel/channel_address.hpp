// The addresses that channels and their indexes give. Pure: says where, brings nothing.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

/// "embedded" -> "embedded:", "./dir/" -> "./dir", the base that "/noarch/repodata.json" is put
/// behind.
[[nodiscard]] std::string channel_base_url(std::string_view channel_name);

/// `base` as an index names it (CEP 15), which may be empty or relative to `here`, the folder of
/// the index. Without a slash at its end.
[[nodiscard]] std::string with_base_url(std::string base, const std::string& here);

}  // namespace ros2wasm
