// fork, exec, poll: see process.hpp.
#include "bundler/io/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "bundler/io/confinement.hpp"

extern char** environ;  // NOLINT

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Closes a descriptor when it goes out of scope.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void adopt(int fd) {
    close();
    fd_ = fd;
  }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_ = -1;
};

struct Pipe {
  Descriptor read_end;
  Descriptor write_end;

  [[nodiscard]] bool open() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    read_end.adopt(ends[0]);
    write_end.adopt(ends[1]);
    return true;
  }

  /// A socket, so that writing to a program that has ended is an error and not a signal.
  [[nodiscard]] bool open_socket() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
    read_end.adopt(ends[0]);
    write_end.adopt(ends[1]);
    return true;
  }
};

Diagnostic cannot_start(const std::string& program, const std::string& reason) {
  return Diagnostic{.code = "R2W0910",
                    .kind = FailureKind::kEnvironment,
                    .message = "cannot run `" + program + "`",
                    .why = {reason}};
}

std::vector<std::string> environment_for(const ProcessRequest& request) {
  std::vector<std::string> result;
  for (char** entry = environ; !request.is_confined && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const auto name = std::string(text.substr(0, text.find('=')));
    if (!request.environment.contains(name)) result.emplace_back(text);
  }
  for (const auto& [name, value] : request.environment) result.push_back(name + "=" + value);
  return result;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (auto& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

constexpr int kSignals = 128;

int exit_code_of(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return kSignals + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

/// Ends the child's group and waits for it: politely, then by force after two seconds.
void stop_group(pid_t child, bool own_group) {
  const pid_t target = own_group ? -child : child;
  ::kill(target, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (std::chrono::steady_clock::now() < deadline) {
    if (::waitpid(child, nullptr, WNOHANG) == child) {
      if (own_group) ::kill(target, SIGKILL);  // what it left behind
      return;
    }
    ::poll(nullptr, 0, 10);
  }
  ::kill(target, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// Reads what is there; closes the descriptor at its end.
void drain(Descriptor& from, std::string& into, const ProcessRequest& request) {
  std::array<char, 16384> buffer{};
  const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
  if (count > 0) {
    const std::string_view piece(buffer.data(), static_cast<std::size_t>(count));
    into.append(piece);
    if (request.on_output) request.on_output(piece);
  } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
    from.close();
  }
}

/// The file descriptors of a child; -1: that of this process, or /dev/null for `in`.
struct Streams {
  int in = -1;
  int out = -1;
  int error = -1;
};

[[noreturn]] void become(const std::string& program, char* const* arguments,
                         char* const* environment, const ProcessRequest& request, Streams streams,
                         int report_fd, pid_t parent) {
  // Between fork and exec: only calls that are safe in a child of a program with threads.
  if (!request.share_terminal) ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (streams.out >= 0) {
    ::dup2(streams.out, STDOUT_FILENO);
    ::dup2(streams.error, STDERR_FILENO);
    const int in_fd = streams.in >= 0 ? streams.in : ::open("/dev/null", O_RDONLY);
    if (in_fd >= 0) ::dup2(in_fd, STDIN_FILENO);
  }
  if (request.largest_file > 0) {
    const rlimit most{.rlim_cur = request.largest_file, .rlim_max = request.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &most);
  }
  if (request.most_memory > 0) {
    const rlimit most{.rlim_cur = request.most_memory, .rlim_max = request.most_memory};
    ::setrlimit(RLIMIT_AS, &most);
  }
  const std::string& directory = request.directory.native();
  if ((directory.empty() || ::chdir(directory.c_str()) == 0) &&
      (!request.is_confined || give_up_sockets())) {
    ::execve(program.c_str(), arguments, environment);
  }
  const int reason = errno;
  [[maybe_unused]] const auto written = ::write(report_fd, &reason, sizeof reason);
  ::_exit(127);
}

constexpr int kClockPerProcessor = 10;

}  // namespace

Patience::Patience(int process_id, std::chrono::milliseconds limit)
    : process_id_(process_id),
      deadline_(std::chrono::steady_clock::now() + kClockPerProcessor * limit) {
  most_used_ = used().value_or(std::chrono::nanoseconds(0)) + limit;
}

std::optional<std::chrono::nanoseconds> Patience::used() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process_id_, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
    return std::nullopt;  // it has ended, or another system hides it: then the clock decides
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

bool Patience::is_over() const {
  if (std::chrono::steady_clock::now() >= deadline_) return true;
  const auto now_used = used();
  return now_used && *now_used >= most_used_;
}

std::optional<fs::path> find_program(const std::string& name,
                                     std::optional<std::string_view> path) {
  const auto runnable = [](const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) {
    return runnable(name) ? std::optional<fs::path>(name) : std::nullopt;
  }
  const char* inherited = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
  std::string_view rest =
      path ? *path : std::string_view(inherited != nullptr ? inherited : "/usr/bin:/bin");
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    const auto folder = rest.substr(0, colon);
    rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
    if (folder.empty()) continue;
    fs::path candidate = fs::path(folder) / name;
    if (runnable(candidate)) return candidate;
  }
  return std::nullopt;
}

namespace {

/// Starts the program, and returns when it runs.
Outcome<pid_t> start_child(const ProcessRequest& request, Streams streams) {
  const std::string& name = request.arguments.front();
  const auto program = find_program(name);
  if (!program) return cannot_start(name, "no such program was found");
  Pipe report;
  if (!report.open())
    return cannot_start(name, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  auto argument_texts = request.arguments;
  auto environment_texts = environment_for(request);
  const auto arguments = pointers_to(argument_texts);
  const auto environment = pointers_to(environment_texts);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) return cannot_start(name, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  if (child == 0) {
    become(program->native(), arguments.data(), environment.data(), request, streams,
           report.write_end.get(), parent);
  }
  report.write_end.close();
  int start_error = 0;
  ssize_t reported = 0;
  while ((reported = ::read(report.read_end.get(), &start_error, sizeof start_error)) < 0 &&
         errno == EINTR) {
  }
  if (reported == static_cast<ssize_t>(sizeof start_error)) {
    ::waitpid(child, nullptr, 0);
    return cannot_start(name, std::strerror(start_error));  // NOLINT(concurrency-mt-unsafe)
  }
  return child;
}

}  // namespace

std::string said_of_signal(const ProcessResult& result) {
  if (result.exit_code <= kSignals) return {};
  const int signal = result.exit_code - kSignals;
  const char* name = ::strsignal(signal);
  return "ended by signal " + std::to_string(signal) + " (" + (name == nullptr ? "unknown" : name) +
         ")\n";
}

Outcome<ProcessResult> run_process(const ProcessRequest& request,
                                   const Cancellation& cancellation) {
  if (cancellation.requested()) return interrupted();
  Pipe output;
  Pipe error;
  const bool captures = request.output_mode != OutputMode::kInherit;
  const bool merged = request.output_mode == OutputMode::kCaptureMerged;
  if (captures && (!output.open() || (!merged && !error.open()))) {
    return cannot_start(request.arguments.front(),
                        std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  }
  Streams streams;
  if (captures) {
    streams.out = output.write_end.get();
    streams.error = merged ? streams.out : error.write_end.get();
  }
  const auto started = start_child(request, streams);
  if (!started) return started.errors();
  const pid_t child = *started;
  output.write_end.close();
  error.write_end.close();
  const bool own_group = !request.share_terminal;

  ProcessResult result;
  const bool is_limited = request.time_limit.count() > 0;
  const Patience patience(child, request.time_limit);
  const auto out_of_time = [&] {
    if (!is_limited || !patience.is_over()) return false;
    stop_group(child, own_group);
    result.is_out_of_time = true;
    result.exit_code = kSignals + SIGTERM;
    return true;
  };
  while (output.read_end.get() >= 0 || error.read_end.get() >= 0) {
    std::array<pollfd, 3> waits = {{{output.read_end.get(), POLLIN, 0},
                                    {error.read_end.get(), POLLIN, 0},
                                    {own_group ? cancellation.wake_fd() : -1, POLLIN, 0}}};
    // Without a descriptor to wake on, look at the flag and the clock now and then.
    const int patience_ms = cancellation.wake_fd() >= 0 && !is_limited ? -1 : 100;
    if (::poll(waits.data(), waits.size(), patience_ms) < 0 && errno != EINTR) break;
    if (own_group && cancellation.requested()) {
      stop_group(child, own_group);
      return interrupted();
    }
    if (out_of_time()) return result;
    if (request.most_output > 0 &&
        result.output.size() + result.error.size() > request.most_output) {
      stop_group(child, own_group);
      result.is_out_of_room = true;
      result.exit_code = kSignals + SIGTERM;
      return result;
    }
    if (waits[0].revents != 0) drain(output.read_end, result.output, request);
    if (waits[1].revents != 0) drain(error.read_end, result.error, request);
  }
  int status = 0;
  for (pid_t ended = 0; (ended = ::waitpid(child, &status, is_limited ? WNOHANG : 0)) != child;) {
    if (ended < 0 && errno != EINTR) break;
    if (own_group && cancellation.requested()) {
      stop_group(child, own_group);
      return interrupted();
    }
    if (out_of_time()) return result;
    if (is_limited) ::poll(nullptr, 0, 5);
  }
  result.exit_code = exit_code_of(status);
  return result;
}

namespace {
constexpr std::size_t kLongestLine = 64U << 20U;  // bytes
constexpr std::size_t kMostError = 64U << 10U;
}  // namespace

struct Conversation::State {
  Cancellation cancellation;
  std::string program;
  pid_t child = 0;
  Pipe input;
  Pipe output;
  Pipe error;
  std::string received;
  std::string error_text;
  bool ended = false;
  bool is_out_of_time = false;

  /// Waits for the program's end.
  int end() {
    input.write_end.close();
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    ended = true;
    pollfd rest{error.read_end.get(), POLLIN, 0};
    while (rest.fd >= 0 && ::poll(&rest, 1, 0) > 0) {
      drain(error.read_end, error_text, {});
      rest.fd = error.read_end.get();
    }
    return exit_code_of(status);
  }
  [[nodiscard]] Diagnostic gone(int exit_code) const {
    return Diagnostic{.code = "R2W0910",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + program + "` ended before it answered",
                      .why = {"it ended with " + std::to_string(exit_code)},
                      .detail = error_text};
  }
  [[nodiscard]] bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(input.write_end.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
};

Conversation::Conversation(std::unique_ptr<State> state) : state_(std::move(state)) {}

Conversation::~Conversation() {
  if (!state_->ended) stop_group(state_->child, true);
}

Outcome<std::unique_ptr<Conversation>> Conversation::start(const ProcessRequest& request,
                                                           const Cancellation& cancellation) {
  if (cancellation.requested()) return interrupted();
  std::unique_ptr<State> state(new State{.cancellation = cancellation,
                                         .program = request.arguments.front(),
                                         .input = {},
                                         .output = {},
                                         .error = {},
                                         .received = {},
                                         .error_text = {}});
  if (!state->input.open_socket() || !state->output.open() || !state->error.open())
    return cannot_start(state->program,
                        std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  const auto child = start_child(request, {.in = state->input.read_end.get(),
                                           .out = state->output.write_end.get(),
                                           .error = state->error.write_end.get()});
  if (!child) return child.errors();
  state->child = *child;
  state->input.read_end.close();
  state->output.write_end.close();
  state->error.write_end.close();
  return std::unique_ptr<Conversation>(new Conversation(std::move(state)));
}

bool Conversation::is_out_of_time() const {
  return state_->is_out_of_time;
}

Patience Conversation::patience(std::chrono::milliseconds limit) const {
  return {state_->child, limit};
}

Outcome<std::string> Conversation::ask(const std::string& line,
                                       const std::optional<Patience>& patience) {
  State& state = *state_;
  if (state.ended || !state.send(line + "\n")) return state.gone(state.ended ? 0 : state.end());
  const ProcessRequest quiet;
  for (;;) {
    const std::size_t end = state.received.find('\n');
    if (end != std::string::npos) {
      std::string answer = state.received.substr(0, end);
      state.received.erase(0, end + 1);
      return answer;
    }
    if (state.output.read_end.get() < 0) {
      const int exit_code = state.end();
      return state.gone(exit_code);
    }
    std::array<pollfd, 3> waits = {{{state.output.read_end.get(), POLLIN, 0},
                                    {state.error.read_end.get(), POLLIN, 0},
                                    {state.cancellation.wake_fd(), POLLIN, 0}}};
    const int wait_ms = patience || state.cancellation.wake_fd() < 0 ? 100 : -1;
    if (::poll(waits.data(), waits.size(), wait_ms) < 0 && errno != EINTR)
      return state.gone(state.end());
    if (state.cancellation.requested()) {
      stop_group(state.child, true);
      state.ended = true;
      return interrupted();
    }
    if (patience && patience->is_over()) {
      stop_group(state.child, true);
      state.ended = true;
      state.is_out_of_time = true;
      return state.gone(128 + SIGTERM);
    }
    if (waits[0].revents != 0) drain(state.output.read_end, state.received, quiet);
    if (state.received.size() > kLongestLine) {
      stop_group(state.child, true);
      state.ended = true;
      return state.gone(128 + SIGTERM);
    }
    if (waits[1].revents != 0) drain(state.error.read_end, state.error_text, quiet);
    if (state.error_text.size() > kMostError)
      state.error_text.erase(0, state.error_text.size() - kMostError);
  }
}

}  // namespace ros2wasm
