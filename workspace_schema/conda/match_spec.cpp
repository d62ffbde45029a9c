// See match_spec.hpp. Takes a spec apart in the order in which conda does: comment, file name,
// brackets, parentheses, channel, name, version and build.
#include "workspace_schema/conda/match_spec.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "workspace_schema/base/trimmed_text.hpp"
#include "workspace_schema/conda/match_spec_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLongestSpec = 8192;

constexpr auto kBracketKeys = std::to_array<std::string_view>(
    {"channel", "subdir", "name", "version", "build", "build_number", "track_features", "features",
     "url", "md5", "sha256", "license", "license_family", "fn", "when", "extras", "flags",
     "optional", "target"});

}  // namespace

/// Fills a MatchSpec step by step. `fault_` is set by the first step that cannot go on.
class MatchSpecReader {
 public:
  explicit MatchSpecReader(std::string_view text) : given_(text) {
    spec_.text_ = std::string(trimmed(text));
  }

  Outcome<MatchSpec> read() {
    if (spec_.text_.empty()) return bad("it is empty");
    if (given_.size() > kLongestSpec) return bad("it is too long");
    if (first_control_character()) return bad("it has a control character");
    std::string text = without_comment();
    if (const std::size_t condition = text.find(" if "); condition != std::string::npos)
      text.resize(condition);
    if (text.ends_with('@')) return feature(text.substr(0, text.size() - 1));
    if (is_archive_name(text)) return archive(text);
    if (!take_brackets(text)) return fault_;
    (void)take_section(text, '(', ')');  // an old form; conda drops it too
    take_channel(text);
    if (!take_name(text) || !part_version(text) || !apply_fields()) return fault_;
    return std::move(spec_);
  }

 private:
  Diagnostic bad(const std::string& why) const {
    return Diagnostic{
        .code = "R2W0303",
        .message = "`" + std::string(given_.substr(0, 120)) + "` is not a match spec: " + why};
  }
  bool fail(const std::string& why) {
    fault_ = {bad(why)};
    return false;
  }
  bool fail(Diagnostics errors) { return fail(errors.front().message); }

  [[nodiscard]] bool first_control_character() const {
    return std::any_of(given_.begin(), given_.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  }

  /// Cuts a comment; the fragment of an archive's URL is its hash.
  std::string without_comment() {
    const std::size_t hash = given_.find('#');
    if (hash == std::string_view::npos) return std::string(given_);
    const std::string_view fragment = given_.substr(hash + 1);
    const bool hex = fragment.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
    if (is_archive_name(given_.substr(0, hash)) && hex) {
      if (fragment.size() == 32) spec_.md5_ = ascii_lower(fragment);
      if (fragment.size() == 64) spec_.sha256_ = ascii_lower(fragment);
    }
    return std::string(given_.substr(0, hash));
  }

  Outcome<MatchSpec> feature(const std::string& name) {
    spec_.name_ = *TextPattern::parse("*", LetterCase::kIgnored);
    spec_.track_features_ = std::vector<std::string>{name};
    return std::move(spec_);
  }

  /// A URL, a path or a file name of an archive.
  Outcome<MatchSpec> archive(const std::string& text) {
    const std::string_view file = last_part(text);
    spec_.file_name_ = std::string(file);
    if (text.find("://") != std::string::npos) spec_.url_ = text;
    const std::string_view stem = file.substr(0, file.size() - (file.ends_with(".conda") ? 6 : 8));
    const std::size_t build = stem.rfind('-');
    const std::size_t version =
        build == 0 || build == std::string_view::npos ? build : stem.rfind('-', build - 1);
    const std::string_view folder = std::string_view(text).substr(0, text.size() - file.size());
    const bool in_subdir =
        known_subdir(last_part(folder.substr(0, folder.empty() ? 0 : folder.size() - 1)));
    if (build == std::string_view::npos || version == std::string_view::npos || version == 0) {
      if (in_subdir) return bad("the file name has not the parts name, version and build");
      spec_.name_ = *TextPattern::parse("*", LetterCase::kIgnored);
      return std::move(spec_);
    }
    // The name is kept although the file says all, so that the package can be looked up.
    const std::string name = ascii_lower(stem.substr(0, version));
    spec_.build_ = *TextPattern::parse(stem.substr(build + 1), LetterCase::kCounts);
    auto exactly =
        VersionSpec::parse("==" + std::string(stem.substr(version + 1, build - version - 1)));
    if (exactly) spec_.version_ = std::move(*exactly);
    spec_.name_ = *TextPattern::parse(is_package_name(name) ? name : "*", LetterCase::kIgnored);
    return std::move(spec_);
  }

  bool take_brackets(std::string& text) {
    const auto inside = take_section(text, '[', ']');
    if (!inside) return true;
    for (BracketPair& pair : bracket_pairs(*inside)) {
      if (pair.value.empty()) return fail("`" + pair.key + "` has no value");
      if (std::find(kBracketKeys.begin(), kBracketKeys.end(), pair.key) == kBracketKeys.end()) {
        return fail("there is no field `" + pair.key + "`");
      }
      if (pair.key == "version") pair.value = normal_version(pair.value, false);
      fields_[pair.key] = std::move(pair.value);
    }
    return true;
  }

  void take_channel(std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return;
    const std::size_t second = colon == 0 ? std::string::npos : text.rfind(':', colon - 1);
    const std::string channel =
        second == std::string::npos ? std::string() : text.substr(0, second);
    text.erase(0, colon + 1);
    set_channel(std::string(trimmed(channel)));
  }

  /// "name/subdir" or "name".
  void set_channel(std::string channel) {
    if (channel.empty()) return;
    while (channel.size() > 1 && channel.ends_with('/')) channel.pop_back();
    const std::string_view last = last_part(channel);
    if (last.size() < channel.size() && (known_subdir(last) || last == "*")) {
      if (last != "*") spec_.subdir_ = std::string(last);
      channel.resize(channel.size() - last.size() - 1);
    }
    channel_ = std::move(channel);
  }

  bool take_name(std::string& text) {
    const std::size_t end = std::min(text.find_first_of(" =<>!~"), text.size());
    const std::string name = ascii_lower(text.substr(0, end));
    if (name.empty()) return fail("it has no package name");
    const bool pattern = name.find('*') != std::string::npos;
    if (!pattern && !is_package_name(name)) {
      return fail(
          "`" + name +
          "` is not a package name (letters, digits, and single `-`, `_`, `.` between them)");
    }
    auto parsed = TextPattern::parse(name, LetterCase::kIgnored);
    if (!parsed) return fail(parsed.errors());
    spec_.name_ = std::move(*parsed);
    text.erase(0, end);
    if (text.size() < 2) text.clear();  // conda takes `name=` for `name`
    return true;
  }

  /// Stores the parts as texts only: values in brackets override them later.
  bool part_version(const std::string& rest) {
    const std::string text = with_single_spaces(trimmed(rest));
    if (text.empty()) return true;
    if (text.find('[') != std::string::npos) return fail("it has more than one bracket section");
    VersionAndBuild parts = part_version_and_build(text);
    fields_.emplace("version", normal_version(parts.version, parts.build.has_value()));
    if (parts.build) fields_.emplace("build", std::move(*parts.build));
    return true;
  }

  bool set_version(const std::string& text) {
    auto version = VersionSpec::parse(text);
    if (!version) return fail(version.errors());
    spec_.version_ = std::move(*version);
    return true;
  }

  bool set_pattern(std::optional<TextPattern>& field, const std::string& text,
                   LetterCase letter_case) {
    auto pattern = TextPattern::parse(text, letter_case);
    if (!pattern) return fail(pattern.errors());
    field = std::move(*pattern);
    return true;
  }

  /// A whole number, a comparison, or a regular expression over its digits; conda takes any other
  /// text too, and no number is equal to it.
  bool set_build_number(std::string_view text) {
    text = trimmed(text);
    if (text == "*") return true;
    if (text.empty()) return fail("`build_number` is empty");
    const auto whole = whole_number(text);  // `text` may look into it until the end
    if (whole) {
      text = *whole;
    } else if (text.front() == '^' || text.back() == '$') {
      if (text.front() != '^' || text.back() != '$')
        return fail("a regular expression begins with `^` and ends with `$`");
      return set_pattern(spec_.build_number_text_, std::string(text), LetterCase::kCounts);
    } else if (std::string_view("=<>!").find(text.front()) == std::string_view::npos) {
      spec_.no_build_number_ = true;
      return true;
    } else if (text.find_first_of("()|,^$ ") != std::string_view::npos) {
      return fail("`build_number` is neither a number nor one comparison");
    }
    auto number = VersionSpec::parse(text);
    if (!number) return fail("`build_number` is neither a number nor a comparison");
    spec_.build_number_ = std::move(*number);
    return true;
  }

  static std::vector<std::string> features(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + " ") {
      if (c != ' ' && c != ',') {
        word += c;
      } else if (!word.empty()) {
        words.push_back(std::exchange(word, {}));
      }
    }
    std::sort(words.begin(), words.end());
    return words;
  }

  bool apply_fields() {
    for (const auto& [key, value] : fields_) {
      bool fine = true;
      if (key == "version") {
        fine = set_version(value);
      } else if (key == "build") {
        fine = set_pattern(spec_.build_, value, LetterCase::kCounts);
      } else if (key == "build_number") {
        fine = set_build_number(value);
      } else if (key == "channel") {
        set_channel(value);
      } else if (key == "license") {
        fine = set_pattern(spec_.license_, value, LetterCase::kIgnored);
      } else if (key == "track_features") {
        spec_.track_features_ = features(value);
      } else if (key == "fn") {
        spec_.file_name_ = value;
      } else if (key == "url") {
        spec_.url_ = value;
      } else if (key == "md5") {
        spec_.md5_ = ascii_lower(value);
      } else if (key == "sha256") {
        spec_.sha256_ = ascii_lower(value);
      } else if (key == "features" || key == "license_family" || key == "flags") {
        spec_.impossible_ = true;
      }
      if (!fine) return false;
    }
    if (const auto subdir = fields_.find("subdir"); subdir != fields_.end())
      spec_.subdir_ = subdir->second;
    return channel_.empty() || set_pattern(spec_.channel_, channel_, LetterCase::kCounts);
  }

  std::string_view given_;
  MatchSpec spec_;
  std::string channel_;
  std::map<std::string, std::string> fields_;
  Diagnostics fault_;
};

Outcome<MatchSpec> MatchSpec::parse(std::string_view text) {
  return MatchSpecReader(text).read();
}

std::optional<std::string> MatchSpec::exact_name() const {
  return name_.exact() ? std::optional(name_.text()) : std::nullopt;
}

namespace {

/// A channel is named by its whole address or by the end of it: `conda-forge` for
/// `https://host/conda-forge`.
bool channel_matches(const TextPattern& pattern, const std::string& channel) {
  if (pattern.matches(channel)) return true;
  for (std::size_t slash = channel.find('/'); slash != std::string::npos;
       slash = channel.find('/', slash + 1)) {
    if (pattern.matches(std::string_view(channel).substr(slash + 1))) return true;
  }
  return false;
}

bool same_if_asked(const std::string& wanted, const std::string& value) {
  return wanted.empty() || wanted == value;
}

}  // namespace

bool MatchSpec::accepts_channel(const std::string& address) const {
  return !channel_ || channel_matches(*channel_, address);
}

std::vector<std::pair<std::string_view, std::string>> MatchSpec::fields() const {
  std::vector<std::pair<std::string_view, std::string>> fields{{"name", name_.text()}};
  const auto add = [&fields](std::string_view key, const std::string& value) {
    if (!value.empty()) fields.emplace_back(key, value);
  };
  if (!version_.any()) add("version", version_.text());
  if (build_) add("build", build_->text());
  if (build_number_) add("build_number", build_number_->text());
  if (build_number_text_) add("build_number", build_number_text_->text());
  if (channel_) add("channel", channel_->text());
  add("subdir", subdir_);
  if (license_) add("license", license_->text());
  if (track_features_) {
    std::string words;
    for (const std::string& word : *track_features_) words += (words.empty() ? "" : " ") + word;
    add("track_features", words);
  }
  add("fn", file_name_);
  add("url", url_);
  add("sha256", sha256_);
  add("md5", md5_);
  return fields;
}

bool MatchSpec::matches_build(const Version& version, std::string_view build,
                              std::uint64_t build_number) const {
  if (!version_.matches(version) || (build_ && !build_->matches(build))) return false;
  if (no_build_number_) return false;
  if (!build_number_ && !build_number_text_) return true;
  const std::string digits = std::to_string(build_number);
  if (build_number_text_) return build_number_text_->matches(digits);
  const auto number = Version::parse(digits);
  return number && build_number_->matches(*number);
}

bool MatchSpec::matches(const PackageRecord& record, const Version& version) const {
  if (impossible_ || !name_.matches(record.name)) return false;
  if (!matches_build(version, record.build, record.build_number)) return false;
  if (!accepts_channel(record.channel)) return false;
  if (license_ && !license_->matches(record.license)) return false;
  if (track_features_ && *track_features_ != record.track_features) return false;
  return same_if_asked(subdir_, record.subdir) && same_if_asked(file_name_, record.file_name) &&
         same_if_asked(url_, record.url) && same_if_asked(sha256_, record.sha256) &&
         same_if_asked(md5_, record.md5);
}

bool MatchSpec::matches(const PackageRecord& record) const {
  const auto version = Version::parse(record.version);
  return version && matches(record, *version);
}

}  // namespace ros2wasm
