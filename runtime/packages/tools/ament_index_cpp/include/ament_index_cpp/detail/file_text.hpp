// The text of a file, without streams: they add 30 kB (brotli) to a program that has none.
#pragma once

#include <optional>
#include <string>

namespace ament_index_cpp::detail {

/// Nothing when the file cannot be opened.
std::optional<std::string> file_text(const std::string& path);

}  // namespace ament_index_cpp::detail
