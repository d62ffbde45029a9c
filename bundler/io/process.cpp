// fork, exec, poll: see process.hpp.
#include "bundler/io/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>

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

int exit_code_of(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return 128 + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
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

[[noreturn]] void become(const std::string& program, char* const* arguments,
                         char* const* environment, const ProcessRequest& request, int out_fd,
                         int error_fd, int report_fd, pid_t parent) {
  // Between fork and exec: only calls that are safe in a child of a program with threads.
  if (!request.share_terminal) ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (out_fd >= 0) {
    ::dup2(out_fd, STDOUT_FILENO);
    ::dup2(error_fd, STDERR_FILENO);
    const int null_fd = ::open("/dev/null", O_RDONLY);
    if (null_fd >= 0) ::dup2(null_fd, STDIN_FILENO);
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

}  // namespace

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

Outcome<ProcessResult> run_process(const ProcessRequest& request,
                                   const Cancellation& cancellation) {
  const std::string& name = request.arguments.front();
  const auto program = find_program(name);
  if (!program) return cannot_start(name, "no such program was found");
  if (cancellation.requested()) return interrupted();

  Pipe output;
  Pipe error;
  Pipe report;
  const bool captures = request.output_mode != OutputMode::kInherit;
  const bool merged = request.output_mode == OutputMode::kCaptureMerged;
  if ((captures && (!output.open() || (!merged && !error.open()))) || !report.open()) {
    return cannot_start(name, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  }
  auto argument_texts = request.arguments;
  auto environment_texts = environment_for(request);
  const auto arguments = pointers_to(argument_texts);
  const auto environment = pointers_to(environment_texts);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) return cannot_start(name, std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  if (child == 0) {
    become(program->native(), arguments.data(), environment.data(), request,
           captures ? output.write_end.get() : -1,
           merged ? output.write_end.get() : error.write_end.get(), report.write_end.get(), parent);
  }
  output.write_end.close();
  error.write_end.close();
  report.write_end.close();
  const bool own_group = !request.share_terminal;

  int start_error = 0;
  ssize_t reported = 0;
  while ((reported = ::read(report.read_end.get(), &start_error, sizeof start_error)) < 0 &&
         errno == EINTR) {
  }
  if (reported == static_cast<ssize_t>(sizeof start_error)) {
    ::waitpid(child, nullptr, 0);
    return cannot_start(name, std::strerror(start_error));  // NOLINT(concurrency-mt-unsafe)
  }

  ProcessResult result;
  const bool is_limited = request.time_limit.count() > 0;
  const auto deadline = std::chrono::steady_clock::now() + request.time_limit;
  const auto out_of_time = [&] {
    if (!is_limited || std::chrono::steady_clock::now() < deadline) return false;
    stop_group(child, own_group);
    result.is_out_of_time = true;
    result.exit_code = 128 + SIGTERM;
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

}  // namespace ros2wasm
