// See prefix_text.hpp.
#include "bundler/store/prefix_text.hpp"

#include <algorithm>

#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {

std::string with_prefix_in_text(std::string_view text, std::string_view placeholder,
                                std::string_view prefix) {
  return with_replaced(text, placeholder, prefix);
}

Outcome<std::string> with_prefix_in_binary(std::string_view bytes, std::string_view placeholder,
                                           std::string_view prefix, const std::string& path) {
  if (prefix.size() > placeholder.size()) {
    return Diagnostic{
        .code = "R2W0230",
        .kind = FailureKind::kEnvironment,
        .message = "`" + path + "` cannot be moved to `" + std::string(prefix) + "`",
        .why = {"it is a binary file with room for " + std::to_string(placeholder.size()) +
                " bytes of path, and this path has " + std::to_string(prefix.size())}};
  }
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t at = placeholder.empty() ? std::string_view::npos : bytes.find(placeholder);
    out.append(bytes.substr(0, at));
    if (at == std::string_view::npos) break;
    bytes.remove_prefix(at);
    // From here to the end of the C string, however often it names the placeholder.
    const std::string_view text = bytes.substr(0, std::min(bytes.find('\0'), bytes.size()));
    std::string moved = with_prefix_in_text(text, placeholder, prefix);
    moved.resize(text.size(), '\0');
    out += moved;
    bytes.remove_prefix(text.size());
  }
  return out;
}

}  // namespace ros2wasm
