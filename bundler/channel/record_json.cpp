// See record_json.hpp.
#include "bundler/channel/record_json.hpp"

#include <simdjson.h>

namespace ros2wasm {
namespace {

namespace dom = simdjson::dom;

JsonValue value_of(const dom::element& element) {
  switch (element.type()) {
    case dom::element_type::ARRAY: {
      JsonValue::Array items;
      items.reserve(dom::array(element).size());
      for (const dom::element item : dom::array(element)) items.push_back(value_of(item));
      return JsonValue(std::move(items));
    }
    case dom::element_type::OBJECT: {
      JsonValue::Object members;
      for (const auto& [key, value] : dom::object(element))
        members.emplace_back(std::string(key), value_of(value));
      return JsonValue(std::move(members));
    }
    case dom::element_type::INT64:
      return JsonValue(std::int64_t(element));
    case dom::element_type::UINT64:
      return JsonValue(std::uint64_t(element));
    case dom::element_type::DOUBLE:
      return JsonValue(double(element));
    case dom::element_type::STRING:
      return JsonValue(std::string(std::string_view(element)));
    case dom::element_type::BOOL:
      return JsonValue(bool(element));
    case dom::element_type::NULL_VALUE:
      return JsonValue();
  }
  return JsonValue();
}

RawMember raw_member(const dom::element& element) {
  if (element.type() == dom::element_type::STRING) return std::string_view(element);
  if (element.type() != dom::element_type::ARRAY) return value_of(element);
  Texts texts;
  texts.reserve(dom::array(element).size());
  for (const dom::element item : dom::array(element)) {
    if (item.type() != dom::element_type::STRING) return value_of(element);
    texts.push_back(std::string_view(item));
  }
  return texts;
}

}  // namespace

struct RecordJson::State {
  dom::parser parser;
  std::string padded;
  JsonValue slow;  ///< of a text that the parser did not take
};

RecordJson::RecordJson() : state_(std::make_unique<State>()) {}
RecordJson::~RecordJson() = default;

Outcome<RawRecord> RecordJson::read(std::string_view text) {
  std::string& padded = state_->padded;
  padded.assign(text);
  padded.append(simdjson::SIMDJSON_PADDING, ' ');
  dom::element root;
  if (state_->parser.parse(padded.data(), text.size(), false).get(root) != simdjson::SUCCESS ||
      !root.is_object()) {
    auto slow = parse_json(text, "its record", "R2W0202");  // which says what is wrong
    if (!slow) return std::move(slow).errors();
    if (!slow->is_object())
      return Diagnostic{.code = "R2W0202", .message = "it is not JSON object"};
    state_->slow = std::move(*slow);
    return raw_record(state_->slow);
  }
  RawRecord record;
  for (const auto& [key, value] : dom::object(root)) {
    if (const auto member = record_member(key)) record[*member] = raw_member(value);
  }
  return record;
}

}  // namespace ros2wasm
