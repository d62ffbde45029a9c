// See python_record.hpp.
#include "bundler/launch/python_record.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace ros2wasm {
namespace {

constexpr const char* kWhat = "a record of Python";

std::map<std::string, std::string> texts_of(const JsonValue* json) {
  std::map<std::string, std::string> result;
  if (json == nullptr) return result;
  for (const auto& [name, value] : json->members())
    if (const std::string* text = value.string()) result[name] = *text;
  return result;
}

JsonValue parsed(const std::string& text) {
  auto json = parse_json(text, kWhat, "R2W0416");
  return json ? std::move(*json) : JsonValue();
}

void write_value(JsonWriter& json, JsonValue value) {
  if (value.is_object()) {
    json.begin_object();
    for (const auto& [name, member] : value.members()) {
      json.key(name);
      write_value(json, member);
    }
    json.end_object();
  } else if (value.is_array()) {
    json.begin_array();
    for (const JsonValue& item : value.items()) write_value(json, item);
    json.end_array();
  } else if (const std::string* text = value.string()) {
    json.string(*text);
  } else if (const auto flag = value.boolean()) {
    json.boolean(*flag);
  } else if (const auto* whole = std::get_if<std::int64_t>(&value.state())) {
    json.integer(*whole);
  } else if (const auto real = value.number()) {
    json.number(*real);
  } else {
    json.null();
  }
}

/// The answer with what the function changed in `before`, done in `now`.
std::string with_configurations(const std::string& answer,
                                const std::map<std::string, std::string>& before,
                                std::map<std::string, std::string> now) {
  JsonValue json = parsed(answer);
  if (json.find("configurations") == nullptr) return answer;
  const auto after = texts_of(json.find("configurations"));
  for (const auto& [name, value] : before)
    if (!after.contains(name)) now.erase(name);
  for (const auto& [name, value] : after) {
    const auto old = before.find(name);
    if (old == before.end() || old->second != value) now[name] = value;
  }
  JsonWriter result;
  result.begin_object();
  for (const auto& [name, value] : json.members()) {
    if (name == "configurations") continue;
    result.key(name);
    write_value(result, value);
  }
  result.key("configurations").begin_object();
  for (const auto& [name, value] : now) result.field(name, value);
  return result.end_object().end_object().text();
}

}  // namespace

PythonRecord::PythonRecord(std::vector<PythonExchange> exchanges) {
  for (PythonExchange& one : exchanges) add(std::move(one));
}

PythonRecord::Question PythonRecord::question_of(const std::string& request) {
  const JsonValue json = parsed(request);
  Question result{.kind = json.text_of("do"),
                  .subject = json.text_of("path"),
                  .configurations = texts_of(json.find("configurations")),
                  .environment = texts_of(json.find("environment")),
                  .reads = std::nullopt};
  if (const JsonValue* number = json.find("number"))
    result.subject = std::to_string(number->integer().value_or(-1));
  return result;
}

void PythonRecord::add(PythonExchange exchange) {
  Question question = question_of(exchange.request);
  const JsonValue answer = parsed(exchange.answer);
  if (const JsonValue* reads = answer.find("reads"); reads != nullptr && reads->is_array()) {
    question.reads.emplace();
    for (const JsonValue& name : reads->items())
      if (const std::string* text = name.string()) question.reads->insert(*text);
  }
  places_[{question.kind, question.subject}].push_back(exchanges_.size());
  exchanges_.push_back(std::move(exchange));
  questions_.push_back(std::move(question));
}

/// A launch file is given no launch configurations when it is loaded; a file is read as the
/// function before left it.
bool PythonRecord::fits(std::size_t number, const Question& asked,
                        const Evaluation& evaluation) const {
  const Question& known = questions_[number];
  if (asked.kind == "read") return exchanges_[number].after == evaluation.last;
  if (known.environment != asked.environment) return false;
  if (asked.kind == "load") return true;
  if (!known.reads) return known.configurations == asked.configurations;
  return std::all_of(known.reads->begin(), known.reads->end(), [&](const std::string& name) {
    const auto one = known.configurations.find(name);
    const auto other = asked.configurations.find(name);
    if (one == known.configurations.end() || other == asked.configurations.end())
      return one == known.configurations.end() && other == asked.configurations.end();
    return one->second == other->second;
  });
}

/// A matching exchange, preferably one that this evaluation has not used yet.
std::optional<std::size_t> PythonRecord::known(const Question& asked, const Evaluation& evaluation,
                                               bool exactly) const {
  const auto places = places_.find({asked.kind, asked.subject});
  if (places == places_.end()) return std::nullopt;
  std::optional<std::size_t> result;
  for (const std::size_t number : places->second) {
    if (exactly && !fits(number, asked, evaluation)) continue;
    if (!evaluation.used.contains(number)) return number;
    if (!result) result = number;
  }
  return result;
}

std::string PythonRecord::answered(std::size_t number, const Question& asked,
                                   Evaluation& evaluation,
                                   const std::function<std::string(const std::string&)>& reply) {
  const PythonExchange& exchange = exchanges_[number];
  evaluation.used.insert(number);
  if (asked.kind != "read") evaluation.last = number;
  // Ask its questions again: log messages must be printed again, other questions change nothing.
  for (const std::string& one : exchange.asked) static_cast<void>(reply(one));
  const auto& before = questions_[number].configurations;
  if (asked.kind == "read" || before == asked.configurations) return exchange.answer;
  return with_configurations(exchange.answer, before, asked.configurations);
}

LaunchPython PythonRecord::recording(LaunchPython python) {
  const auto evaluation = std::make_shared<Evaluation>();
  return [this, evaluation, python = std::move(python)](const std::string& request,
                                                        const auto& reply) -> Outcome<std::string> {
    const Question asked = question_of(request);
    if (const auto number = known(asked, *evaluation, true);
        number && !evaluation->used.contains(*number))
      return answered(*number, asked, *evaluation, reply);
    PythonExchange exchange{
        .request = request, .asked = {}, .answer = {}, .after = evaluation->last};
    auto answer = python(request, [&](const std::string& text) {
      exchange.asked.push_back(text);
      return reply(text);
    });
    if (!answer) return answer;
    exchange.answer = *answer;
    const std::size_t number = exchanges_.size();
    evaluation->used.insert(number);
    if (asked.kind != "read") evaluation->last = number;
    add(std::move(exchange));
    return answer;
  };
}

LaunchPython PythonRecord::replaying(std::function<void()> decided) {
  const auto evaluation = std::make_shared<Evaluation>();
  return [this, evaluation, decided = std::move(decided)](
             const std::string& request, const auto& reply) -> Outcome<std::string> {
    const Question asked = question_of(request);
    auto number = known(asked, *evaluation, true);
    if (!number) {
      number = known(asked, *evaluation, false);
      if (number) decided();
    }
    if (number) return answered(*number, asked, *evaluation, reply);
    decided();
    return Diagnostic{
        .code = "R2W0732",
        .message = "the launch arguments lead to Python that was not run when the site was packed",
        .why = {asked.kind == "load"
                    ? "it is the launch file " + asked.subject
                    : "this site has no Python that reads launch files, only what it "
                      "answered for the values of arguments that were tried"},
        .fix = {"list the values as `choices` of the argument, and pack again"}};
  };
}

void write_python_exchanges(JsonWriter& json, const std::vector<PythonExchange>& exchanges) {
  json.begin_array();
  for (const PythonExchange& one : exchanges) {
    json.begin_object().field("request", one.request).field("answer", one.answer);
    if (!one.asked.empty()) {
      json.key("asked").begin_array();
      for (const std::string& text : one.asked) json.string(text);
      json.end_array();
    }
    if (one.after) json.field_integer("after", static_cast<std::int64_t>(*one.after));
    json.end_object();
  }
  json.end_array();
}

std::vector<PythonExchange> read_python_exchanges(const JsonValue* json) {
  std::vector<PythonExchange> result;
  if (json == nullptr) return result;
  for (const JsonValue& item : json->items()) {
    PythonExchange one{.request = item.text_of("request"),
                       .asked = {},
                       .answer = item.text_of("answer"),
                       .after = std::nullopt};
    if (const JsonValue* asked = item.find("asked"))
      for (const JsonValue& text : asked->items())
        if (text.string() != nullptr) one.asked.push_back(*text.string());
    const JsonValue* after = item.find("after");
    if (const auto number = after == nullptr ? std::nullopt : after->unsigned_integer())
      one.after = static_cast<std::size_t>(*number);
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace ros2wasm
