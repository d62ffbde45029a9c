// How the parts of a message are written and read: primitives, strings, arrays, sequences and
// nested messages. Generated code specialises Codec for each message and calls these functions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include "ros2wasm_typesupport/cdr.hpp"

namespace ros2wasm_typesupport {

/// One specialisation for each message type, made by the generator:
///   kMinimumSize     fewest payload bytes one value can take, without padding; at least 1
///   kPlainAlignment  0, or the alignment of a type whose memory is its wire form (no padding)
///   size, write, read
template <class T>
struct Codec;

/// How arithmetic values lie on the wire. bool is not plain: an invalid byte must not become a
/// bool.
template <class T>
struct Primitive {
  static constexpr size_t kMinimumSize = sizeof(T);
  static constexpr size_t kPlainAlignment = std::is_same_v<T, bool> ? 0 : sizeof(T);
};

template <class T>
using Layout = std::conditional_t<std::is_arithmetic_v<T>, Primitive<T>, Codec<T>>;

template <class T>
inline constexpr bool kIsPlain = Layout<T>::kPlainAlignment != 0;

inline constexpr size_t kNoBound = 0;

// ---- one value
// -----------------------------------------------------------------------------------

template <class T>
void size_value(CdrSizer& sizer, const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    sizer.add(sizeof(T), sizeof(T));
  } else if constexpr (Codec<T>::kPlainAlignment != 0) {
    sizer.add(sizeof(T), Codec<T>::kPlainAlignment);
  } else {
    Codec<T>::size(sizer, value);
  }
}

template <class T>
void write_value(CdrWriter& writer, const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    writer.put(value);
  } else if constexpr (Codec<T>::kPlainAlignment != 0) {
    writer.put_bytes(&value, sizeof(T), Codec<T>::kPlainAlignment);
  } else {
    Codec<T>::write(writer, value);
  }
}

template <class T>
void read_value(CdrReader& reader, T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    reader.get(value);
  } else {
    if constexpr (Codec<T>::kPlainAlignment != 0) {
      if (!reader.swapped()) {
        reader.get_bytes(static_cast<void*>(&value), sizeof(T), Codec<T>::kPlainAlignment);
        return;
      }
    }
    Codec<T>::read(reader, value);
  }
}

// ---- strings
// ------------------------------------------------------------------------------------- A string is
// its count with the final NUL, the bytes and the NUL. A wide string is its count and one 32-bit
// value for each UTF-16 unit, without a NUL, as the Fast DDS type support has it.

template <>
struct Codec<std::string> {
  static constexpr size_t kMinimumSize = 4;
  static constexpr size_t kPlainAlignment = 0;
};

template <>
struct Codec<std::u16string> {
  static constexpr size_t kMinimumSize = 4;
  static constexpr size_t kPlainAlignment = 0;
};

inline void size_string(CdrSizer& sizer, const std::string& value) {
  sizer.add(4, 4);
  sizer.add(value.size() + 1, 1);
}

inline void size_string(CdrSizer& sizer, const std::u16string& value) {
  sizer.add(4, 4);
  sizer.add(value.size() * 4, 1);
}

[[gnu::noinline]] inline void write_string(CdrWriter& writer, const std::string& value,
                                           size_t bound) {
  if (bound != kNoBound && value.size() > bound) {
    writer.fail();
    return;
  }
  writer.put_count(value.size() + 1);
  writer.put_bytes(value.c_str(), value.size() + 1, 1);
}

[[gnu::noinline]] inline void write_string(CdrWriter& writer, const std::u16string& value,
                                           size_t bound) {
  if (bound != kNoBound && value.size() > bound) {
    writer.fail();
    return;
  }
  writer.put_count(value.size());
  for (char16_t unit : value) {
    writer.put(static_cast<uint32_t>(unit));
  }
}

[[gnu::noinline]] inline void read_string(CdrReader& reader, std::string& value, size_t bound) {
  const size_t count = reader.get_count(bound == kNoBound ? kNoBound : bound + 1, 1);
  if (count == 0) {  // not what we write, but some writers send an empty string so
    value.clear();
    return;
  }
  const uint8_t* bytes = reader.take(count, 1);
  if (bytes == nullptr || bytes[count - 1] != 0) {
    reader.fail();
    return;
  }
  value.assign(reinterpret_cast<const char*>(bytes), count - 1);
}

[[gnu::noinline]] inline void read_string(CdrReader& reader, std::u16string& value, size_t bound) {
  const size_t count = reader.get_count(bound, 4);
  value.resize(count);
  for (size_t i = 0; i < count; ++i) {
    uint32_t unit = 0;
    reader.get(unit);
    if (unit > 0xFFFF) {
      reader.fail();
    }
    value[i] = static_cast<char16_t>(unit);
  }
}

// ---- elements: a fixed array, or a sequence behind its count
// ------------------------------------- `string_bound` is the bound of each element when elements
// are strings.

template <class T>
inline constexpr bool kIsString =
    std::is_same_v<T, std::string> || std::is_same_v<T, std::u16string>;

template <class T>
void size_elements(CdrSizer& sizer, const T* elements, size_t count) {
  if constexpr (kIsString<T>) {
    for (size_t i = 0; i < count; ++i) {
      size_string(sizer, elements[i]);
    }
  } else if constexpr (std::is_same_v<T, bool>) {
    sizer.add(count, 1);
  } else if constexpr (kIsPlain<T>) {
    if (count != 0) {
      sizer.add(count * sizeof(T), Layout<T>::kPlainAlignment);
    }
  } else {
    for (size_t i = 0; i < count; ++i) {
      size_value(sizer, elements[i]);
    }
  }
}

template <class T>
void write_elements(CdrWriter& writer, const T* elements, size_t count, size_t string_bound) {
  if constexpr (kIsString<T>) {
    for (size_t i = 0; i < count; ++i) {
      write_string(writer, elements[i], string_bound);
    }
  } else if constexpr (std::is_same_v<T, bool>) {
    writer.put_bytes(elements, count, 1);
  } else if constexpr (kIsPlain<T>) {
    if (count != 0) {
      writer.put_bytes(elements, count * sizeof(T), Layout<T>::kPlainAlignment);
    }
  } else {
    for (size_t i = 0; i < count && writer.ok(); ++i) {
      write_value(writer, elements[i]);
    }
  }
}

template <class T>
void read_elements(CdrReader& reader, T* elements, size_t count, size_t string_bound) {
  if constexpr (kIsPlain<T>) {
    if (count == 0) {
      return;
    }
    if (sizeof(T) == 1 || !reader.swapped()) {
      reader.get_bytes(static_cast<void*>(elements), count * sizeof(T), Layout<T>::kPlainAlignment);
      return;
    }
  }
  for (size_t i = 0; i < count && reader.ok(); ++i) {
    if constexpr (kIsString<T>) {
      read_string(reader, elements[i], string_bound);
    } else {
      read_value(reader, elements[i]);
    }
  }
}

/// The elements of a sequence in memory. BoundedVector's own data() cannot be called.
template <class Sequence>
auto elements_of(Sequence& sequence) {
  return sequence.size() == 0 ? nullptr : &sequence[0];
}

/// `Sequence` is std::vector or rosidl_runtime_cpp::BoundedVector; of bool, both pack bits.
template <class Sequence>
void size_sequence(CdrSizer& sizer, const Sequence& sequence) {
  sizer.add(4, 4);
  if constexpr (std::is_same_v<typename Sequence::value_type, bool>) {
    sizer.add(sequence.size(), 1);
  } else {
    size_elements(sizer, elements_of(sequence), sequence.size());
  }
}

template <class Sequence>
void write_sequence(CdrWriter& writer, const Sequence& sequence, size_t bound,
                    size_t string_bound) {
  const size_t count = sequence.size();
  if (bound != kNoBound && count > bound) {
    writer.fail();
    return;
  }
  writer.put_count(count);
  if constexpr (std::is_same_v<typename Sequence::value_type, bool>) {
    if (uint8_t* room = writer.claim(count, 1)) {
      for (size_t i = 0; i < count; ++i) {
        room[i] = sequence[i] ? 1 : 0;
      }
    }
  } else {
    write_elements(writer, elements_of(sequence), count, string_bound);
  }
}

template <class Sequence>
void read_sequence(CdrReader& reader, Sequence& sequence, size_t bound, size_t string_bound) {
  using Element = typename Sequence::value_type;
  const size_t count = reader.get_count(bound, Layout<Element>::kMinimumSize);
  if constexpr (std::is_same_v<Element, bool>) {
    const uint8_t* bytes = reader.take(count, 1);
    if (bytes != nullptr) {
      sequence.resize(count);
      for (size_t i = 0; i < count; ++i) {
        sequence[i] = bytes[i] != 0;
      }
    }
  } else if constexpr (std::is_integral_v<Element> && sizeof(Element) == 1) {
    // Images and point clouds: written once, not zeroed before.
    const auto* bytes = reinterpret_cast<const Element*>(reader.take(count, 1));
    if (bytes != nullptr) {
      sequence.assign(bytes, bytes + count);
    }
  } else {
    sequence.resize(count);
    read_elements(reader, elements_of(sequence), count, string_bound);
  }
}

}  // namespace ros2wasm_typesupport
