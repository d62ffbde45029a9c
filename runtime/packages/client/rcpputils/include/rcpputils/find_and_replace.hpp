// Replaces every occurrence of a text.
#pragma once

#include <string>

namespace rcpputils {

inline std::string find_and_replace(const std::string& input, const std::string& find,
                                    const std::string& replace) {
  std::string output = input;
  for (size_t at = 0; !find.empty() && (at = output.find(find, at)) != std::string::npos;
       at += replace.size()) {
    output.replace(at, find.size(), replace);
  }
  return output;
}

}  // namespace rcpputils
