// See cached_index.hpp.
#include "bundler/channel/cached_index.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

// The number at the end changes with the form of these files.
constexpr std::array<char, 16> kMagic{'r', '2', 'w', '-', 'i', 'n', 'd',  'e',
                                      'x', '-', '0', '0', '0', '1', '\n', '\0'};

struct Header {
  std::array<char, 16> magic = kMagic;
  std::uint64_t source_size = 0;
  std::int64_t source_modified_ns = 0;
  std::uint64_t source_inode = 0;
  std::uint64_t text_size = 0;
  std::uint64_t table_size = 0;
  std::uint64_t table_hash = 0;
  std::uint64_t header_hash = 0;  ///< of all before it
};
static_assert(sizeof(Header) <= kKeptHeaderSize);

/// The table begins with this; then come the entries, the spans, the names, info, removed.
struct TableHead {
  std::uint64_t entries = 0;
  std::uint64_t spans = 0;
  std::uint64_t names_size = 0;
  std::uint64_t info_size = 0;
  std::uint64_t removed_size = 0;
};

/// A name and where its spans are.
struct Entry {
  std::uint32_t name_at = 0;
  std::uint32_t name_size = 0;
  std::uint32_t first_span = 0;
  std::uint32_t span_count = 0;
};

struct StoredSpan {
  std::uint64_t offset = 0;  ///< in the text
  std::uint32_t length = 0;
  std::uint32_t conda = 0;
  std::uint64_t hash = 0;
};

/// Finds accidents, not attacks: eight bytes a step.
std::uint64_t hash_of(std::string_view bytes) {
  constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15ULL;
  std::uint64_t hash = bytes.size() * kFactor;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * kFactor;
    hash ^= hash >> 29U;
  };
  while (bytes.size() >= 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), 8);
    mix(word);
    bytes.remove_prefix(8);
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes.data(), bytes.size());
  mix(rest);
  return hash;
}

template <typename T>
void append_to(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));  // NOLINT: plain data
}

template <typename T>
T value_at(std::string_view bytes, std::size_t index) {
  T value;
  std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
  return value;
}

/// The next `size` bytes of `bytes`, which are taken off; false when there are fewer.
bool take(std::string_view& bytes, std::uint64_t size, std::string_view& part) {
  if (size > bytes.size()) return false;
  part = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return true;
}

}  // namespace

void KeptTable::add(const FoundRecord& found) {
  spans_[ascii_lower(found.name)].push_back(
      {.offset = found.offset,
       .length = static_cast<std::uint32_t>(found.text.size()),
       .conda = found.conda ? 1U : 0U,
       .hash = hash_of(found.text)});
}

std::string KeptTable::bytes(std::string_view info, std::string_view removed) const {
  std::vector<const std::pair<const std::string, std::vector<Span>>*> sorted;
  sorted.reserve(spans_.size());
  for (const auto& one : spans_) sorted.push_back(&one);
  std::sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->first < b->first; });
  std::string entries;
  std::string spans;
  std::string names;
  std::uint32_t count = 0;
  for (const auto* one : sorted) {
    append_to(entries, Entry{.name_at = static_cast<std::uint32_t>(names.size()),
                             .name_size = static_cast<std::uint32_t>(one->first.size()),
                             .first_span = count,
                             .span_count = static_cast<std::uint32_t>(one->second.size())});
    names += one->first;
    for (const Span& span : one->second) {
      append_to(spans, StoredSpan{span.offset, span.length, span.conda, span.hash});
      ++count;
    }
  }
  std::string table;
  append_to(table, TableHead{.entries = sorted.size(),
                             .spans = count,
                             .names_size = names.size(),
                             .info_size = info.size(),
                             .removed_size = removed.size()});
  table.append(entries).append(spans).append(names).append(info).append(removed);
  return table;
}

std::string kept_header(const FileIdentity& source, std::uint64_t text_size,
                        std::string_view table) {
  Header header;
  header.source_size = source.size;
  header.source_modified_ns = source.modified_ns;
  header.source_inode = source.inode;
  header.text_size = text_size;
  header.table_size = table.size();
  header.table_hash = hash_of(table);
  std::string bytes;
  append_to(bytes, header);
  header.header_hash = hash_of(std::string_view(bytes).substr(0, offsetof(Header, header_hash)));
  bytes.clear();
  append_to(bytes, header);
  bytes.resize(kKeptHeaderSize, '\0');
  return bytes;
}

std::optional<FileIdentity> kept_source(std::string_view bytes) {
  if (bytes.size() < kKeptHeaderSize) return std::nullopt;
  const auto header = value_at<Header>(bytes, 0);
  if (header.magic != kMagic ||
      header.header_hash != hash_of(bytes.substr(0, offsetof(Header, header_hash)))) {
    return std::nullopt;
  }
  return FileIdentity{header.source_size, header.source_modified_ns, header.source_inode};
}

std::optional<KeptIndex> KeptIndex::open(std::string_view bytes, const FileIdentity& source) {
  std::string_view front;
  const auto made_from = kept_source(bytes);
  if (!made_from || *made_from != source || !take(bytes, kKeptHeaderSize, front))
    return std::nullopt;
  const auto header = value_at<Header>(front, 0);
  KeptIndex index;
  std::string_view table;
  if (!take(bytes, header.text_size, index.text_) || !take(bytes, header.table_size, table) ||
      !bytes.empty() || hash_of(table) != header.table_hash || table.size() < sizeof(TableHead)) {
    return std::nullopt;
  }
  const auto head = value_at<TableHead>(table, 0);
  table.remove_prefix(sizeof(TableHead));
  std::string_view names;
  if (!take(table, head.entries * sizeof(Entry), index.entries_) ||
      !take(table, head.spans * sizeof(StoredSpan), index.spans_) ||
      !take(table, head.names_size, names) || !take(table, head.info_size, index.info_) ||
      !take(table, head.removed_size, index.removed_)) {
    return std::nullopt;
  }
  index.names_.reserve(head.entries);
  for (std::size_t i = 0; i < head.entries; ++i) {
    const auto entry = value_at<Entry>(index.entries_, i);
    index.names_.push_back(names.substr(entry.name_at, entry.name_size));
  }
  return index;
}

std::optional<std::vector<KeptIndex::Record>> KeptIndex::records(std::size_t name) const {
  const auto entry = value_at<Entry>(entries_, name);
  std::vector<Record> records;
  records.reserve(entry.span_count);
  for (std::uint32_t i = 0; i < entry.span_count; ++i) {
    const auto span = value_at<StoredSpan>(spans_, entry.first_span + i);
    if (span.offset > text_.size() || span.length > text_.size() - span.offset) return std::nullopt;
    const std::string_view text = text_.substr(span.offset, span.length);
    if (hash_of(text) != span.hash) return std::nullopt;
    records.push_back({.text = text, .conda = span.conda != 0});
  }
  return records;
}

}  // namespace ros2wasm
