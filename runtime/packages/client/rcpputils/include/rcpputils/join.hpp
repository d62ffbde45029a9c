// The elements of a container as one text, with a delimiter between them.
#pragma once

#include <sstream>
#include <string>

namespace rcpputils {

template <typename CharT, typename ValueT, typename AllocatorT,
          template <typename T, typename A> class ContainerT>
std::basic_string<CharT> join(const ContainerT<ValueT, AllocatorT>& container,
                              const CharT* delimiter) {
  std::basic_ostringstream<CharT> text;
  bool first = true;
  for (const auto& element : container) {
    if (!first) {
      text << delimiter;
    }
    first = false;
    text << element;
  }
  return text.str();
}

}  // namespace rcpputils
