// A text cut at a delimiter.
#pragma once

#include <iterator>
#include <string>
#include <vector>

namespace rcpputils {

template <class InsertIterator>
void split(const std::string& input, char delimiter, InsertIterator& it, bool skip_empty = false) {
  size_t start = 0;
  while (start <= input.size() && !input.empty()) {
    const size_t found = input.find(delimiter, start);
    const size_t end = found == std::string::npos ? input.size() : found;
    if (!skip_empty || end > start) {
      *it++ = input.substr(start, end - start);
    }
    if (found == std::string::npos) {
      return;
    }
    start = found + 1;
  }
}

inline std::vector<std::string> split(const std::string& input, char delimiter,
                                      bool skip_empty = false) {
  std::vector<std::string> parts;
  auto it = std::back_inserter(parts);
  split(input, delimiter, it, skip_empty);
  return parts;
}

}  // namespace rcpputils
