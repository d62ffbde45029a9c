// See signing_key.hpp.
#include "cli/signing_key.hpp"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "bundler/io/ed25519.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kVariable = "ROS2WASM_KEY_PASSWORD";
constexpr std::size_t kMostOfAPassword = 1024;

/// Up to a line's end. Nothing when it cannot be read, or when the program should end.
std::optional<std::string> line_of(int fd, const Cancellation& cancellation) {
  std::string line;
  line.reserve(kMostOfAPassword);
  char letter = 0;
  for (;;) {
    // An interrupt between the question and the call would not end a call that waits.
    std::array<pollfd, 2> ends{{{.fd = fd, .events = POLLIN, .revents = 0},
                                {.fd = cancellation.wake_fd(), .events = POLLIN, .revents = 0}}};
    const int ready = ::poll(ends.data(), ends.size(), -1);
    if (cancellation.requested()) return std::nullopt;
    if (ready < 0 && errno == EINTR) continue;
    const ssize_t got = ::read(fd, &letter, 1);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0 || letter == '\n') break;
    if (line.size() == kMostOfAPassword) return std::nullopt;
    line += letter;
  }
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

/// Asks on the terminal, which shows nothing of what is typed.
std::optional<std::string> asked(const std::string& question, const Cancellation& cancellation) {
  const int terminal = ::open("/dev/tty", O_RDWR | O_CLOEXEC | O_NOCTTY);
  if (terminal < 0) return std::nullopt;
  termios usual{};
  std::optional<std::string> line;
  if (::tcgetattr(terminal, &usual) == 0) {
    termios silent = usual;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ::tcsetattr(terminal, TCSAFLUSH, &silent);
    [[maybe_unused]] ssize_t written = ::write(terminal, question.data(), question.size());
    line = line_of(terminal, cancellation);
    ::tcsetattr(terminal, TCSAFLUSH, &usual);
    written = ::write(terminal, "\n", 1);
  }
  ::close(terminal);
  return line;
}

Diagnostic no_password(const std::string& file, std::string why) {
  return Diagnostic{.code = "R2W0659",
                    .message = "the key `" + file + "` could not be opened",
                    .why = {std::move(why)},
                    .fix = {std::string("set ") + kVariable +
                            ", or give --password-fd N to read it from an open file"}};
}

Outcome<std::string> password_for(const SigningChoice& choice, const Context& context) {
  if (choice.password_fd) {
    auto line = line_of(*choice.password_fd, context.cancellation);
    if (context.cancellation.requested()) return interrupted();
    if (!line)
      return no_password(choice.key_file, "no password came from file descriptor " +
                                              std::to_string(*choice.password_fd));
    return std::move(*line);
  }
  if (const auto found = context.environment.find(kVariable); found != context.environment.end())
    return found->second;
  auto line = asked("Password of " + choice.key_file + ": ", context.cancellation);
  if (context.cancellation.requested()) return interrupted();
  if (!line)
    return no_password(choice.key_file, "it has a password, and no terminal is there to ask");
  return std::move(*line);
}

}  // namespace

Outcome<std::shared_ptr<const SiteSigner>> read_signer(const SigningChoice& choice,
                                                       const Context& context) {
  if (choice.key_file.empty()) {
    if (choice.comment.empty() && !choice.password_fd) return std::shared_ptr<const SiteSigner>();
    return Diagnostic{.code = "R2W0902",
                      .kind = FailureKind::kCommandLine,
                      .message = "there is no key to sign with",
                      .why = {"--sign-comment and --password-fd are about the key of --sign"},
                      .fix = {"add --sign KEYFILE"}};
  }
  if (auto fine = check_trusted_comment(choice.comment); !fine) return std::move(fine).errors();
  auto text = read_file(choice.key_file, kMostOfText);
  if (!text) return std::move(text).errors();
  const auto wanted = wants_password(*text, choice.key_file);
  if (!wanted) return wanted.errors();
  std::string password;
  if (*wanted) {
    auto given = password_for(choice, context);
    if (!given) return std::move(given).errors();
    password = std::move(*given);
  }
  auto key = read_secret_key(*text, choice.key_file, password);
  forget(password);
  forget(*text);
  if (!key) return std::move(key).errors();
  auto signer = std::make_shared<SiteSigner>();
  signer->key = std::move(*key);
  signer->comment = choice.comment;
  return std::shared_ptr<const SiteSigner>(std::move(signer));
}

}  // namespace ros2wasm
