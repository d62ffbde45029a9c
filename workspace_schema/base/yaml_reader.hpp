// YAML as a plain tree with places. The YAML library ends in yaml_reader.cpp. One document, string
// keys, bounded size, depth and aliases; nothing is typed here (see yaml_scalar.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/source_text.hpp"

namespace ros2wasm {

struct YamlEntry;

enum class YamlKind { kNull, kScalar, kSequence, kMap };

/// A place in the text, in bytes. Spans are made of it on demand: most nodes never need one.
struct TextRange {
  std::size_t offset = 0;
  std::size_t length = 0;
};

struct YamlNode {
  YamlKind kind = YamlKind::kNull;
  TextRange range;  ///< a scalar: with its quotes; a sequence: its first mark; a map: its first key
  bool written = false;  ///< a null: `~` or `null` stands there, not nothing
  bool quoted = false;   ///< a scalar: in quotes or a block
  bool verbatim =
      false;  ///< a scalar: `text` stands in the file byte for byte, from `text_offset` on
  std::size_t text_offset = 0;
  std::string tag;                 ///< explicit tag, such as "tag:yaml.org,2002:str"; else empty
  std::string text;                ///< a scalar's content
  std::vector<YamlNode> items;     ///< of a sequence
  std::vector<YamlEntry> entries;  ///< of a map, in the order of the file, keys unique
};

struct YamlEntry {
  std::string key;
  TextRange key_range;
  YamlNode value;
};

struct YamlDocument {
  YamlNode root;
  Diagnostics problems;  ///< duplicate keys (R2W0105): the first entry counts, reading goes on
};

/// The meaning of a key that is twice in a mapping. kLastCounts follows most readers and reports no
/// problem.
enum class DuplicateKeys { kFirstCounts, kLastCounts };

/// R2W0101 not YAML, R2W0111 a text that is not read at all (encoding, size, depth, too many
/// nodes).
[[nodiscard]] Outcome<YamlDocument> parse_yaml(
    const SourceText& source, DuplicateKeys duplicates = DuplicateKeys::kFirstCounts);

}  // namespace ros2wasm
