// See python_functions.hpp: methods of texts, lists and dictionaries.
#include <algorithm>
#include <cctype>
#include <map>

#include "bundler/launch/python/python_format.hpp"
#include "bundler/launch/python/python_function_table.hpp"
#include "bundler/launch/python/python_functions.hpp"

namespace ros2wasm {
namespace {

using Arguments = PythonArguments;

constexpr std::string_view kSpace = " \t\n\r\v\f";

const std::string& text_at(const PythonList& values, std::size_t at) {
  const auto* text = at < values.size() ? std::get_if<std::string>(&values[at].held) : nullptr;
  if (text == nullptr)
    python_fault("TypeError: a str is needed as argument " + std::to_string(at + 1));
  return *text;
}

std::size_t width_at(const Arguments& a) {
  if (a.values.empty()) python_fault("TypeError: a width is needed");
  const std::int64_t width = python_whole(a.values[0]);
  if (width > static_cast<std::int64_t>(kPythonLongest))
    python_fault("MemoryError: the result is too long");
  return static_cast<std::size_t>(std::max<std::int64_t>(0, width));
}

std::string changed_case(std::string text, int (*change)(int)) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x80) c = static_cast<char>(change(c));
  return text;
}

std::string titled(std::string text, bool first_only) {
  bool inside = false;
  for (char& c : text) {
    const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (letter) c = static_cast<char>(inside ? std::tolower(c) : std::toupper(c));
    inside = first_only || letter;
  }
  return text;
}

std::string stripped(const std::string& text, const Arguments& a, bool left, bool right) {
  const bool given = !a.values.empty() && !std::holds_alternative<PythonNone>(a.values[0].held);
  const std::string marks = given ? text_at(a.values, 0) : std::string(kSpace);
  const std::size_t begin = left ? text.find_first_not_of(marks) : 0;
  if (begin == std::string::npos || text.empty()) return {};
  const std::size_t last = right ? text.find_last_not_of(marks) : text.size() - 1;
  return last == std::string::npos ? std::string() : text.substr(begin, last - begin + 1);
}

PythonList split_at_space(const std::string& text, std::int64_t most) {
  PythonList result;
  for (std::size_t at = text.find_first_not_of(kSpace); at != std::string::npos;) {
    const bool rest = static_cast<std::int64_t>(result.size()) == most;
    const std::size_t end = rest ? text.find_last_not_of(kSpace) + 1
                                 : std::min(text.find_first_of(kSpace, at), text.size());
    result.push_back({text.substr(at, end - at)});
    at = rest ? std::string::npos : text.find_first_not_of(kSpace, end);
  }
  return result;
}

PythonList split(const std::string& text, const Arguments& a) {
  const PythonValue* limit = a.values.size() > 1 ? &a.values[1] : python_named(a, "maxsplit");
  std::int64_t most = limit != nullptr ? python_whole(*limit) : -1;
  const bool by_space = a.values.empty() || std::holds_alternative<PythonNone>(a.values[0].held);
  if (by_space) return split_at_space(text, most);
  const std::string& by = text_at(a.values, 0);
  if (by.empty()) python_fault("ValueError: empty separator");
  PythonList result;
  std::size_t begin = 0;
  for (std::size_t at = python_find(text, by); at != std::string::npos && most != 0;
       at = python_find(text, by, begin), --most) {
    result.push_back({text.substr(begin, at - begin)});
    begin = at + by.size();
  }
  result.push_back({text.substr(begin)});
  return result;
}

PythonList split_from_end(const std::string& text, const Arguments& a) {
  if (a.values.size() < 2) return split(text, a);
  const std::string& by = text_at(a.values, 0);
  if (by.empty()) python_fault("ValueError: empty separator");
  // The reversed text is searched from its beginning.
  const std::string reversed(text.rbegin(), text.rend());
  const std::string mark(by.rbegin(), by.rend());
  PythonList result;
  std::size_t begin = 0;
  const auto add_until = [&](std::size_t end) {
    result.push_back({text.substr(text.size() - end, end - begin)});
  };
  for (std::int64_t most = python_whole(a.values[1]); most != 0; --most) {
    const std::size_t at = python_find(reversed, mark, begin);
    if (at == std::string::npos) break;
    add_until(at);
    begin = at + mark.size();
  }
  add_until(text.size());
  std::reverse(result.begin(), result.end());
  return result;
}

PythonList lines(const std::string& text) {
  PythonList result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result.push_back({text.substr(begin, end - begin)});
    begin = end + 1;
  }
  return result;
}

std::string replaced(const std::string& text, const Arguments& a) {
  const std::string& what = text_at(a.values, 0);
  const std::string& with = text_at(a.values, 1);
  if (what.empty()) python_fault("ValueError: empty text to replace");
  std::string result;
  std::size_t begin = 0;
  for (std::size_t at = python_find(text, what); at != std::string::npos;
       at = python_find(text, what, begin)) {
    result += text.substr(begin, at - begin) + with;
    begin = at + what.size();
    if (result.size() > kPythonLongest) python_fault("MemoryError: the result is too long");
  }
  return result + text.substr(begin);
}

std::string joined(const std::string& by, const Arguments& a) {
  if (a.values.size() != 1) python_fault("TypeError: join() takes one argument");
  const PythonList items = python_iterated(a.values[0]);
  std::string result;
  for (std::size_t i = 0; i < items.size(); ++i) {
    result += (i > 0 ? by : "") + text_at(items, i);
    if (result.size() > kPythonLongest) python_fault("MemoryError: the result is too long");
  }
  return result;
}

/// Whether `fits` holds for the text, or for one of a tuple of them.
PythonValue any_fits(const Arguments& a, const std::function<bool(const std::string&)>& fits) {
  if (a.values.empty() || python_items(a.values[0]) == nullptr) return {fits(text_at(a.values, 0))};
  const PythonList& choices = *python_items(a.values[0]);
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (fits(text_at(choices, i))) return {true};
  return {false};
}

PythonValue place(std::size_t at) {
  return {at == std::string::npos ? std::int64_t{-1} : static_cast<std::int64_t>(at)};
}

std::int64_t times(const std::string& text, const std::string& part) {
  if (part.empty()) python_fault("ValueError: an empty text cannot be counted");
  std::int64_t result = 0;
  for (std::size_t at = python_find(text, part); at != std::string::npos;
       at = python_find(text, part, at + part.size()))
    ++result;
  return result;
}

std::string zero_filled(const std::string& text, std::size_t width) {
  if (text.size() >= width) return text;
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  return text.substr(0, sign) + std::string(width - text.size(), '0') + text.substr(sign);
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  if (text.size() >= width) return text;
  const std::string fill(width - text.size(), ' ');
  return left ? fill + text : text + fill;
}

PythonValue all_are(const std::string& text, int (*kind)(int)) {
  return {!text.empty() && std::all_of(text.begin(), text.end(), [kind](char c) {
    return kind(static_cast<unsigned char>(c)) != 0;
  })};
}

using TextMethod = PythonValue (*)(const std::string& text, const Arguments& a);

const std::map<std::string, TextMethod, std::less<>>& text_methods() {
  using S = const std::string&;
  using A = const Arguments&;
  static const std::map<std::string, TextMethod, std::less<>> table{
      {"capitalize",
       [](S s, A) { return PythonValue{titled(changed_case(s, std::tolower), true)}; }},
      {"count", [](S s, A a) { return PythonValue{times(s, text_at(a.values, 0))}; }},
      {"endswith", [](S s, A a) { return any_fits(a, [&](S end) { return s.ends_with(end); }); }},
      {"find", [](S s, A a) { return place(python_find(s, text_at(a.values, 0))); }},
      {"format", [](S s, A a) { return PythonValue{python_formatted(s, a)}; }},
      {"index",
       [](S s, A a) {
         const std::size_t at = python_find(s, text_at(a.values, 0));
         if (at == std::string::npos) python_fault("ValueError: substring not found");
         return place(at);
       }},
      {"isalnum", [](S s, A) { return all_are(s, std::isalnum); }},
      {"isalpha", [](S s, A) { return all_are(s, std::isalpha); }},
      {"isdigit", [](S s, A) { return all_are(s, std::isdigit); }},
      {"isnumeric", [](S s, A) { return all_are(s, std::isdigit); }},
      {"isspace", [](S s, A) { return all_are(s, std::isspace); }},
      {"join", [](S s, A a) { return PythonValue{joined(s, a)}; }},
      {"ljust", [](S s, A a) { return PythonValue{padded(s, width_at(a), false)}; }},
      {"lower", [](S s, A) { return PythonValue{changed_case(s, std::tolower)}; }},
      {"lstrip", [](S s, A a) { return PythonValue{stripped(s, a, true, false)}; }},
      {"removeprefix",
       [](S s, A a) {
         S part = text_at(a.values, 0);
         return PythonValue{s.starts_with(part) ? s.substr(part.size()) : s};
       }},
      {"removesuffix",
       [](S s, A a) {
         S part = text_at(a.values, 0);
         return PythonValue{s.ends_with(part) ? s.substr(0, s.size() - part.size()) : s};
       }},
      {"replace", [](S s, A a) { return PythonValue{replaced(s, a)}; }},
      {"rfind", [](S s, A a) { return place(python_rfind(s, text_at(a.values, 0))); }},
      {"rjust", [](S s, A a) { return PythonValue{padded(s, width_at(a), true)}; }},
      {"rsplit", [](S s, A a) { return PythonValue{split_from_end(s, a)}; }},
      {"rstrip", [](S s, A a) { return PythonValue{stripped(s, a, false, true)}; }},
      {"split", [](S s, A a) { return PythonValue{split(s, a)}; }},
      {"splitlines", [](S s, A) { return PythonValue{lines(s)}; }},
      {"startswith",
       [](S s, A a) { return any_fits(a, [&](S begin) { return s.starts_with(begin); }); }},
      {"strip", [](S s, A a) { return PythonValue{stripped(s, a, true, true)}; }},
      {"title", [](S s, A) { return PythonValue{titled(s, false)}; }},
      {"upper", [](S s, A) { return PythonValue{changed_case(s, std::toupper)}; }},
      {"zfill", [](S s, A a) { return PythonValue{zero_filled(s, width_at(a))}; }},
  };
  return table;
}

std::optional<PythonValue> list_method(const PythonList& items, const std::string& method,
                                       const Arguments& a) {
  if (method == "copy" && a.values.empty()) return PythonValue{items};
  if (a.values.size() != 1) return std::nullopt;
  const auto same = [&](const PythonValue& one) { return python_equal(one, a.values[0]); };
  if (method == "count")
    return PythonValue{std::int64_t{std::count_if(items.begin(), items.end(), same)}};
  if (method != "index") return std::nullopt;
  const auto at = std::find_if(items.begin(), items.end(), same);
  if (at == items.end())
    python_fault("ValueError: " + python_text(a.values[0], true) + " is not in list");
  return PythonValue{std::int64_t{at - items.begin()}};
}

std::optional<PythonValue> dict_method(const PythonDict& dict, const std::string& method,
                                       const Arguments& a) {
  if (method == "get" && (a.values.size() == 1 || a.values.size() == 2)) {
    const PythonValue* value = python_entry(dict, a.values[0]);
    if (value != nullptr) return *value;
    return a.values.size() == 2 ? a.values[1] : PythonValue{PythonNone{}};
  }
  if (method == "copy") return python_dict(dict);
  if (method != "keys" && method != "values" && method != "items") return std::nullopt;
  PythonList result;
  for (const auto& [key, value] : dict.entries)
    result.push_back(method == "keys"     ? key
                     : method == "values" ? value
                                          : PythonValue{PythonTuple{{key, value}}});
  return PythonValue{std::move(result)};
}

}  // namespace

PythonValue python_method(const PythonValue& of, const std::string& method,
                          const PythonArguments& arguments) {
  std::optional<PythonValue> result;
  if (const auto* text = std::get_if<std::string>(&of.held)) {
    const auto row = text_methods().find(method);
    if (row != text_methods().end()) return row->second(*text, arguments);
  } else if (const PythonList* items = python_items(of)) {
    result = list_method(*items, method, arguments);
  } else if (const auto* dict = std::get_if<std::shared_ptr<const PythonDict>>(&of.held)) {
    result = dict_method(**dict, method, arguments);
  }
  if (result) return std::move(*result);
  if (const auto attribute = python_attribute(of, method))
    return python_called(*attribute, arguments);
  python_fault("AttributeError: '" + std::string(python_type(of)) + "' object has no attribute '" +
               method + "'");
}

}  // namespace ros2wasm
