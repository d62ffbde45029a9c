// See array_parser.hpp.
#include "nav2_util/array_parser.hpp"

#include <cmath>
#include <cstdlib>

namespace nav2_util {

std::vector<std::vector<float>> parseVVF(const std::string& input, std::string& error_return) {
  constexpr int kInner = 2;
  std::vector<std::vector<float>> lists;
  std::vector<float> list;
  int depth = 0;
  const char* text = input.c_str();
  error_return.clear();
  for (char letter = *text; letter != '\0'; letter = *text) {
    if (letter == ',' || letter == ' ' || letter == '\t') {
      ++text;
    } else if (letter == '[') {
      ++text;
      list.clear();
      if (++depth > kInner) {
        error_return = "Array depth greater than 2";
        return lists;
      }
    } else if (letter == ']') {
      ++text;
      if (--depth < 0) {
        error_return = "More close ] than open [";
        return lists;
      }
      if (depth == 1) lists.push_back(list);
    } else if (depth != kInner) {
      error_return = "Numbers at depth other than 2. Char was '";
      error_return += letter;
      error_return += "'.";
      return lists;
    } else {
      char* end = nullptr;
      const float number = std::strtof(text, &end);
      // The list does not go on after something else.
      if (end == text || !std::isfinite(number)) break;
      list.push_back(number);
      text = end;
    }
  }
  if (depth != 0) error_return = "Unterminated vector string.";
  return lists;
}

}  // namespace nav2_util
