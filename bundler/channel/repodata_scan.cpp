// See repodata_scan.hpp.
#include "bundler/channel/repodata_scan.hpp"

#include <cstring>

namespace ros2wasm {
namespace {

constexpr std::uint32_t kLongestRecord = 64U << 20U;

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

const char* skip_space(const char* at, const char* end) {
  while (at != end && is_space(*at)) ++at;
  return at;
}

/// Behind the string that begins at `at`, or nullptr when its end is not there yet.
const char* skip_string(const char* at, const char* end) {
  const char* from = at + 1;
  for (;;) {
    const auto* quote =
        static_cast<const char*>(std::memchr(from, '"', static_cast<std::size_t>(end - from)));
    if (quote == nullptr) return nullptr;
    const char* before = quote;
    while (before != at + 1 && before[-1] == '\\') --before;
    if ((quote - before) % 2 == 0) return quote + 1;
    from = quote + 1;
  }
}

/// Behind the value that begins at `at`, or nullptr when its end is not there yet. Brackets are
/// counted, not matched: who parses the value sees what is wrong inside.
const char* skip_value(const char* at, const char* end) {
  if (at == end) return nullptr;
  if (*at == '"') return skip_string(at, end);
  if (*at != '{' && *at != '[') {
    const char* last = at;
    while (last != end && *last != ',' && *last != '}' && *last != ']' && !is_space(*last)) ++last;
    return last == end ? nullptr : last;
  }
  std::size_t depth = 0;
  while (at != end) {
    const char c = *at;
    if (c == '"') {
      at = skip_string(at, end);
      if (at == nullptr) return nullptr;
      continue;
    }
    ++at;
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && --depth == 0) return at;
  }
  return nullptr;
}

/// The text of the member `name` of a whole object; empty when there is none that is plain text.
std::string_view name_in(std::string_view object) {
  if (object.empty() || object.front() != '{') return {};
  const char* at = object.data() + 1;
  const char* const end = object.data() + object.size();
  for (;;) {
    at = skip_space(at, end);
    if (at == end || *at != '"') return {};
    const char* key_end = skip_string(at, end);
    if (key_end == nullptr) return {};
    const std::string_view key(at, static_cast<std::size_t>(key_end - at));
    at = skip_space(key_end, end);
    if (at == end || *at != ':') return {};
    at = skip_space(at + 1, end);
    const char* value_end = skip_value(at, end);
    if (value_end == nullptr) return {};
    if (key == "\"name\"") {
      const std::string_view value(at, static_cast<std::size_t>(value_end - at));
      const bool plain =
          value.size() > 2 && value.front() == '"' && value.find('\\') == std::string_view::npos;
      return plain ? value.substr(1, value.size() - 2) : std::string_view();
    }
    at = skip_space(value_end, end);
    if (at == end || *at != ',') return {};
    ++at;
  }
}

}  // namespace

std::optional<std::string> RepodataScanner::feed(std::string_view piece) {
  if (!kept_.empty()) {
    kept_ += piece;
    text_ = kept_;
  } else {
    text_ = piece;
  }
  at_ = 0;
  Step result = Step::kDone;
  while (result == Step::kDone) result = step();
  if (result == Step::kFault) {
    return "byte " + std::to_string(passed_ + at_ + 1) +
           (passed_ == 0 && place_ == Place::kBegin ? ": it is not JSON object"
                                                    : ": this is not JSON");
  }
  std::string rest(text_.substr(at_));
  passed_ += at_;
  kept_ = std::move(rest);
  return std::nullopt;
}

std::optional<std::string> RepodataScanner::finish() {
  const bool nothing = place_ == Place::kBegin && kept_.empty();  // CEP 26: an empty channel
  if (nothing || (place_ == Place::kEnd && kept_.empty())) return std::nullopt;
  return "it ends too early";
}

RepodataScanner::Step RepodataScanner::expect(char first, Place then_first, char second,
                                              Place then_second) {
  if (text_[at_] == first) {
    place_ = then_first;
  } else if (text_[at_] == second) {
    place_ = then_second;
  } else {
    return Step::kFault;
  }
  ++at_;
  return Step::kDone;
}

RepodataScanner::Step RepodataScanner::step() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  if (at_ == text_.size()) return Step::kMore;
  switch (place_) {
    case Place::kBegin:
      return expect('{', Place::kFirstKey, '{', Place::kFirstKey);
    case Place::kFirstKey:
      if (text_[at_] == '}') return expect('}', Place::kEnd, '}', Place::kEnd);
      return member();
    case Place::kKey:
      return member();
    case Place::kComma:
      return expect(',', Place::kKey, '}', Place::kEnd);
    case Place::kFirstRecord:
      if (text_[at_] == '}') return expect('}', Place::kComma, '}', Place::kComma);
      return record();
    case Place::kRecord:
      return record();
    case Place::kRecordComma:
      return expect(',', Place::kRecord, '}', Place::kComma);
    case Place::kEnd:
      return Step::kFault;
  }
  return Step::kFault;
}

/// A member of the outermost object: the maps of records are gone into, others are passed over.
RepodataScanner::Step RepodataScanner::member() {
  const char* const begin = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  if (*begin != '"') return Step::kFault;
  const char* key_end = skip_string(begin, end);
  if (key_end == nullptr) return Step::kMore;
  const std::string_view key(begin + 1, static_cast<std::size_t>(key_end - begin) - 2);
  const char* at = skip_space(key_end, end);
  if (at == end) return Step::kMore;
  if (*at != ':') return Step::kFault;
  at = skip_space(at + 1, end);
  if (at == end) return Step::kMore;
  if ((key == "packages" || key == "packages.conda") && *at == '{') {
    conda_ = key == "packages.conda";
    place_ = Place::kFirstRecord;
    at_ = static_cast<std::size_t>(at + 1 - text_.data());
    return Step::kDone;
  }
  const char* value_end = skip_value(at, end);
  if (value_end == nullptr) return Step::kMore;
  const std::string_view value(at, static_cast<std::size_t>(value_end - at));
  if (value.empty()) return Step::kFault;
  if (key == "info") info_ = value;
  if (key == "removed") removed_ = value;
  place_ = Place::kComma;
  at_ = static_cast<std::size_t>(value_end - text_.data());
  return Step::kDone;
}

RepodataScanner::Step RepodataScanner::record() {
  const char* const begin = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  if (*begin != '"') return Step::kFault;
  const char* key_end = skip_string(begin, end);
  if (key_end == nullptr) return Step::kMore;
  const char* at = skip_space(key_end, end);
  if (at == end) return Step::kMore;
  if (*at != ':') return Step::kFault;
  at = skip_space(at + 1, end);
  const char* value_end = skip_value(at, end);
  const char* const known_end = value_end == nullptr ? end : value_end;
  if (static_cast<std::uint64_t>(known_end - begin) > kLongestRecord) return Step::kFault;
  if (value_end == nullptr) return Step::kMore;
  if (value_end == at) return Step::kFault;
  found_({.name = name_in({at, static_cast<std::size_t>(value_end - at)}),
          .text = {begin, static_cast<std::size_t>(value_end - begin)},
          .offset = passed_ + at_,
          .conda = conda_});
  place_ = Place::kRecordComma;
  at_ = static_cast<std::size_t>(value_end - text_.data());
  return Step::kDone;
}

}  // namespace ros2wasm
