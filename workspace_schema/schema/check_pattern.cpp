// See check_pattern.hpp. Reads an expression by descent, and learns of each part whether it has one
// length and which bytes it can begin with.
#include "workspace_schema/schema/check_pattern.hpp"

#include <algorithm>
#include <bitset>

namespace ros2wasm {
namespace {

constexpr std::size_t kLongest = 256;
constexpr std::size_t kDeepest = 16;
constexpr std::size_t kLargestCount = 100;
/// The limit on endless repetitions: each multiplies the longest time by the length of a line.
constexpr std::size_t kMostEndless = 5;
/// The limit for the whole pattern: the number of ways that may be tried from one place in a line.
constexpr std::size_t kMostWays = 100'000;
/// The ways that an endless repetition counts as; kMostEndless limits their number.
constexpr std::size_t kWaysOfEndless = 5;

/// Up to one more than kMostWays.
std::size_t bounded(std::size_t ways) {
  return std::min(ways, kMostWays + 1);
}

using Bytes = std::bitset<256>;

/// The texts that an expression, or a part of it, can match.
struct Part {
  Bytes first;             ///< with which it can begin
  bool empty = false;      ///< it can match nothing at all
  bool varies = false;     ///< it has a repetition whose count is not fixed
  bool ambiguous = false;  ///< two of its alternatives can begin alike
  std::size_t ways = 1;    ///< in which it can be tried at one place, at most; see bounded()
};

class PatternReader {
 public:
  explicit PatternReader(std::string_view text) : text_(text) {}

  std::optional<PatternFault> read() {
    if (text_.empty()) return PatternFault{.why = "it is empty", .length = 0};
    if (text_.size() > kLongest)
      return PatternFault{.why = "it is longer than 256 bytes", .offset = kLongest};
    const Part whole = alternatives(0);
    if (!fault_ && at_ < text_.size()) fail("a parenthesis is not opened");
    if (whole.ways > kMostWays)
      fail_at(0, "it can be tried in more than 100000 ways: too much of it varies in length",
              text_.size());
    return fault_;
  }

 private:
  [[nodiscard]] bool more() const { return !fault_ && at_ < text_.size(); }
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  void fail(std::string why, std::size_t length = 1) { fail_at(at_, std::move(why), length); }
  void fail_at(std::size_t offset, std::string why, std::size_t length = 1) {
    if (!fault_) fault_ = PatternFault{.why = std::move(why), .offset = offset, .length = length};
  }

  // NOLINTNEXTLINE(misc-no-recursion): bounded by kDeepest.
  Part alternatives(std::size_t depth) {
    Part all = sequence(depth);
    while (more() && peek() == '|') {
      ++at_;
      const Part next = sequence(depth);
      const bool alike = all.empty || next.empty || (all.first & next.first).any();
      all.ambiguous = all.ambiguous || next.ambiguous || alike;
      all.ways = alike ? bounded(all.ways + next.ways) : std::max(all.ways, next.ways);
      all.first |= next.first;
      all.empty = all.empty || next.empty;
      all.varies = all.varies || next.varies;
    }
    return all;
  }

  // NOLINTNEXTLINE(misc-no-recursion): bounded by kDeepest.
  Part sequence(std::size_t depth) {
    Part all{.empty = true};
    while (more() && peek() != '|' && peek() != ')') {
      const std::size_t begin = at_;
      bool assertion = false;
      Part part = atom(depth, assertion);
      if (!fault_) repetition(part, begin, assertion);
      if (all.empty) all.first |= part.first;
      all.empty = all.empty && part.empty;
      all.varies = all.varies || part.varies;
      all.ambiguous = all.ambiguous || part.ambiguous;
      all.ways = bounded(all.ways * part.ways);
    }
    return all;
  }

  /// One character, class or group.
  // NOLINTNEXTLINE(misc-no-recursion): bounded by kDeepest.
  Part atom(std::size_t depth, bool& assertion) {
    const char c = peek();
    Part part;
    switch (c) {
      case '(':
        return group(depth);
      case '[':
        bracket(part.first);
        return part;
      case '\\':
        assertion = peek(1) == 'b' || peek(1) == 'B';
        part.empty = assertion;
        if (assertion) {
          at_ += 2;
        } else {
          escape(part.first, false);
        }
        return part;
      case '^':
      case '$':
        assertion = true;
        part.empty = true;
        ++at_;
        return part;
      case '.':
        part.first.set();
        ++at_;
        return part;
      case '*':
      case '+':
      case '?':
        fail("there is nothing to repeat");
        return part;
      case '{':
      case '}':
      case ']':
        fail(std::string("`") + c + "` must be written `\\" + c + "` when it means itself");
        return part;
      default:
        part.first.set(static_cast<unsigned char>(c));
        ++at_;
        return part;
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): bounded by kDeepest.
  Part group(std::size_t depth) {
    const std::size_t begin = at_;
    Part part;
    if (depth == kDeepest) {
      fail("its groups are nested too deep");
      return part;
    }
    if (peek(1) == '?' && peek(2) != ':') {
      fail("look-around and named groups are not supported", 3);
      return part;
    }
    at_ += peek(1) == '?' ? 3 : 1;
    part = alternatives(depth + 1);
    if (fault_) return part;
    if (peek() != ')') {
      fail_at(begin, "a parenthesis is not closed");
    } else {
      ++at_;
    }
    return part;
  }

  /// Behind an atom: `*`, `+`, `?`, a count, each perhaps with `?`.
  void repetition(Part& part, std::size_t begin, bool assertion) {
    if (!more()) return;
    const std::size_t sign = at_;
    std::size_t least = 0;
    std::optional<std::size_t> most;
    switch (peek()) {
      case '*':
        ++at_;
        break;
      case '+':
        least = 1;
        ++at_;
        break;
      case '?':
        most = 1;
        ++at_;
        break;
      case '{':
        if (!count(least, most)) return;
        break;
      default:
        return;
    }
    if (peek() == '?') ++at_;
    if (more() && (peek() == '*' || peek() == '+' || peek() == '?' || peek() == '{')) {
      fail("a repetition cannot be repeated");
      return;
    }
    if (assertion) {
      fail_at(sign, "there is nothing to repeat");
      return;
    }
    const bool repeats = !most || *most > 1;
    if (repeats && (part.varies || part.empty)) {
      fail_at(begin, "what repeats with different counts cannot be repeated again", at_ - begin);
      return;
    }
    if (repeats && part.ambiguous) {
      fail_at(begin, "alternatives that can begin alike cannot be repeated", at_ - begin);
      return;
    }
    if (!most && ++endless_ > kMostEndless) {
      fail_at(sign, "it has more than 5 repetitions without an end");
      return;
    }
    part.varies = part.varies || !most || *most != least;
    part.ways = bounded(part.ways * (most ? *most - least + 1 : kWaysOfEndless));
    part.empty = part.empty || least == 0;
  }

  /// `{2}`, `{2,}`, `{2,3}`.
  bool count(std::size_t& least, std::optional<std::size_t>& most) {
    const std::size_t begin = at_;
    ++at_;
    const auto number = [this]() -> std::optional<std::size_t> {
      if (peek() < '0' || peek() > '9') return std::nullopt;
      std::size_t value = 0;
      for (; peek() >= '0' && peek() <= '9'; ++at_)
        value = std::min<std::size_t>(kLargestCount + 1,
                                      value * 10 + static_cast<std::size_t>(peek() - '0'));
      return value;
    };
    const auto first = number();
    const bool comma = peek() == ',';
    if (comma) ++at_;
    const auto last = comma ? number() : first;
    const bool closed = peek() == '}';
    if (closed) ++at_;
    if (!first || !closed || (last && *last < *first)) {
      fail_at(begin, "a count is written `{2}`, `{2,}` or `{2,3}`");
      return false;
    }
    if (*first > kLargestCount || (last && *last > kLargestCount)) {
      fail_at(begin, "counts go up to 100", at_ - begin);
      return false;
    }
    least = *first;
    most = last;
    return true;
  }

  static void add(Bytes& set, unsigned char from, unsigned char to) {
    for (unsigned c = from; c <= to; ++c) set.set(c);
  }

  /// The set of `\d`, `\w` or `\s`; false for another letter.
  static bool add_class(Bytes& set, char letter) {
    Bytes found;
    switch (letter | 0x20) {
      case 'd':
        add(found, '0', '9');
        break;
      case 'w':
        add(found, '0', '9');
        add(found, 'a', 'z');
        add(found, 'A', 'Z');
        found.set('_');
        break;
      case 's':
        add(found, '\t', '\r');
        found.set(' ');
        // The white space of Unicode, by what its bytes begin with.
        add(found, 0xc2, 0xef);
        break;
      default:
        return false;
    }
    const bool negated = letter < 'a';
    set |= negated ? ~found | (Bytes().set() << 128) : found;
    return true;
  }

  /// One escaped character; gives the byte when it stands for one, else 0 for a class.
  unsigned char escape(Bytes& set, bool in_bracket) {
    constexpr std::string_view kSyntax = "^$\\.*+?()[]{}|/";
    const char c = peek(1);
    constexpr std::string_view kControls = "tnrfv";
    constexpr std::string_view kMeant = "\t\n\r\f\v";
    if (c != '\0' && kSyntax.find(c) != std::string_view::npos) {
      set.set(static_cast<unsigned char>(c));
    } else if (in_bracket && c == '-') {
      set.set('-');
    } else if (const auto control = kControls.find(c);
               c != '\0' && control != std::string_view::npos) {
      set.set(static_cast<unsigned char>(kMeant[control]));
      at_ += 2;
      return static_cast<unsigned char>(kMeant[control]);
    } else if (add_class(set, c)) {
      at_ += 2;
      return 0;
    } else {
      const bool digit = c >= '0' && c <= '9';
      fail(c == '\0' ? "it ends with `\\`"
           : digit   ? std::string("back-references are not supported")
                     : std::string("this `\\` is not supported"),
           c == '\0' ? 1 : 2);
      return 0;
    }
    at_ += 2;
    return static_cast<unsigned char>(c);
  }

  void bracket(Bytes& set) {
    const std::size_t begin = at_;
    ++at_;
    const bool negated = peek() == '^';
    if (negated) ++at_;
    Bytes inside;
    if (peek() == ']') {
      fail_at(begin, "a class in brackets has at least one character", 2);
      return;
    }
    while (more() && peek() != ']') {
      const unsigned char from = member(inside);
      if (!more() || peek() != '-') continue;
      if (peek(1) == ']') continue;
      const std::size_t sign = at_;
      ++at_;
      const unsigned char to = member(inside);
      if (fault_) return;
      if (from == 0 || to == 0 || to < from) {
        fail_at(sign, from == 0 || to == 0 ? "a range is between two characters"
                                           : "a range in brackets goes backwards");
        return;
      }
      add(inside, from, to);
    }
    if (fault_) return;
    if (peek() != ']') {
      fail_at(begin, "a bracket is not closed");
      return;
    }
    ++at_;
    // Only the first byte of a character of several bytes is checked, so a negated set has all
    // bytes from 128 on.
    set |= negated ? ~inside | (Bytes().set() << 128) : inside;
  }

  /// One member of a bracket: its byte, or 0 for a class of characters or one of several bytes.
  unsigned char member(Bytes& inside) {
    const char c = peek();
    if (c == '\\') return escape(inside, true);
    if (c == '[') {
      fail("`[` must be written `\\[` in brackets");
      return 0;
    }
    const auto byte = static_cast<unsigned char>(c);
    inside.set(byte);
    ++at_;
    if (byte < 0x80) return byte;
    while ((static_cast<unsigned char>(peek()) & 0xC0U) == 0x80) {
      inside.set(static_cast<unsigned char>(peek()));
      ++at_;
    }
    return 0;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t endless_ = 0;
  std::optional<PatternFault> fault_;
};

}  // namespace

std::optional<PatternFault> check_pattern_fault(std::string_view text) {
  return PatternReader(text).read();
}

}  // namespace ros2wasm
