// See pixi_manifest.hpp.
#include "bundler/workspace/pixi_manifest.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "workspace_schema/match_spec.hpp"
#include "workspace_schema/source_text.hpp"

namespace ros2wasm {
namespace {

/// A value of TOML; numbers, dates and booleans stay as they are written.
struct TomlValue {
  std::string text;
  bool is_text = false;  ///< a string, in quotes
  std::vector<TomlValue> items;
  std::vector<std::pair<std::string, TomlValue>> fields;

  [[nodiscard]] std::string field(std::string_view key) const {
    for (const auto& [name, value] : fields)
      if (name == key) return value.text;
    return {};
  }
};

/// Reads `[table]` lines and `key = value` lines one after the other.
class TomlReader {
 public:
  explicit TomlReader(std::string_view text) : text_(text) {}

  struct Line {
    std::vector<std::string> table;
    std::vector<std::string> key;
    TomlValue value;
    std::size_t offset = 0;
  };

  /// The next key; nothing at the end or at a fault.
  std::optional<Line> next() {
    for (skip_blank(); at_ < text_.size() && why_.empty(); skip_blank()) {
      Line line{.table = {}, .key = {}, .value = {}, .offset = at_};
      if (peek() != '[') {
        line.key = dotted_key();
        if (!why_.empty() || !expect('=')) break;
        line.value = value(0);
        if (!why_.empty()) break;
        line.table = table_;
        return line;
      }
      ++at_;
      const bool list = peek() == '[';
      if (list) ++at_;
      table_ = dotted_key();
      if (!why_.empty() || !expect(']') || (list && !expect(']'))) break;
    }
    return std::nullopt;
  }

  [[nodiscard]] const std::string& why() const { return why_; }
  [[nodiscard]] std::size_t offset() const { return std::min(at_, text_.size()); }

 private:
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_spaces() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }
  void skip_blank() {
    for (;;) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (peek() != '#') return;
      at_ = std::min(text_.find('\n', at_), text_.size());
    }
  }
  bool expect(char c) {
    skip_spaces();
    if (peek() != c) {
      fail(std::string("`") + c + "` is expected here");
      return false;
    }
    ++at_;
    return true;
  }
  void fail(std::string why) {
    if (why_.empty()) why_ = std::move(why);
  }

  std::vector<std::string> dotted_key() {
    std::vector<std::string> parts;
    for (;;) {
      skip_spaces();
      if (peek() == '"' || peek() == '\'') {
        parts.push_back(quoted());
      } else {
        const std::size_t end =
            std::min(text_.find_first_of(" \t\r\n.=]#[{}\"',", at_), text_.size());
        if (end == at_) fail("a key is expected here");
        parts.emplace_back(text_.substr(at_, end - at_));
        at_ = end;
      }
      skip_spaces();
      if (!why_.empty() || peek() != '.') return parts;
      ++at_;
    }
  }

  std::string quoted() {
    const char quote = peek();
    const std::string three(3, quote);
    const bool block = text_.substr(at_).starts_with(three);
    at_ += block ? 3 : 1;
    std::string out;
    while (at_ < text_.size()) {
      if (block ? text_.substr(at_).starts_with(three) : peek() == quote) {
        at_ += block ? 3 : 1;
        return out;
      }
      if (!block && peek() == '\n') break;
      if (quote == '"' && peek() == '\\' && at_ + 1 < text_.size()) {
        ++at_;
        constexpr std::string_view kNames = "nt\"\\";
        constexpr std::string_view kMeans = "\n\t\"\\";
        const std::size_t found = kNames.find(peek());
        if (found == std::string_view::npos) fail("this escape is not read");
        out += found == std::string_view::npos ? ' ' : kMeans[found];
      } else {
        out += peek();
      }
      ++at_;
    }
    fail("a string is not closed");
    return out;
  }

  TomlValue value(int depth) {
    constexpr int kDeepest = 32;
    TomlValue made;
    skip_spaces();
    if (depth > kDeepest) {
      fail("it is nested too deep");
    } else if (peek() == '"' || peek() == '\'') {
      made.is_text = true;
      made.text = quoted();
    } else if (peek() == '[') {
      ++at_;
      for (skip_blank(); peek() != ']' && why_.empty(); skip_blank()) {
        made.items.push_back(value(depth + 1));
        skip_blank();
        if (peek() == ',') {
          ++at_;
        } else if (peek() != ']') {
          fail("`,` or `]` is expected here");
        }
      }
      ++at_;
    } else if (peek() == '{') {
      ++at_;
      for (skip_blank(); peek() != '}' && why_.empty(); skip_blank()) {
        const std::vector<std::string> key = dotted_key();
        if (!why_.empty() || !expect('=')) break;
        made.fields.emplace_back(key.back(), value(depth + 1));
        skip_blank();
        if (peek() == ',') {
          ++at_;
        } else if (peek() != '}') {
          fail("`,` or `}` is expected here");
        }
      }
      ++at_;
    } else {
      const std::size_t end = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
      made.text = std::string(text_.substr(at_, end - at_));
      while (made.text.ends_with(' ') || made.text.ends_with('\t')) made.text.pop_back();
      if (made.text.empty()) fail("a value is expected here");
      at_ = end;
    }
    return made;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string> table_;
  std::string why_;
};

/// "name" and what pixi says of it as one match spec; empty for what is no conda package.
std::string spec_of(const std::string& name, const TomlValue& value) {
  if (value.is_text) return value.text == "*" ? name : name + " " + value.text;
  if (!value.field("git").empty() || !value.field("path").empty() || value.fields.empty())
    return {};
  std::string spec = value.field("channel").empty() ? name : value.field("channel") + "::" + name;
  const std::string version = value.field("version");
  if (!version.empty() && version != "*") spec += " " + version;
  if (const std::string build = value.field("build"); !build.empty())
    spec += "[build='" + build + "']";
  return spec;
}

bool is_dependency_table(const std::vector<std::string>& table) {
  using Path = std::vector<std::string>;
  return table == Path{"dependencies"} ||
         table == Path{"target", "emscripten-wasm32", "dependencies"};
}

}  // namespace

Outcome<ForeignEnvironment> read_pixi_manifest(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  const auto fault = [&source](std::size_t offset, const std::string& why) {
    return Diagnostic{.code = "R2W0340",
                      .message = "`" + source.file() + "` cannot be taken over: " + why,
                      .span = source.span(offset, 1)};
  };
  ForeignEnvironment made{.format = "pixi.toml"};
  bool is_pixi = false;
  TomlReader reader(text);
  while (auto line = reader.next()) {
    std::vector<std::string> path = line->table;
    path.insert(path.end(), line->key.begin(), line->key.end() - 1);
    const std::string& key = line->key.back();
    if (path.size() >= 2 && path[0] == "tool" && path[1] == "pixi")
      path.erase(path.begin(), path.begin() + 2);
    if (path == std::vector<std::string>{"workspace"} ||
        path == std::vector<std::string>{"project"}) {
      is_pixi = is_pixi || key == "channels";
      if (key == "name") made.name = line->value.text;
      for (const TomlValue& one : line->value.items)
        if (key == "channels")
          made.channels.push_back(one.is_text ? one.text : one.field("channel"));
    } else if (is_dependency_table(path)) {
      const std::string spec = spec_of(key, line->value);
      if (spec.empty()) {
        made.left_out.push_back(key + " (from elsewhere than a channel)");
      } else if (const auto parsed = MatchSpec::parse(spec); !parsed) {
        return fault(line->offset, parsed.errors().front().message);
      } else {
        made.specs.push_back(spec);
      }
    } else if (!path.empty() && path.back().ends_with("dependencies")) {
      made.left_out.push_back(key + " (of " + path.front() + ")");
    }
  }
  if (!reader.why().empty()) return fault(reader.offset(), reader.why());
  if (!is_pixi) return fault(0, "it has no `channels` under [workspace] or [project]");
  return made;
}

}  // namespace ros2wasm
