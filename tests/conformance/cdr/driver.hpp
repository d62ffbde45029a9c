// The parts of the conformance driver that are the same for every type: pseudo-random filling and
// printing as JSON, through tables of members that generated code (see make_driver.py) supplies.
// Tables instead of templates over whole messages: 300 types compile in seconds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "ros2wasm_typesupport/message_callbacks.hpp"
#include "rosidl_runtime_cpp/bounded_vector.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace driver {

/// SplitMix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next();
  size_t below(size_t limit) { return static_cast<size_t>(next() % limit); }

 private:
  uint64_t state_;
};

/// The operations on a value of some type. `bound` is that of the string type, 0 for none.
struct Operations {
  void (*fill)(void* value, Random& random, size_t bound);
  void (*print)(const void* value, std::string& json);
};

/// One member of a message.
struct MemberRow {
  const char* name;
  size_t offset;
  const Operations* operations;
  size_t string_bound;
};

/// All members of a message, in a table that lives for ever.
struct MemberRows {
  const MemberRow* first;
  size_t count;
};

/// Generated for each message: `static MemberRows rows();`
template <class T>
struct Members;

constexpr size_t kLongestSequence = 4;

// Values that survive a trip through JSON text. Integers of 64 bits are printed as strings.
void fill_bool(bool& value, Random& random);
void fill_string(std::string& value, Random& random, size_t bound);
void fill_string(std::u16string& value, Random& random, size_t bound);
int32_t fill_sixty_fourths(Random& random);
void fill_members(MemberRows rows, void* message, Random& random);
void print_double(double value, std::string& json);
void print_string(const std::string& value, std::string& json);
void print_string(const std::u16string& value, std::string& json);
void print_members(MemberRows rows, const void* message, std::string& json);

template <class T>
inline constexpr size_t kSequenceBound = 0;
template <class T, size_t N, class A>
inline constexpr size_t kSequenceBound<rosidl_runtime_cpp::BoundedVector<T, N, A>> = N;

template <class T>
inline constexpr bool kIsArray = false;
template <class T, size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;

template <class T>
inline constexpr bool kIsSequence = false;
template <class T, class A>
inline constexpr bool kIsSequence<std::vector<T, A>> = true;
template <class T, size_t N, class A>
inline constexpr bool kIsSequence<rosidl_runtime_cpp::BoundedVector<T, N, A>> = true;

/// The elements of vector<bool> are bits, of which there are copies only.
template <class T>
inline constexpr bool kHasBits = std::is_same_v<typename T::value_type, bool>&& kIsSequence<T>;

template <class T>
void fill(void* place, Random& random, size_t bound) {
  T& value = *static_cast<T*>(place);
  if constexpr (std::is_same_v<T, bool>) {
    fill_bool(value, random);
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(fill_sixty_fourths(random)) / 64;
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = static_cast<T>(random.next());
  } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::u16string>) {
    fill_string(value, random, bound);
  } else if constexpr (kIsSequence<T> || kIsArray<T>) {
    if constexpr (kIsSequence<T>) {
      constexpr size_t kBound = kSequenceBound<T>;
      value.resize(
          random.below((kBound != 0 && kBound < kLongestSequence ? kBound : kLongestSequence) + 1));
    }
    for (size_t i = 0; i < value.size(); ++i) {
      if constexpr (kHasBits<T>) {
        bool bit = false;
        fill_bool(bit, random);
        value[i] = bit;
      } else {
        fill<typename T::value_type>(&value[i], random, bound);
      }
    }
  } else {
    fill_members(Members<T>::rows(), place, random);
  }
}

template <class T>
void print(const void* place, std::string& json) {
  const T& value = *static_cast<const T*>(place);
  if constexpr (std::is_same_v<T, bool>) {
    json += value ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    print_double(static_cast<double>(value), json);
  } else if constexpr (std::is_arithmetic_v<T>) {
    json += sizeof(T) == 8 ? '"' + std::to_string(value) + '"' : std::to_string(value);
  } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::u16string>) {
    print_string(value, json);
  } else if constexpr (kIsSequence<T> || kIsArray<T>) {
    json += '[';
    for (size_t i = 0; i < value.size(); ++i) {
      if (i != 0) json += ',';
      if constexpr (kHasBits<T>) {
        const bool bit = value[i];
        print<bool>(&bit, json);
      } else {
        print<typename T::value_type>(&value[i], json);
      }
    }
    json += ']';
  } else {
    print_members(Members<T>::rows(), place, json);
  }
}

template <class T>
inline constexpr Operations kOperations{&fill<T>, &print<T>};

/// One message type: what the driver can do with it, without knowing it.
struct TypeRow {
  const rosidl_message_type_support_t* (*handle)();
  void* (*allocate)();
  void (*free)(void* message);
  const Operations* operations;

  std::shared_ptr<void> create() const { return {allocate(), free}; }

  const ros2wasm_typesupport::MessageCallbacks* callbacks() const {
    return static_cast<const ros2wasm_typesupport::MessageCallbacks*>(handle()->data);
  }
};

template <class T>
void* allocate() {
  return new T();
}

template <class T>
void free_message(void* message) {
  delete static_cast<T*>(message);
}

template <class T>
TypeRow row() {
  return {&rosidl_typesupport_cpp::get_message_type_support_handle<T>, &allocate<T>,
          &free_message<T>, &kOperations<T>};
}

/// Generated: all types, sorted by name.
std::vector<TypeRow> all_types();

}  // namespace driver
