// See channel_address.hpp.
#include "bundler/channel/channel_address.hpp"

namespace ros2wasm {

std::string channel_base_url(std::string_view channel_name) {
  if (channel_name == "embedded") return "embedded:";
  while (channel_name.size() > 1 && channel_name.ends_with('/')) channel_name.remove_suffix(1);
  return std::string(channel_name);
}

std::string with_base_url(std::string base, const std::string& here) {
  while (base.ends_with('/')) base.pop_back();
  if (base.empty() || base == ".") return here;
  const bool absolute = base.find("://") != std::string::npos || base.starts_with('/');
  return absolute ? base : here + "/" + base;
}

}  // namespace ros2wasm
