// See replaced_text.hpp.
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {

std::string with_replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string out;
  while (!text.empty()) {
    const std::size_t at = from.empty() ? std::string_view::npos : text.find(from);
    out.append(text.substr(0, at));
    if (at == std::string_view::npos) break;
    out.append(to);
    text.remove_prefix(at + from.size());
  }
  return out;
}

}  // namespace ros2wasm
