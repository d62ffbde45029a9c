// See string_utils.hpp.
#include "nav2_util/string_utils.hpp"

namespace nav2_util {

std::string strip_leading_slash(const std::string& in) {
  return in.empty() || in.front() != '/' ? in : in.substr(1);
}

Tokens split(const std::string& tokenstring, char delimiter) {
  Tokens tokens;
  std::string::size_type from = 0;
  for (auto at = tokenstring.find(delimiter); at != std::string::npos;
       at = tokenstring.find(delimiter, from)) {
    tokens.push_back(tokenstring.substr(from, at - from));
    from = at + 1;
  }
  tokens.push_back(tokenstring.substr(from));
  return tokens;
}

}  // namespace nav2_util
