// See python_transcript.hpp.
#include "bundler/launch/host/python_transcript.hpp"

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr int kKeptSchema = 1;
constexpr const char* kWhat = "the cached values of a launch file";

Diagnostic other_words() {
  return {.code = "R2W0416",
          .message = "a launch file in Python does not do again what it did before",
          .why = {"its result is cached, and all that it read is unchanged"},
          .fix = {"run the command again"}};
}

std::optional<SeenPaths> seen_in(const JsonValue* json) {
  if (json == nullptr || !json->is_object()) return std::nullopt;
  SeenPaths result;
  for (const auto& [path, state] : json->members()) {
    const std::string* text = state.string();
    if (text == nullptr) return std::nullopt;
    result.emplace_back(path, *text);
  }
  return result;
}

std::optional<PythonRemark> remark_in(const JsonValue& json) {
  const JsonValue* request = json.find("request");
  const JsonValue* answer = json.find("answer");
  const JsonValue* asked = json.find("asked");
  if (request == nullptr || answer == nullptr || asked == nullptr || !asked->is_array() ||
      request->string() == nullptr || answer->string() == nullptr)
    return std::nullopt;
  PythonRemark result{.request = *request->string(), .asked = {}, .answer = *answer->string()};
  for (const JsonValue& one : asked->items()) {
    const JsonValue* text = one.find("text");
    const JsonValue* told = one.find("told");
    if (text == nullptr || told == nullptr || text->string() == nullptr ||
        told->string() == nullptr)
      return std::nullopt;
    result.asked.emplace_back(*text->string(), *told->string());
  }
  return result;
}

}  // namespace

Outcome<std::string> PythonTranscript::ask(
    const std::string& request, const std::function<std::string(const std::string&)>& reply) {
  Told told;
  if (!is_live_ && next_ < remarks_.size() && remarks_[next_].request == request) {
    const PythonRemark& one = remarks_[next_];
    bool is_same = true;
    for (std::size_t i = 0; is_same && i < one.asked.size(); ++i) {
      told.emplace_back(one.asked[i].first, reply(one.asked[i].first));
      is_same = told.back().second == one.asked[i].second;
    }
    if (is_same) {
      ++next_;
      return one.answer;
    }
  }
  if (!is_live_) {
    if (auto ready = catch_up(); !ready) {
      has_failed_ = true;
      return ready.errors();
    }
  }
  auto answer = ask_live(request, told, reply);
  if (!answer) has_failed_ = true;
  return answer;
}

Outcome<Done> PythonTranscript::end() {
  if (is_live_ || next_ == remarks_.size()) return Done{};
  auto ready = catch_up();
  has_failed_ = !ready;
  return ready;
}

/// Asks all again that was answered from memory, with what was told then.
Outcome<Done> PythonTranscript::catch_up() {
  is_live_ = true;
  remarks_.resize(next_);
  for (const PythonRemark& one : remarks_) {
    std::size_t count = 0;
    bool is_same = true;
    const auto answer = live_(one.request, [&](const std::string& text) -> std::string {
      is_same = is_same && count < one.asked.size() && one.asked[count].first == text;
      return is_same ? one.asked[count++].second : "{}";
    });
    if (!answer) return answer.errors();
    if (!is_same || count != one.asked.size() || *answer != one.answer) return other_words();
  }
  return Done{};
}

/// `told`: what was asked and told already, which is not done twice.
Outcome<std::string> PythonTranscript::ask_live(
    const std::string& request, const Told& told,
    const std::function<std::string(const std::string&)>& reply) {
  PythonRemark made{.request = request, .asked = {}, .answer = {}};
  bool is_same = true;
  auto answer = live_(request, [&](const std::string& text) {
    const std::size_t number = made.asked.size();
    is_same = is_same && (number >= told.size() || told[number].first == text);
    made.asked.emplace_back(text,
                            number < told.size() && is_same ? told[number].second : reply(text));
    return made.asked.back().second;
  });
  if (!answer) return answer;
  if (!is_same || made.asked.size() < told.size()) return other_words();
  made.answer = *answer;
  remarks_.push_back(std::move(made));
  return answer;
}

std::string kept_python_json(const KeptPython& kept) {
  JsonWriter json;
  json.begin_object().field_integer("schema", kKeptSchema).key("remarks").begin_array();
  for (const PythonRemark& one : kept.remarks) {
    json.begin_object().field("request", one.request).key("asked").begin_array();
    for (const auto& [text, told] : one.asked)
      json.begin_object().field("text", text).field("told", told).end_object();
    json.end_array().field("answer", one.answer).end_object();
  }
  json.end_array().key("seen").begin_object();
  for (const auto& [path, state] : kept.seen) json.field(path, state);
  return json.end_object().end_object().text();
}

std::optional<KeptPython> read_kept_python(std::string_view text) {
  const auto json = parse_json(text, kWhat, "R2W0416");
  if (!json) return std::nullopt;
  const JsonValue* schema = json->find("schema");
  const JsonValue* remarks = json->find("remarks");
  auto seen = seen_in(json->find("seen"));
  if (schema == nullptr || schema->integer() != kKeptSchema || remarks == nullptr ||
      !remarks->is_array() || !seen)
    return std::nullopt;
  KeptPython result{.remarks = {}, .seen = std::move(*seen)};
  for (const JsonValue& item : remarks->items()) {
    auto one = remark_in(item);
    if (!one) return std::nullopt;
    result.remarks.push_back(std::move(*one));
  }
  return result;
}

std::optional<SeenPaths> read_seen_paths(std::string_view text) {
  const auto json = parse_json(text, "what Python saw", "R2W0416");
  return json ? seen_in(&*json) : std::nullopt;
}

}  // namespace ros2wasm
