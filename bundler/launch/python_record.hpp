// The answers of launch files in Python when the site was packed, so that the same questions need
// no Python when the site starts. Pure: values, and a function that is passed in.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bundler/launch/launch_scope.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

/// One request to Python and what came of it. Texts are lines of JSON (ros2wasm_launch/reader.py).
struct PythonExchange {
  std::string request;
  std::vector<std::string> asked;  ///< what it asked in between, in order
  std::string answer;
  std::optional<std::size_t> after;  ///< the exchange before it that ran a function
};

/// The exchanges of several evaluations of one launch file. Each function of it keeps its number.
class PythonRecord {
 public:
  PythonRecord() = default;
  explicit PythonRecord(std::vector<PythonExchange> exchanges);

  /// For one evaluation, during which the record must stay where it is: asks `python` for what is
  /// not known yet.
  [[nodiscard]] LaunchPython recording(LaunchPython python);

  /// The same without Python. What was not asked with these launch configurations is answered as it
  /// was with others, and `decided` is told. For what was never asked R2W0732, and
  /// `decided` is told too.
  [[nodiscard]] LaunchPython replaying(std::function<void()> decided);

  [[nodiscard]] const std::vector<PythonExchange>& exchanges() const { return exchanges_; }

 private:
  using Texts = std::map<std::string, std::string>;

  struct Question {
    std::string kind;
    std::string subject;  ///< a path or the number of a function
    Texts configurations;
    Texts environment;
    std::optional<std::set<std::string>> reads;  ///< the configurations that mattered; none: all
  };
  /// The answers that one evaluation has had.
  struct Evaluation {
    std::set<std::size_t> used;
    std::optional<std::size_t> last;  ///< that ran a function
  };

  static Question question_of(const std::string& request);
  void add(PythonExchange exchange);
  [[nodiscard]] bool fits(std::size_t number, const Question& asked,
                          const Evaluation& evaluation) const;
  [[nodiscard]] std::optional<std::size_t> known(const Question& asked,
                                                 const Evaluation& evaluation, bool exactly) const;
  [[nodiscard]] std::string answered(std::size_t number, const Question& asked,
                                     Evaluation& evaluation,
                                     const std::function<std::string(const std::string&)>& reply);

  std::vector<PythonExchange> exchanges_;
  std::vector<Question> questions_;  ///< of these
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> places_;
};

/// A list of these; and back, where what is none of ours is skipped.
void write_python_exchanges(JsonWriter& json, const std::vector<PythonExchange>& exchanges);
[[nodiscard]] std::vector<PythonExchange> read_python_exchanges(const JsonValue* json);

}  // namespace ros2wasm
