// See array_parser.hpp.
#include "nav2_util/array_parser.hpp"

#include <sstream>

namespace nav2_util {

std::vector<std::vector<float>> parseVVF(const std::string& input, std::string& error_return) {
  constexpr int kInner = 2;
  std::vector<std::vector<float>> lists;
  std::vector<float> list;
  int depth = 0;
  std::istringstream text(input);
  error_return.clear();
  constexpr int kEnd = std::char_traits<char>::eof();
  for (int letter = text.peek(); letter != kEnd; letter = text.peek()) {
    if (letter == ',' || letter == ' ' || letter == '\t') {
      text.get();
    } else if (letter == '[') {
      text.get();
      list.clear();
      if (++depth > kInner) {
        error_return = "Array depth greater than 2";
        return lists;
      }
    } else if (letter == ']') {
      text.get();
      if (--depth < 0) {
        error_return = "More close ] than open [";
        return lists;
      }
      if (depth == 1) lists.push_back(list);
    } else if (depth != kInner) {
      error_return = "Numbers at depth other than 2. Char was '";
      error_return += static_cast<char>(letter);
      error_return += "'.";
      return lists;
    } else {
      float number = 0;
      if (text >> number) list.push_back(number);
    }
  }
  if (depth != 0) error_return = "Unterminated vector string.";
  return lists;
}

}  // namespace nav2_util
