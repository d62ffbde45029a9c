// See yaml_reader.hpp. yaml-cpp is known here only, and only its events: they carry byte positions.
// First the events are recorded, then the tree is built from them, with the text at hand to find
// what the events leave out (lengths, whether an empty value is empty).
#include "workspace_schema/base/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "workspace_schema/base/long_yaml.hpp"
#include "workspace_schema/base/text_encoding.hpp"
#include "workspace_schema/base/yaml_syntax_hint.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLargestText = 1U << 20U;
constexpr std::size_t kMostNodes = 50'000;
constexpr std::size_t kMostNodesOfLists = 500'000;
constexpr int kDeepest = 48;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

enum class EventKind { kNull, kAlias, kScalar, kSequence, kMap, kEnd };

struct Event {
  EventKind kind = EventKind::kEnd;
  std::size_t offset = 0;
  std::size_t anchor = 0;  ///< 0: none
  std::string tag;         ///< "?" plain, "!" quoted or block, else explicit
  std::string value;
};

/// Ends the library's parsing from inside its callbacks; caught in record_events().
struct LimitReached {
  std::string what;
  std::size_t offset;
};

class Recorder final : public YAML::EventHandler {
 public:
  explicit Recorder(std::size_t skipped, std::size_t most_nodes = kMostNodes)
      : skipped_(skipped), most_nodes_(most_nodes) {}

  std::vector<Event> events;
  std::size_t document_offset = 0;

  void OnDocumentStart(const YAML::Mark& mark) override { document_offset = offset_of(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(EventKind::kNull, mark, anchor, "?", {});
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(EventKind::kAlias, mark, anchor, {}, {});
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    add(EventKind::kScalar, mark, anchor, tag, value);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(EventKind::kSequence, mark, anchor, tag);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(EventKind::kMap, mark, anchor, tag);
  }
  void OnMapEnd() override { close(); }

 private:
  [[nodiscard]] std::size_t offset_of(const YAML::Mark& mark) const {
    return skipped_ + static_cast<std::size_t>(std::max(0, mark.pos));
  }

  void add(EventKind kind, const YAML::Mark& mark, YAML::anchor_t anchor, const std::string& tag,
           const std::string& value) {
    if (events.size() >= 2 * most_nodes_)
      throw LimitReached{"it has too many values", offset_of(mark)};
    events.push_back(
        {.kind = kind, .offset = offset_of(mark), .anchor = anchor, .tag = tag, .value = value});
  }

  void open(EventKind kind, const YAML::Mark& mark, YAML::anchor_t anchor, const std::string& tag) {
    if (++depth_ > kDeepest) throw LimitReached{"it is nested too deeply", offset_of(mark)};
    add(kind, mark, anchor, tag, {});
  }

  void close() {
    --depth_;
    events.push_back({});
  }

  std::size_t skipped_;
  std::size_t most_nodes_;
  int depth_ = 0;
};

Diagnostic unreadable(const SourceText& source, std::string what, TextRange at,
                      std::string label = {}) {
  return Diagnostic{.code = "R2W0111",
                    .message = "`" + source.file() + "` cannot be read: " + std::move(what),
                    .span = source.span(at.offset, at.length),
                    .label = std::move(label)};
}

Diagnostic not_yaml(const SourceText& source, std::string message, TextRange at,
                    std::string label = {}) {
  return Diagnostic{.code = "R2W0101",
                    .message = std::move(message),
                    .span = source.span(at.offset, at.length),
                    .label = std::move(label)};
}

/// Texts that the library would misread or that hide something from the eye.
std::optional<Diagnostic> encoding_problem(const SourceText& source) {
  const std::string_view text = source.text();
  if (text.size() > kLargestText) return unreadable(source, "it is larger than 1 MiB", {});
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    Diagnostic problem = unreadable(source, "it is UTF-16", {});
    problem.why.push_back("the file begins with the byte order mark of UTF-16; only UTF-8 is read");
    problem.span->line_text.clear();
    return problem;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool lone_return = byte == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    if (byte == 0) return unreadable(source, "it holds a NUL byte", {i, 1}, "a NUL byte");
    if (lone_return)
      return unreadable(source, "it holds a lone carriage return", {i, 1}, "a carriage return");
    if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F) {
      return unreadable(source, "it holds a control character", {i, 1}, "a control character");
    }
  }
  if (const auto bad = first_invalid_utf8(text)) {
    return unreadable(source, "it is not UTF-8", {*bad, 1}, "this byte is not UTF-8");
  }
  return std::nullopt;
}

struct RecordedEvents {
  std::vector<Event> events;
  std::optional<std::size_t> second_document;  ///< its offset
};

std::size_t skipped_bytes(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

/// For the hints: where a changed text fails.
std::size_t first_error_of(std::string_view text) {
  const std::size_t skipped = skipped_bytes(text);
  std::istringstream stream{std::string(text.substr(skipped))};
  Recorder recorder(skipped);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(recorder);
    return parser.HandleNextDocument(recorder) ? recorder.document_offset : std::string_view::npos;
  } catch (const LimitReached& limit) {
    return limit.offset;
  } catch (const YAML::Exception& raised) {
    return skipped + static_cast<std::size_t>(std::max(0, raised.mark.pos));
  }
}

Outcome<RecordedEvents> record_events(const SourceText& source, std::size_t most_nodes) {
  const std::size_t skipped = skipped_bytes(source.text());
  std::istringstream stream{std::string(source.text().substr(skipped))};
  Recorder recorder(skipped, most_nodes);
  RecordedEvents recorded;
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(recorder)) return recorded;
    recorded.events = recorder.events;
    if (parser.HandleNextDocument(recorder)) recorded.second_document = recorder.document_offset;
    return recorded;
  } catch (const LimitReached& limit) {
    return unreadable(source, limit.what, {limit.offset, 1});
  } catch (const YAML::Exception& raised) {
    const std::size_t offset = skipped + static_cast<std::size_t>(std::max(0, raised.mark.pos));
    return yaml_syntax_error(
        source, {.message = raised.msg, .offset = std::min(offset, source.text().size())},
        first_error_of);
  } catch (const std::exception& raised) {
    return not_yaml(source, "this is not YAML: " + std::string(raised.what()), {});
  }
}

class TreeBuilder {
 public:
  TreeBuilder(const SourceText& source, const std::vector<Event>& events, DuplicateKeys duplicates,
              std::size_t most_nodes)
      : source_(source),
        text_(source.text()),
        events_(events),
        duplicates_(duplicates),
        most_nodes_(most_nodes) {}

  Outcome<YamlDocument> build() {
    YamlDocument document;
    document.root = node({});
    if (fatal_) return *std::move(fatal_);
    document.problems = std::move(problems_);
    return document;
  }

 private:
  /// `empty_at`: where a value that is not there should have been.
  YamlNode node(TextRange empty_at) {
    if (fatal_ || at_ >= events_.size()) return {};
    if (++count_ > most_nodes_) {
      fatal_ = unreadable(source_, "it has too many values", {events_[at_].offset, 1});
      return {};
    }
    const Event& event = events_[at_++];
    YamlNode built;
    switch (event.kind) {
      case EventKind::kNull:
        built = null_node(event, empty_at);
        break;
      case EventKind::kAlias:
        return alias(event);
      case EventKind::kScalar:
        built = scalar(event);
        break;
      case EventKind::kSequence:
        built = sequence(event);
        break;
      case EventKind::kMap:
        built = map(event);
        break;
      case EventKind::kEnd:
        return {};
    }
    if (event.tag != "?" && event.tag != "!") built.tag = event.tag;
    if (event.anchor != 0) anchors_[event.anchor] = built;
    return built;
  }

  YamlNode null_node(const Event& event, TextRange empty_at) {
    YamlNode built;
    const std::size_t offset = behind_properties(event.offset);
    std::size_t length = 0;
    for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
      if (text_.substr(offset).starts_with(word)) length = word.size();
    }
    // An empty value bears the place of whatever comes next: then that event has the same place.
    const auto next =
        std::find_if(events_.begin() + static_cast<std::ptrdiff_t>(at_), events_.end(),
                     [](const Event& e) { return e.kind != EventKind::kEnd; });
    const bool shared = next != events_.end() && next->offset == event.offset;
    const std::size_t end = offset + length;
    const bool delimited =
        end >= text_.size() ||
        std::string_view(" \t\r\n,]}:").find(text_[end]) != std::string_view::npos;
    built.written = length > 0 && delimited && !shared;
    built.range = built.written ? TextRange{offset, length} : empty_at;
    return built;
  }

  YamlNode alias(const Event& event) {
    const auto found = anchors_.find(event.anchor);
    if (found == anchors_.end()) {
      fatal_ = not_yaml(source_, "an alias is inside the value that it names", {event.offset, 1});
      return {};
    }
    count_ += size_of(found->second);
    if (count_ > most_nodes_) {
      fatal_ = unreadable(source_, "its aliases unfold to too many values", {event.offset, 1});
      return {};
    }
    return found->second;
  }

  static std::size_t size_of(const YamlNode& node) {
    std::size_t size = 1;
    for (const YamlNode& item : node.items) size += size_of(item);
    for (const YamlEntry& entry : node.entries) size += size_of(entry.value);
    return size;
  }

  YamlNode scalar(const Event& event) {
    YamlNode built{.kind = YamlKind::kScalar, .text = event.value};
    const std::size_t offset = behind_properties(event.offset);
    const char first = offset < text_.size() ? text_[offset] : '\0';
    // A plain scalar never begins with a quote; a block begins with its mark. (An explicit tag
    // hides the style.)
    const bool quotes = first == '"' || first == '\'';
    built.quoted = quotes || event.tag == "!";
    if (quotes) {
      built.range = {offset, quoted_length(offset)};
      if (built.range.length == 0) {
        // The library reads an open quote to the end of the file without a word.
        fatal_ = yaml_syntax_error(source_, {.message = "illegal EOF in scalar", .offset = offset},
                                   first_error_of);
        return built;
      }
      built.text_offset = offset + 1;
    } else if (built.quoted) {
      built.range = {offset, 1};
      built.text_offset = offset;
    } else {
      built.text_offset = offset;
      built.range = {offset, text_.substr(offset, event.value.size()) == event.value
                                 ? event.value.size()
                                 : rest_of_line(offset)};
    }
    built.verbatim =
        !event.value.empty() && text_.substr(built.text_offset, event.value.size()) == event.value;
    return built;
  }

  YamlNode sequence(const Event& event) {
    YamlNode built{.kind = YamlKind::kSequence, .range = {behind_properties(event.offset), 1}};
    std::size_t cursor = built.range.offset;
    while (!fatal_ && at_ < events_.size() && events_[at_].kind != EventKind::kEnd) {
      const TextRange dash = next_dash(cursor);
      built.items.push_back(node(dash));
      cursor = std::max(dash.offset + 1, end_of(built.items.back()));
    }
    ++at_;
    return built;
  }

  YamlNode map(const Event& event) {
    YamlNode built{.kind = YamlKind::kMap, .range = {behind_properties(event.offset), 1}};
    const bool block = text_.substr(built.range.offset, 1) != "{";
    std::set<std::string> keys;
    while (!fatal_ && at_ < events_.size() && events_[at_].kind != EventKind::kEnd) {
      const EventKind key_kind = events_[at_].kind;
      const YamlNode key = node({events_[at_].offset, 1});
      if (fatal_) break;
      if (key_kind != EventKind::kScalar) {
        fatal_ = not_yaml(source_, "a key must be a word", key.range, "this is not a word");
        break;
      }
      const bool has_colon = text_.substr(behind_colon(key.range).offset - 1, 1) == ":";
      if (block && !has_colon && at_ < events_.size() && events_[at_].kind == EventKind::kNull) {
        // The library takes a lone word in a mapping for a key with nothing behind it.
        fatal_ = yaml_syntax_error(
            source_, {.message = "illegal key without value", .offset = key.range.offset},
            first_error_of);
        break;
      }
      YamlNode value = node(behind_colon(key.range));
      if (!keys.insert(key.text).second) {
        duplicate(built, key, std::move(value));
        continue;
      }
      if (built.entries.empty()) built.range = key.range;
      built.entries.push_back({.key = key.text, .key_range = key.range, .value = std::move(value)});
    }
    ++at_;
    return built;
  }

  void duplicate(YamlNode& map_node, const YamlNode& key, YamlNode value) {
    const auto first = std::find_if(map_node.entries.begin(), map_node.entries.end(),
                                    [&](const YamlEntry& entry) { return entry.key == key.text; });
    if (duplicates_ == DuplicateKeys::kLastCounts) {
      first->value = std::move(value);
      return;
    }
    const SourceSpan before = source_.span(first->key_range.offset, first->key_range.length);
    problems_.push_back(Diagnostic{
        .code = "R2W0105",
        .message = "the key `" + key.text + "` appears twice in one mapping",
        .span = source_.span(key.range.offset, key.range.length),
        .label = "the first `" + key.text + "` is in line " + std::to_string(before.line),
        .why = {"it is not clear which of the two is meant; YAML allows a key once"}});
  }

  /// Skips `!tag` and `&anchor` and the white space after them.
  [[nodiscard]] std::size_t behind_properties(std::size_t offset) const {
    while (offset < text_.size() && (text_[offset] == '!' || text_[offset] == '&')) {
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n,", offset), text_.size());
      const std::size_t next = std::min(text_.find_first_not_of(" \t\r\n", end), text_.size());
      if (next == offset) break;
      offset = next;
    }
    return offset;
  }

  [[nodiscard]] std::size_t rest_of_line(std::size_t offset) const {
    const std::size_t end = std::min(text_.find_first_of("\r\n", offset), text_.size());
    return std::max<std::size_t>(end - std::min(end, offset), 1);
  }

  /// Bytes from the opening quote at `offset` to the closing one; 0 when there is none.
  [[nodiscard]] std::size_t quoted_length(std::size_t offset) const {
    const char quote = text_[offset];
    for (std::size_t i = offset + 1; i < text_.size(); ++i) {
      if (quote == '"' && text_[i] == '\\') {
        ++i;
      } else if (text_[i] == quote) {
        const bool doubled = quote == '\'' && i + 1 < text_.size() && text_[i + 1] == quote;
        if (!doubled) return i - offset + 1;
        ++i;
      }
    }
    return 0;
  }

  /// The place right behind the colon that follows a key.
  [[nodiscard]] TextRange behind_colon(TextRange key) const {
    std::size_t i = key.offset + key.length;
    while (i < text_.size() && (text_[i] == ' ' || text_[i] == '\t')) ++i;
    const bool colon = i < text_.size() && text_[i] == ':';
    return {colon ? i + 1 : key.offset + key.length, 1};
  }

  /// The `-` of the next item of a block sequence, skipping blank space and comments; `from` when
  /// there is none.
  [[nodiscard]] TextRange next_dash(std::size_t from) const {
    std::size_t i = from;
    while (i < text_.size()) {
      if (text_[i] == '#') {
        i = std::min(text_.find('\n', i), text_.size());
      } else if (std::string_view(" \t\r\n").find(text_[i]) != std::string_view::npos) {
        ++i;
      } else {
        break;
      }
    }
    return i < text_.size() && text_[i] == '-' ? TextRange{i, 1} : TextRange{from, 1};
  }

  static std::size_t end_of(const YamlNode& node) {
    if (!node.items.empty()) return end_of(node.items.back());
    if (!node.entries.empty()) {
      const YamlEntry& last = node.entries.back();
      return std::max(last.key_range.offset + last.key_range.length, end_of(last.value));
    }
    const bool nothing = node.kind == YamlKind::kNull && !node.written;
    return node.range.offset + (nothing ? 0 : node.range.length);
  }

  const SourceText& source_;
  std::string_view text_;
  const std::vector<Event>& events_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
  std::map<std::size_t, YamlNode> anchors_;
  DuplicateKeys duplicates_;
  std::size_t most_nodes_;
  Diagnostics problems_;
  std::optional<Diagnostic> fatal_;
};

Outcome<YamlDocument> parse(const SourceText& source, DuplicateKeys duplicates,
                            std::size_t most_nodes) {
  if (auto problem = encoding_problem(source)) return *std::move(problem);
  Outcome<RecordedEvents> recorded = record_events(source, most_nodes);
  if (!recorded) return recorded.errors();
  if (recorded->second_document) {
    const std::size_t offset = *recorded->second_document;
    if (!source.text().substr(offset).starts_with("---")) {
      // The library takes what does not fit for a new document, even without the mark for one.
      return yaml_syntax_error(source, {.message = "end of document not found", .offset = offset},
                               first_error_of);
    }
    return not_yaml(source, "the file holds more than one YAML document", {offset, 3},
                    "the second document begins here");
  }
  if (recorded->events.empty()) return YamlDocument{};
  return TreeBuilder(source, recorded->events, duplicates, most_nodes).build();
}

}  // namespace

Outcome<YamlDocument> parse_yaml(const SourceText& source, DuplicateKeys duplicates) {
  return parse(source, duplicates, kMostNodes);
}

Outcome<YamlDocument> parse_long_yaml(const SourceText& source) {
  return parse(source, DuplicateKeys::kLastCounts, kMostNodesOfLists);
}

}  // namespace ros2wasm
