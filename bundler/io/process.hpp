// Runs child programs: the only file pair that starts processes. A child lives in its own process
// group, so that stopping it stops what it started too (ninja and its compilers).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// How long a program may run: `limit` of its own processor time, so that a busy machine fails
/// nobody, and ten times as much by the clock. Counts from when it is made.
class Patience {
 public:
  Patience(int process_id, std::chrono::milliseconds limit);
  [[nodiscard]] bool is_over() const;

 private:
  [[nodiscard]] std::optional<std::chrono::nanoseconds> used() const;

  int process_id_;
  std::chrono::nanoseconds most_used_{0};
  std::chrono::steady_clock::time_point deadline_;
};

enum class OutputMode {
  kCapture,        ///< stdout and stderr are collected, each in its own string
  kCaptureMerged,  ///< both are collected in `output`, in the order written
  kInherit,        ///< the child writes where this process writes
};

struct ProcessRequest {
  std::vector<std::string> arguments;  ///< [0] is the program: a path, or a name looked up in PATH
  std::map<std::string, std::string> environment;  ///< added to the inherited one
  std::filesystem::path directory;                 ///< empty: the current one
  OutputMode output_mode = OutputMode::kCaptureMerged;
  std::function<void(std::string_view)>
      on_output;  ///< each piece of output as it comes; may be empty
  /// The child keeps the terminal's process group and gets Ctrl-C itself; for programs a person
  /// talks to.
  bool share_terminal = false;
  /// For code of strangers: `environment` is all that it has, and it can open no socket.
  bool is_confined = false;
  /// As of Patience; the child's group is ended then. 0: none.
  std::chrono::milliseconds time_limit{0};
  /// Bytes of captured output; the child's group is ended when there are more. 0: no limit.
  std::size_t most_output = 0;
  /// Bytes of each file that it writes, of what it starts too; more ends it by a signal. 0: no
  /// limit.
  std::uint64_t largest_file = 0;
  /// Bytes of memory that it may ask for, and each program that it starts. 0: no limit.
  std::uint64_t most_memory = 0;
};

struct ProcessResult {
  int exit_code = 0;  ///< 128 + signal number when a signal ended it
  std::string output;
  std::string error;
  bool is_out_of_time = false;  ///< it was ended at the time limit
  bool is_out_of_room = false;  ///< it was ended because it wrote more than `most_output`
};

/// A line when a signal ended it, else empty: then it may have said nothing itself.
[[nodiscard]] std::string said_of_signal(const ProcessResult& result);

/// Runs to the end. R2W0910 when the program cannot be started, interrupted() when it was asked to
/// stop (the child's whole group is ended first: SIGTERM, then SIGKILL after two seconds).
[[nodiscard]] Outcome<ProcessResult> run_process(const ProcessRequest& request,
                                                 const Cancellation& cancellation);

/// A program that is asked and answers, a line each. It is ended with this value.
class Conversation {
 public:
  /// As run_process() starts it; its stderr is kept, its stdin and stdout are the conversation.
  [[nodiscard]] static Outcome<std::unique_ptr<Conversation>> start(
      const ProcessRequest& request, const Cancellation& cancellation);
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;
  ~Conversation();

  /// How long the program may go on from now, over as many questions as the caller likes.
  [[nodiscard]] Patience patience(std::chrono::milliseconds limit) const;
  /// Sends a line, which has no newline in it, and waits for one. R2W0910 when the program has
  /// ended, with the last of what it wrote to stderr, or is ended because `patience` is over;
  /// interrupted().
  [[nodiscard]] Outcome<std::string> ask(const std::string& line,
                                         const std::optional<Patience>& patience = std::nullopt);
  [[nodiscard]] bool is_out_of_time() const;

 private:
  struct State;
  explicit Conversation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The executable file that `name` stands for: itself when it has a slash, else the first hit in
/// `path` (colon separated; the environment's PATH when not given).
[[nodiscard]] std::optional<std::filesystem::path> find_program(
    const std::string& name, std::optional<std::string_view> path = std::nullopt);

}  // namespace ros2wasm
