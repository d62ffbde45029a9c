// Parts of names.
#pragma once

#include <string>
#include <vector>

namespace nav2_util {

using Tokens = std::vector<std::string>;

std::string strip_leading_slash(const std::string& in);
/// Empty parts are parts: `a::b` gives `a`, an empty one and `b`.
Tokens split(const std::string& tokenstring, char delimiter);

}  // namespace nav2_util
