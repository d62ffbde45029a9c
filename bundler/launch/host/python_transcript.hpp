// A talk with the interpreter of launch files in Python that may go as one before it: then nobody
// is asked. Where it goes another way, the interpreter is led to that point first, so that what it
// answers is what it would have answered. Pure: values, and functions that are given.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

struct PythonRemark {
  std::string request;
  std::vector<std::pair<std::string, std::string>> asked;  ///< in between, with what it was told
  std::string answer;
};

class PythonTranscript {
 public:
  /// `known`: an earlier talk, with an interpreter that saw the same. `live`: as LaunchPython.
  PythonTranscript(std::vector<PythonRemark> known, LaunchPython live)
      : remarks_(std::move(known)), live_(std::move(live)) {}

  /// As LaunchPython has it. R2W0416 when the interpreter does not say again what it said before.
  [[nodiscard]] Outcome<std::string> ask(
      const std::string& request, const std::function<std::string(const std::string&)>& reply);

  /// When less was asked than an earlier talk had: leads the interpreter to where this one ended,
  /// so that what it saw is what this talk needed. R2W0416 as ask().
  [[nodiscard]] Outcome<Done> end();

  [[nodiscard]] bool is_live() const { return is_live_; }
  [[nodiscard]] bool has_failed() const { return has_failed_; }
  /// The remarks of this conversation, when it is live.
  [[nodiscard]] const std::vector<PythonRemark>& remarks() const { return remarks_; }

 private:
  using Told = std::vector<std::pair<std::string, std::string>>;

  [[nodiscard]] Outcome<Done> catch_up();
  [[nodiscard]] Outcome<std::string> ask_live(
      const std::string& request, const Told& told,
      const std::function<std::string(const std::string&)>& reply);

  std::vector<PythonRemark> remarks_;
  LaunchPython live_;
  std::size_t next_ = 0;
  bool is_live_ = false;
  bool has_failed_ = false;
};

/// The files that an interpreter looked at: paths as launch files have them, and what was there:
/// "none", "directory", "file SIZE", "file SIZE SHA256", "names SHA256".
using SeenPaths = std::vector<std::pair<std::string, std::string>>;

struct KeptPython {
  std::vector<PythonRemark> remarks;
  SeenPaths seen;
};

[[nodiscard]] std::string kept_python_json(const KeptPython& kept);
/// Nothing when the text is not valid.
[[nodiscard]] std::optional<KeptPython> read_kept_python(std::string_view text);

/// `text`: an object of texts. Nothing when the text is not valid.
[[nodiscard]] std::optional<SeenPaths> read_seen_paths(std::string_view text);

}  // namespace ros2wasm
