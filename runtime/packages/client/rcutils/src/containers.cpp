// Lists and maps of rcutils.
#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rcutils/error_handling.h"
#include "rcutils/types/array_list.h"
#include "rcutils/types/hash_map.h"
#include "rcutils/types/string_map.h"

// Values of one size, one after the other.
struct rcutils_array_list_impl_s {
  std::vector<unsigned char> bytes;
  size_t data_size;
};

namespace {

using Bytes = std::vector<unsigned char>;

struct Hash {
  rcutils_hash_map_key_hasher_t function;
  size_t operator()(const Bytes& key) const { return function(key.data()); }
};
struct Equal {
  rcutils_hash_map_key_cmp_t function;
  bool operator()(const Bytes& a, const Bytes& b) const {
    return function(a.data(), b.data()) == 0;
  }
};

rcutils_ret_t refuse(const char* reason, rcutils_ret_t code) {
  rcutils_set_error_state(reason, __FILE__, __LINE__);
  return code;
}

Bytes bytes_of(const void* from, size_t size) {
  const auto* const first = static_cast<const unsigned char*>(from);
  return Bytes(first, first + size);
}

rcutils_ret_t check_list(const rcutils_array_list_t* list) {
  if (list == nullptr) {
    return refuse("array_list argument is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  return list->impl == nullptr
             ? refuse("array_list is not initialized", RCUTILS_RET_NOT_INITIALIZED)
             : RCUTILS_RET_OK;
}

rcutils_ret_t check_index(const rcutils_array_list_t* list, size_t index) {
  const rcutils_ret_t result = check_list(list);
  if (result == RCUTILS_RET_OK && index >= list->impl->bytes.size() / list->impl->data_size) {
    return refuse("index is out of bounds of the list", RCUTILS_RET_INVALID_ARGUMENT);
  }
  return result;
}

}  // namespace

struct rcutils_hash_map_impl_s {
  size_t key_size;
  size_t data_size;
  std::unordered_map<Bytes, Bytes, Hash, Equal> entries;
};

// In the order in which keys came; `capacity` is what reserve and set make of it.
struct rcutils_string_map_impl_s {
  std::vector<std::pair<std::string, std::string>> entries;
  size_t capacity;
};

namespace {

rcutils_ret_t check_map(const rcutils_hash_map_t* map) {
  if (map == nullptr) {
    return refuse("map argument is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  return map->impl == nullptr ? refuse("map is not initialized", RCUTILS_RET_NOT_INITIALIZED)
                              : RCUTILS_RET_OK;
}

rcutils_ret_t check_string_map(const rcutils_string_map_t* map, rcutils_ret_t without_impl) {
  if (map == nullptr) {
    return refuse("string_map argument is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  return map->impl == nullptr ? refuse("invalid string map", without_impl) : RCUTILS_RET_OK;
}

auto find_key(const rcutils_string_map_t* map, const std::string& key) {
  auto& entries = map->impl->entries;
  return std::find_if(entries.begin(), entries.end(),
                      [&](const auto& entry) { return entry.first == key; });
}

const char* find_value(const rcutils_string_map_t* map, const std::string& key) {
  if (map == nullptr || map->impl == nullptr) {
    return nullptr;
  }
  const auto found = find_key(map, key);
  return found == map->impl->entries.end() ? nullptr : found->second.c_str();
}

}  // namespace

extern "C" {

rcutils_array_list_t rcutils_get_zero_initialized_array_list(void) {
  return {nullptr};
}

rcutils_ret_t rcutils_array_list_init(rcutils_array_list_t* array_list, size_t initial_capacity,
                                      size_t data_size, const rcutils_allocator_t* allocator) {
  if (array_list == nullptr || !rcutils_allocator_is_valid(allocator)) {
    return refuse("array_list or its allocator is invalid", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (initial_capacity == 0 || data_size == 0) {
    return refuse("initial_capacity and data_size cannot be 0", RCUTILS_RET_INVALID_ARGUMENT);
  }
  array_list->impl = new rcutils_array_list_impl_s{{}, data_size};
  array_list->impl->bytes.reserve(initial_capacity * data_size);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_array_list_fini(rcutils_array_list_t* array_list) {
  const rcutils_ret_t result = check_list(array_list);
  if (result == RCUTILS_RET_OK) {
    delete array_list->impl;
    array_list->impl = nullptr;
  }
  return result;
}

rcutils_ret_t rcutils_array_list_add(rcutils_array_list_t* array_list, const void* data) {
  const rcutils_ret_t result = check_list(array_list);
  if (result != RCUTILS_RET_OK || data == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("data is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const Bytes bytes = bytes_of(data, array_list->impl->data_size);
  array_list->impl->bytes.insert(array_list->impl->bytes.end(), bytes.begin(), bytes.end());
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_array_list_set(rcutils_array_list_t* array_list, size_t index,
                                     const void* data) {
  const rcutils_ret_t result = check_index(array_list, index);
  if (result != RCUTILS_RET_OK || data == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("data is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const size_t size = array_list->impl->data_size;
  std::memcpy(array_list->impl->bytes.data() + index * size, data, size);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_array_list_remove(rcutils_array_list_t* array_list, size_t index) {
  const rcutils_ret_t result = check_index(array_list, index);
  if (result == RCUTILS_RET_OK) {
    const auto size = static_cast<ptrdiff_t>(array_list->impl->data_size);
    const auto first = array_list->impl->bytes.begin() + static_cast<ptrdiff_t>(index) * size;
    array_list->impl->bytes.erase(first, first + size);
  }
  return result;
}

rcutils_ret_t rcutils_array_list_get(const rcutils_array_list_t* array_list, size_t index,
                                     void* data) {
  const rcutils_ret_t result = check_index(array_list, index);
  if (result != RCUTILS_RET_OK || data == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("data is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const size_t size = array_list->impl->data_size;
  std::memcpy(data, array_list->impl->bytes.data() + index * size, size);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_array_list_get_size(const rcutils_array_list_t* array_list, size_t* size) {
  const rcutils_ret_t result = check_list(array_list);
  if (result != RCUTILS_RET_OK || size == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("size is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *size = array_list->impl->bytes.size() / array_list->impl->data_size;
  return RCUTILS_RET_OK;
}

/* FNV-1a of the string that the key points to. */
size_t rcutils_hash_map_string_hash_func(const void* key_str) {
  size_t hash = 2166136261u;
  for (const char* text = *static_cast<const char* const*>(key_str); *text != '\0'; ++text) {
    hash = (hash ^ static_cast<unsigned char>(*text)) * 16777619u;
  }
  return hash;
}

int rcutils_hash_map_string_cmp_func(const void* left, const void* right) {
  return std::strcmp(*static_cast<const char* const*>(left),
                     *static_cast<const char* const*>(right));
}

rcutils_hash_map_t rcutils_get_zero_initialized_hash_map() {
  return {nullptr};
}

rcutils_ret_t rcutils_hash_map_init(rcutils_hash_map_t* hash_map, size_t initial_capacity,
                                    size_t key_size, size_t data_size,
                                    rcutils_hash_map_key_hasher_t key_hashing_func,
                                    rcutils_hash_map_key_cmp_t key_cmp_func,
                                    const rcutils_allocator_t* allocator) {
  if (hash_map == nullptr || key_hashing_func == nullptr || key_cmp_func == nullptr ||
      !rcutils_allocator_is_valid(allocator)) {
    return refuse("an argument of rcutils_hash_map_init is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (initial_capacity == 0 || key_size == 0 || data_size == 0) {
    return refuse("initial_capacity, key_size and data_size cannot be 0",
                  RCUTILS_RET_INVALID_ARGUMENT);
  }
  hash_map->impl = new rcutils_hash_map_impl_s{
      key_size, data_size,
      std::unordered_map<Bytes, Bytes, Hash, Equal>(initial_capacity, Hash{key_hashing_func},
                                                    Equal{key_cmp_func})};
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_hash_map_fini(rcutils_hash_map_t* hash_map) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result == RCUTILS_RET_OK) {
    delete hash_map->impl;
    hash_map->impl = nullptr;
  }
  return result;
}

rcutils_ret_t rcutils_hash_map_get_capacity(const rcutils_hash_map_t* hash_map, size_t* capacity) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || capacity == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("capacity is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *capacity = hash_map->impl->entries.bucket_count();
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_hash_map_get_size(const rcutils_hash_map_t* hash_map, size_t* size) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || size == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("size is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *size = hash_map->impl->entries.size();
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_hash_map_set(rcutils_hash_map_t* hash_map, const void* key,
                                   const void* value) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || key == nullptr || value == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("key or value is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  hash_map->impl->entries[bytes_of(key, hash_map->impl->key_size)] =
      bytes_of(value, hash_map->impl->data_size);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_hash_map_unset(rcutils_hash_map_t* hash_map, const void* key) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || key == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("key is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  hash_map->impl->entries.erase(bytes_of(key, hash_map->impl->key_size));
  return RCUTILS_RET_OK;
}

bool rcutils_hash_map_key_exists(const rcutils_hash_map_t* hash_map, const void* key) {
  return hash_map != nullptr && hash_map->impl != nullptr && key != nullptr &&
         hash_map->impl->entries.count(bytes_of(key, hash_map->impl->key_size)) != 0;
}

rcutils_ret_t rcutils_hash_map_get(const rcutils_hash_map_t* hash_map, const void* key,
                                   void* data) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || key == nullptr || data == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("key or data is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const auto found = hash_map->impl->entries.find(bytes_of(key, hash_map->impl->key_size));
  if (found == hash_map->impl->entries.end()) {
    return RCUTILS_RET_NOT_FOUND;
  }
  std::memcpy(data, found->second.data(), found->second.size());
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_hash_map_get_next_key_and_data(const rcutils_hash_map_t* hash_map,
                                                     const void* previous_key, void* key,
                                                     void* data) {
  const rcutils_ret_t result = check_map(hash_map);
  if (result != RCUTILS_RET_OK || key == nullptr || data == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("key or data is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const auto& entries = hash_map->impl->entries;
  auto next = entries.begin();
  if (previous_key != nullptr) {
    next = entries.find(bytes_of(previous_key, hash_map->impl->key_size));
    if (next == entries.end()) {
      return RCUTILS_RET_NOT_FOUND;
    }
    ++next;
  }
  if (next == entries.end()) {
    return RCUTILS_RET_HASH_MAP_NO_MORE_ENTRIES;
  }
  std::memcpy(key, next->first.data(), next->first.size());
  std::memcpy(data, next->second.data(), next->second.size());
  return RCUTILS_RET_OK;
}

rcutils_string_map_t rcutils_get_zero_initialized_string_map() {
  return {nullptr};
}

rcutils_ret_t rcutils_string_map_init(rcutils_string_map_t* string_map, size_t initial_capacity,
                                      rcutils_allocator_t allocator) {
  if (string_map == nullptr || !rcutils_allocator_is_valid(&allocator)) {
    return refuse("string_map or its allocator is invalid", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (string_map->impl != nullptr) {
    return refuse("string_map already initialized", RCUTILS_RET_STRING_MAP_ALREADY_INIT);
  }
  string_map->impl = new rcutils_string_map_impl_s{{}, initial_capacity};
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_map_fini(rcutils_string_map_t* string_map) {
  if (string_map == nullptr) {
    return refuse("string_map argument is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  delete string_map->impl;
  string_map->impl = nullptr;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_map_get_capacity(const rcutils_string_map_t* string_map,
                                              size_t* capacity) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result != RCUTILS_RET_OK || capacity == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("capacity is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *capacity = string_map->impl->capacity;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_map_get_size(const rcutils_string_map_t* string_map, size_t* size) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result != RCUTILS_RET_OK || size == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("size is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *size = string_map->impl->entries.size();
  return RCUTILS_RET_OK;
}

/* Not below what the map holds. */
rcutils_ret_t rcutils_string_map_reserve(rcutils_string_map_t* string_map, size_t capacity) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result == RCUTILS_RET_OK) {
    string_map->impl->capacity = std::max(capacity, string_map->impl->entries.size());
  }
  return result;
}

rcutils_ret_t rcutils_string_map_clear(rcutils_string_map_t* string_map) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result == RCUTILS_RET_OK) {
    string_map->impl->entries.clear();
  }
  return result;
}

rcutils_ret_t rcutils_string_map_set_no_resize(rcutils_string_map_t* string_map, const char* key,
                                               const char* value) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result != RCUTILS_RET_OK || key == nullptr || value == nullptr) {
    return result != RCUTILS_RET_OK ? result
                                    : refuse("key or value is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const auto found = find_key(string_map, key);
  if (found != string_map->impl->entries.end()) {
    found->second = value;
  } else if (string_map->impl->entries.size() >= string_map->impl->capacity) {
    return RCUTILS_RET_NOT_ENOUGH_SPACE;
  } else {
    string_map->impl->entries.emplace_back(key, value);
  }
  return RCUTILS_RET_OK;
}

/* The capacity doubles when it is reached. */
rcutils_ret_t rcutils_string_map_set(rcutils_string_map_t* string_map, const char* key,
                                     const char* value) {
  const rcutils_ret_t result = rcutils_string_map_set_no_resize(string_map, key, value);
  if (result != RCUTILS_RET_NOT_ENOUGH_SPACE) {
    return result;
  }
  string_map->impl->capacity = std::max<size_t>(1, 2 * string_map->impl->capacity);
  return rcutils_string_map_set_no_resize(string_map, key, value);
}

rcutils_ret_t rcutils_string_map_unset(rcutils_string_map_t* string_map, const char* key) {
  const rcutils_ret_t result = check_string_map(string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result != RCUTILS_RET_OK || key == nullptr) {
    return result != RCUTILS_RET_OK ? result : refuse("key is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const auto found = find_key(string_map, key);
  if (found == string_map->impl->entries.end()) {
    return refuse("key not found", RCUTILS_RET_STRING_KEY_NOT_FOUND);
  }
  string_map->impl->entries.erase(found);
  return RCUTILS_RET_OK;
}

bool rcutils_string_map_key_exists(const rcutils_string_map_t* string_map, const char* key) {
  return key != nullptr && find_value(string_map, key) != nullptr;
}

bool rcutils_string_map_key_existsn(const rcutils_string_map_t* string_map, const char* key,
                                    size_t key_length) {
  return rcutils_string_map_getn(string_map, key, key_length) != nullptr;
}

const char* rcutils_string_map_get(const rcutils_string_map_t* string_map, const char* key) {
  return key == nullptr ? nullptr : find_value(string_map, key);
}

const char* rcutils_string_map_getn(const rcutils_string_map_t* string_map, const char* key,
                                    size_t key_length) {
  return key == nullptr ? nullptr
                        : find_value(string_map, std::string(key, strnlen(key, key_length)));
}

/* By the address of the key before, as it was handed out. */
const char* rcutils_string_map_get_next_key(const rcutils_string_map_t* string_map,
                                            const char* key) {
  if (string_map == nullptr || string_map->impl == nullptr) {
    return nullptr;
  }
  const auto& entries = string_map->impl->entries;
  auto next = entries.begin();
  if (key != nullptr) {
    next = std::find_if(entries.begin(), entries.end(),
                        [&](const auto& entry) { return entry.first.c_str() == key; });
    if (next != entries.end()) {
      ++next;
    }
  }
  return next == entries.end() ? nullptr : next->first.c_str();
}

rcutils_ret_t rcutils_string_map_copy(const rcutils_string_map_t* src_string_map,
                                      rcutils_string_map_t* dst_string_map) {
  rcutils_ret_t result = check_string_map(src_string_map, RCUTILS_RET_STRING_MAP_INVALID);
  if (result == RCUTILS_RET_OK) {
    result = check_string_map(dst_string_map, RCUTILS_RET_STRING_MAP_INVALID);
  }
  if (result != RCUTILS_RET_OK) {
    return result;
  }
  for (const auto& [key, value] : src_string_map->impl->entries) {
    result = rcutils_string_map_set(dst_string_map, key.c_str(), value.c_str());
    if (result != RCUTILS_RET_OK) {
      return result;
    }
  }
  return RCUTILS_RET_OK;
}

}  // extern "C"
