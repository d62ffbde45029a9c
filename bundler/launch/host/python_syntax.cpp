// See python_syntax.hpp. The messages are described in templates/python/read_syntax.mjs.
#include "bundler/launch/host/python_syntax.hpp"

#include <algorithm>
#include <chrono>
#include <string_view>

#include "bundler/build/source_hash.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/python_sandbox.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds kTimeLimit{60};  // of all texts, of its processor
constexpr const char* kReader = "read_syntax.mjs";
/// Part of the key: another one when what is asked or answered changes.
constexpr const char* kForm = "1";

fs::path place_of(const std::vector<std::string>& texts, const fs::path& kept) {
  HashBuilder key;
  key.add("syntax of Python", kForm);
  for (const std::string& text : texts) key.add("text", text);
  return kept / (key.finish() + ".json");
}

Outcome<std::vector<PythonMistake>> read_answer(const std::string& text, std::size_t count) {
  const auto json = parse_json(text, kReader, "R2W0910");
  if (!json) return json.errors();
  std::vector<PythonMistake> result;
  for (const JsonValue& item : json->items()) {
    const auto number = [&](const char* key) -> std::uint32_t {
      const JsonValue* value = item.find(key);
      const auto found = value == nullptr ? std::nullopt : value->unsigned_integer();
      return static_cast<std::uint32_t>(std::min<std::uint64_t>(found.value_or(0), 0x7fffffff));
    };
    PythonMistake one{.text = number("text"),
                      .line = number("line"),
                      .column = number("column"),
                      .length = std::max(number("length"), 1U),
                      .why = item.text_of("why")};
    if (one.text < count) result.push_back(std::move(one));
  }
  return result;
}

Outcome<std::string> ask_python(const std::vector<std::string>& texts, const PythonTools& tools,
                                const Cancellation& cancellation) {
  const fs::path reader = tools.templates / kReader;
  auto talk = Conversation::start(python_sandbox(tools.node_js, {tools.pyodide, tools.templates},
                                                 {reader.string(), tools.pyodide.string()}),
                                  cancellation);
  if (!talk) return std::move(talk).errors();
  JsonWriter question;
  question.begin_object().key("texts").begin_array();
  for (const std::string& text : texts) question.string(text);
  question.end_array().end_object();
  return (*talk)->ask(question.text(), (*talk)->patience(kTimeLimit));
}

/// The line `number` of a text, from 1.
std::string line_of(std::string_view text, std::uint32_t number) {
  for (std::uint32_t at = 1; at < number; ++at) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  std::string_view line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return std::string(line);
}

/// The byte at which a character of a line begins; all counts are from 1.
std::uint32_t byte_of(std::string_view line, std::uint32_t character) {
  std::uint32_t left = character;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(line[at]) & 0xc0U) != 0x80U;
    if (begins && --left == 0) return static_cast<std::uint32_t>(at + 1);
  }
  return static_cast<std::uint32_t>(line.size() + 1);
}

}  // namespace

Outcome<std::vector<PythonMistake>> python_mistakes(
    const std::vector<std::string>& texts, const fs::path& kept,
    const std::function<Outcome<PythonTools>()>& find_tools, const Cancellation& cancellation) {
  if (texts.empty()) return std::vector<PythonMistake>();
  const fs::path place = place_of(texts, kept);
  std::error_code error;
  if (fs::is_regular_file(place, error)) {
    const auto known = read_file(place, kMostOfText);
    auto answer = known ? read_answer(*known, texts.size()) : known.errors();
    if (answer) {
      // By that the cache sees which are in use.
      fs::last_write_time(place, fs::file_time_type::clock::now(), error);
      return answer;
    }
  }
  const auto tools = find_tools();
  if (!tools) return tools.errors();
  const auto text = ask_python(texts, *tools, cancellation);
  if (!text) return text.errors();
  auto answer = read_answer(*text, texts.size());
  // When the answer cannot be cached, the next run asks again.
  if (answer) static_cast<void>(write_file(place, *text));
  return answer;
}

Diagnostic invalid_python(const PythonMistake& mistake, const std::string& file,
                          const std::string& text) {
  std::string line = line_of(text, mistake.line);
  const std::uint32_t begin = mistake.column == 0 ? 0 : byte_of(line, mistake.column);
  const std::uint32_t end = byte_of(line, std::max(mistake.column, 1U) + mistake.length);
  return Diagnostic{.code = "R2W0528",
                    .message = "`" + file + "` is not valid Python",
                    .span = SourceSpan{.file = file,
                                       .line = mistake.line,
                                       .column = begin,
                                       .length = begin == 0 ? 1 : std::max(end, begin + 1) - begin,
                                       .line_text = std::move(line)},
                    .label = mistake.why,
                    .why = {"Python 3.12, which runs the nodes of a site, refuses it"}};
}

}  // namespace ros2wasm
