// Every version of the public list has the form that conda gives it, and our order of them is the
// one that conda's rule makes of those forms.
#include "workspace_schema/conda/version.hpp"

#include <algorithm>
#include <sstream>

#include "conda_data/conda_data.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

struct Line {
  Version version;
  std::string form;  ///< conda's nested list, as JSON, with `true` for infinity
};

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    text.replace(at, what.size(), with);
  return text;
}

std::vector<Line> public_versions() {
  std::istringstream stream(testing::conda_text("parsed_versions.txt"));
  std::vector<Line> lines;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t equals = line.find('=');
    auto version = Version::parse(line.substr(0, equals));
    EXPECT_TRUE(version.ok()) << line;
    if (!version) continue;
    std::string form = line.substr(equals + 1);
    std::erase(form, ' ');
    std::replace(form.begin(), form.end(), '\'', '"');
    lines.push_back({.version = std::move(*version), .form = replaced(form, ",inf", ",true")});
  }
  return lines;
}

TEST(PublicVersions, ParseToTheSameForm) {
  const std::vector<Line> lines = public_versions();
  EXPECT_GT(lines.size(), 10'000U);
  for (const Line& line : lines) {
    EXPECT_EQ(replaced(version_json(line.version.segments()), "1e999", "true"), line.form)
        << line.version.text();
  }
}

// Conda's rule, once more and from the forms alone: lists are compared part by part, the shorter
// one filled up with [] and 0; words are before numbers, infinity is behind them.

int compared(const JsonValue& a, const JsonValue& b) {
  const auto kind = [](const JsonValue& one) { return one.string() ? 0 : one.boolean() ? 2 : 1; };
  if (kind(a) != kind(b)) return kind(a) < kind(b) ? -1 : 1;
  if (kind(a) == 0) return a.string()->compare(*b.string());
  if (kind(a) == 2) return 0;
  const auto left = a.unsigned_integer();
  const auto right = b.unsigned_integer();
  EXPECT_TRUE(left && right);
  return left < right ? -1 : left > right ? 1 : 0;
}

int segments_compared(const JsonValue& a, const JsonValue& b) {
  const JsonValue zero(std::uint64_t{0});
  const std::size_t count = std::max(a.items().size(), b.items().size());
  for (std::size_t i = 0; i < count; ++i) {
    const JsonValue& left = i < a.items().size() ? a.items()[i] : zero;
    const JsonValue& right = i < b.items().size() ? b.items()[i] : zero;
    if (const int order = compared(left, right); order != 0) return order;
  }
  return 0;
}

int forms_compared(const JsonValue& a, const JsonValue& b) {
  const JsonValue empty(JsonValue::Array{});
  const std::size_t count = std::max(a.items().size(), b.items().size());
  for (std::size_t i = 0; i < count; ++i) {
    const JsonValue& left = i < a.items().size() ? a.items()[i] : empty;
    const JsonValue& right = i < b.items().size() ? b.items()[i] : empty;
    if (const int order = segments_compared(left, right); order != 0) return order;
  }
  return 0;
}

TEST(PublicVersions, SortTheSame) {
  std::vector<Line> lines = public_versions();
  std::sort(lines.begin(), lines.end(),
            [](const Line& a, const Line& b) { return a.version < b.version; });
  ASSERT_GT(lines.size(), 10'000U);
  std::vector<JsonValue> forms;
  for (const Line& line : lines) {
    auto form = parse_json(line.form, line.version.text(), "R2W0304");
    ASSERT_TRUE(form.ok()) << line.form;
    forms.push_back(std::move(*form));
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Version& before = lines[i - 1].version;
    const Version& after = lines[i].version;
    const int order = forms_compared(forms[i - 1], forms[i]);
    EXPECT_LE(order, 0) << before.text() << " and " << after.text();
    // The forms do not include the part after a `+`.
    if (before.local().empty() && after.local().empty()) {
      EXPECT_EQ(order == 0, before == after) << before.text() << " and " << after.text();
    }
  }
}

}  // namespace
}  // namespace ros2wasm
