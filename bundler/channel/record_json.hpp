// Reads the JSON of one record, fast and without places for messages. simdjson ends in
// record_json.cpp.
#pragma once

#include <memory>
#include <string_view>

#include "workspace_schema/json_reader.hpp"

namespace ros2wasm {

class RecordJson {
 public:
  RecordJson();
  ~RecordJson();
  RecordJson(const RecordJson&) = delete;
  RecordJson& operator=(const RecordJson&) = delete;

  /// Of an object, only the members that a PackageRecord is made from. R2W0202.
  [[nodiscard]] Outcome<JsonValue> read(std::string_view text);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ros2wasm
