// Reads the JSON of one record, fast and without places for messages. simdjson ends in
// record_json.cpp.
#pragma once

#include <memory>
#include <string_view>

#include "bundler/channel/raw_record.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

class RecordJson {
 public:
  RecordJson();
  ~RecordJson();
  RecordJson(const RecordJson&) = delete;
  RecordJson& operator=(const RecordJson&) = delete;

  /// Valid until the next call. R2W0202 no JSON, or no object.
  [[nodiscard]] Outcome<RawRecord> read(std::string_view text);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ros2wasm
