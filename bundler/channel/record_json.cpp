// See record_json.hpp.
#include "bundler/channel/record_json.hpp"

#include <simdjson.h>

#include <algorithm>

#include "bundler/channel/repodata_record.hpp"

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

}  // namespace

struct RecordJson::State {
  dom::parser parser;
  std::string padded;
};

RecordJson::RecordJson() : state_(std::make_unique<State>()) {}
RecordJson::~RecordJson() = default;

Outcome<JsonValue> RecordJson::read(std::string_view text) {
  std::string& padded = state_->padded;
  padded.assign(text);
  padded.append(simdjson::SIMDJSON_PADDING, ' ');
  dom::element root;
  if (state_->parser.parse(padded.data(), text.size(), false).get(root) != simdjson::SUCCESS ||
      !root.is_object()) {
    return parse_json(text, "its record", "R2W0202");  // which says what is wrong, or takes it
  }
  JsonValue::Object members;
  members.reserve(16);
  for (const auto& [key, value] : dom::object(root)) {
    if (!is_record_member(key)) continue;
    const auto same =
        std::find_if(members.begin(), members.end(),
                     [&key = key](const auto& member) { return member.first == key; });
    if (same == members.end()) {
      members.emplace_back(std::string(key), value_of(value));
    } else {
      same->second = value_of(value);  // a repeated key keeps the last value
    }
  }
  return JsonValue(std::move(members));
}

}  // namespace ros2wasm
