// See version.hpp. Follows conda's VersionOrder step by step, its corner cases too.
#include "workspace_schema/conda/version.hpp"

#include <algorithm>
#include <array>

#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLongest = 65'536;   // no version is near it; keeps hostile input cheap
constexpr std::size_t kMostDigits = 4300;  // Python reads no longer number
constexpr std::size_t kPlainDigits = 9;    // fit into 32 bits

constexpr auto kWideSpaces = std::to_array<std::string_view>(
    {"\xC2\x85", "\xC2\xA0", "\xE1\x9A\x80", "\xE2\x80\x80", "\xE2\x80\x81", "\xE2\x80\x82",
     "\xE2\x80\x83", "\xE2\x80\x84", "\xE2\x80\x85", "\xE2\x80\x86", "\xE2\x80\x87", "\xE2\x80\x88",
     "\xE2\x80\x89", "\xE2\x80\x8A", "\xE2\x80\xA8", "\xE2\x80\xA9", "\xE2\x80\xAF", "\xE2\x81\x9F",
     "\xE3\x80\x80"});

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

Diagnostic bad_version(std::string_view text, const std::string& why) {
  return Diagnostic{
      .code = "R2W0304",
      .message = "`" + std::string(text.substr(0, 100)) + "` is not a version: " + why};
}

bool valid_characters(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || c == '.' || c == '*' || c == '+' || c == '!' ||
           c == '_';
  });
}

/// The length of the white space that `text` begins with: what Python's `str.strip` takes away.
std::size_t space_at_front(std::string_view text) {
  if (text.empty()) return 0;
  const auto c = static_cast<unsigned char>(text.front());
  if (c == ' ' || (c >= 0x09 && c <= 0x0d) || (c >= 0x1c && c <= 0x1f)) return 1;
  for (const std::string_view wide : kWideSpaces) {
    if (text.starts_with(wide)) return wide.size();
  }
  return 0;
}

std::string_view trimmed(std::string_view text) {
  while (const std::size_t length = space_at_front(text)) text.remove_prefix(length);
  for (std::size_t length = 1; length <= 3 && length <= text.size(); ++length) {
    if (space_at_front(text.substr(text.size() - length)) != length) continue;
    text.remove_suffix(length);
    length = 0;
  }
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t start = 0;;) {
    const std::size_t end = text.find(separator, start);
    parts.emplace_back(text.substr(start, end - start));
    if (end == std::string_view::npos) return parts;
    start = end + 1;
  }
}

std::vector<std::string> split_components(std::string text) {
  std::replace(text.begin(), text.end(), '_', '.');
  return split(text, '.');
}

enum class RunKind { kDigits, kStars, kOther };

RunKind run_kind(char c) {
  if (is_digit(c)) return RunKind::kDigits;
  return c == '*' ? RunKind::kStars : RunKind::kOther;
}

VersionAtom atom_of(std::string_view run) {
  if (is_digits(run)) {
    const std::size_t first = std::min(run.find_first_not_of('0'), run.size() - 1);
    return {.kind = VersionAtom::Kind::kNumber, .text = std::string(run.substr(first))};
  }
  if (run == "post") return {.kind = VersionAtom::Kind::kPost, .text = {}};
  if (run == "dev") return {.kind = VersionAtom::Kind::kText, .text = "DEV"};
  return {.kind = VersionAtom::Kind::kText, .text = std::string(run)};
}

Outcome<VersionSegment> segment_of(std::string_view component) {
  VersionSegment segment;
  // A number comes first, so that numbers and words stay in phase between versions.
  if (!is_digit(component.front())) segment.emplace_back();
  while (!component.empty()) {
    std::size_t length = 1;
    while (length < component.size() && run_kind(component[length]) == run_kind(component[0]))
      ++length;
    if (length > kMostDigits && is_digit(component[0]))
      return bad_version(component, "it has a number of too many digits");
    segment.push_back(atom_of(component.substr(0, length)));
    component.remove_prefix(length);
  }
  return segment;
}

const VersionAtom& atom_at(const VersionSegment& segment, std::size_t i) {
  static const VersionAtom kZero;
  return i < segment.size() ? segment[i] : kZero;
}

const VersionSegment& segment_at(const std::vector<VersionSegment>& segments, std::size_t i) {
  static const VersionSegment kNone;
  return i < segments.size() ? segments[i] : kNone;
}

std::strong_ordering compare(const VersionSegment& a, const VersionSegment& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto order = atom_at(a, i) <=> atom_at(b, i); order != 0) return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const std::vector<VersionSegment>& a,
                             const std::vector<VersionSegment>& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const VersionSegment& left = segment_at(a, i);
    const VersionSegment& right = segment_at(b, i);
    if (const auto order = compare(left, right, std::max(left.size(), right.size())); order != 0)
      return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const std::vector<VersionSegment>& a,
                             const std::vector<VersionSegment>& b) {
  return compare(a, b, std::max(a.size(), b.size()));
}

}  // namespace

std::strong_ordering VersionAtom::operator<=>(const VersionAtom& other) const {
  if (kind != other.kind) return kind <=> other.kind;
  if (kind == Kind::kNumber && text.size() != other.text.size())
    return text.size() <=> other.text.size();
  return text.compare(other.text) <=> 0;
}

Outcome<Version> Version::parse(std::string_view given) {
  Version version;
  version.text_ = std::string(trimmed(given));
  if (version.text_.size() > kLongest) return bad_version(given, "it is too long");
  std::string text = version.text_;
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (text.empty()) return bad_version(given, "it is empty");
  if (!valid_characters(text) && text.find('_') == std::string::npos) {
    std::replace(text.begin(), text.end(), '-', '_');
  }
  if (!valid_characters(text))
    return bad_version(given, "it has a character that versions may not have");

  std::string epoch = "0";
  const std::vector<std::string> by_epoch = split(text, '!');
  if (by_epoch.size() > 2) return bad_version(given, "it has two epochs (`!`)");
  if (by_epoch.size() == 2) {
    epoch = by_epoch[0];
    if (!is_digits(epoch)) return bad_version(given, "the epoch before `!` is not a number");
  }
  const std::vector<std::string> by_local = split(by_epoch.back(), '+');
  if (by_local.size() > 2) return bad_version(given, "it has two local parts (`+`)");
  std::string main = by_local[0];
  if (main.empty()) return bad_version(given, "there is nothing before the local part");

  std::vector<std::string> components;
  if (main.back() == '_') {  // openssl's way: 1.0.1_ sorts before 1.0.1a
    main.pop_back();
    components = split_components(main);
    components.back() += '_';
  } else {
    components = split_components(main);
  }
  components.insert(components.begin(), epoch);
  for (const std::string& component : components) {
    if (component.empty()) return bad_version(given, "it has an empty part");
    auto segment = segment_of(component);
    if (!segment) return std::move(segment).errors();
    version.segments_.push_back(std::move(*segment));
  }
  if (by_local.size() == 2) {
    for (const std::string& component : split_components(by_local[1])) {
      if (component.empty()) return bad_version(given, "its local part has an empty part");
      auto segment = segment_of(component);
      if (!segment) return std::move(segment).errors();
      version.local_.push_back(std::move(*segment));
    }
  }
  version.note_plain();
  return version;
}

void Version::note_plain() {
  if (segments_.size() > kPlainNumbers || !local_.empty()) return;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const VersionAtom& number = segments_[i].front();
    if (segments_[i].size() > 1 || number.text.size() > kPlainDigits) return;
    for (const char c : number.text)
      numbers_[i] = numbers_[i] * 10 + static_cast<std::uint32_t>(c - '0');
  }
  plain_ = true;
}

std::strong_ordering Version::operator<=>(const Version& other) const {
  if (plain_ && other.plain_) {
    const auto [own, others] =
        std::mismatch(numbers_.begin(), numbers_.end(), other.numbers_.begin());
    return own == numbers_.end() ? std::strong_ordering::equal : *own <=> *others;
  }
  if (const auto order = compare(segments_, other.segments_); order != 0) return order;
  return compare(local_, other.local_);
}

bool Version::starts_with(const Version& prefix) const {
  const bool by_local = !prefix.local_.empty();
  if (by_local && compare(segments_, prefix.segments_) != 0) return false;
  const std::vector<VersionSegment>& own = by_local ? local_ : segments_;
  const std::vector<VersionSegment>& wanted = by_local ? prefix.local_ : prefix.segments_;
  const std::size_t last = wanted.size() - 1;
  if (compare(own, wanted, last) != 0) return false;
  const VersionSegment& own_segment = segment_at(own, last);
  const VersionSegment& wanted_segment = wanted[last];
  const std::size_t last_atom = wanted_segment.size() - 1;
  if (compare(own_segment, wanted_segment, last_atom) != 0) return false;
  const VersionAtom& own_atom = atom_at(own_segment, last_atom);
  const VersionAtom& wanted_atom = wanted_segment[last_atom];
  if (wanted_atom.kind != VersionAtom::Kind::kText) return own_atom == wanted_atom;
  return own_atom.kind == VersionAtom::Kind::kText && own_atom.text.starts_with(wanted_atom.text);
}

std::string version_json(const std::vector<VersionSegment>& segments) {
  std::string out = "[";
  for (const VersionSegment& segment : segments) {
    if (out.back() != '[') out += ',';
    out += '[';
    for (const VersionAtom& atom : segment) {
      if (out.back() != '[') out += ',';
      switch (atom.kind) {
        case VersionAtom::Kind::kNumber:
          out += atom.text;
          break;
        case VersionAtom::Kind::kPost:
          out += "1e999";
          break;  // JSON for infinity
        case VersionAtom::Kind::kText:
          out += json_quoted(atom.text);
          break;
      }
    }
    out += ']';
  }
  return out + "]";
}

}  // namespace ros2wasm
