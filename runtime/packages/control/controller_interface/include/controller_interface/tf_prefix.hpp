// Prefixes of frames.
#pragma once

#include <string>

namespace controller_interface {

/// `~` stands for the namespace. The result ends with `/` and does not begin with one; an empty
/// prefix stays empty.
inline std::string resolve_tf_prefix(const std::string& prefix, const std::string& node_ns) {
  if (prefix.empty()) {
    return "";
  }
  std::string result = prefix;
  if (const auto at = result.find('~'); at != std::string::npos) {
    result.replace(at, 1, node_ns);
  }
  if (result.empty() || result.back() != '/') {
    result.push_back('/');
  }
  return result.front() == '/' ? result.substr(1) : result;
}

}  // namespace controller_interface
