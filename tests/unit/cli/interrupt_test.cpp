// Signals become a flag and a readable descriptor; the second one ends the program. In child
// processes, since handlers belong to the whole process.
#include "cli/interrupt.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace ros2wasm {
namespace {

bool readable(int descriptor) {
  pollfd wanted{.fd = descriptor, .events = POLLIN, .revents = 0};
  return poll(&wanted, 1, 0) == 1;
}

[[noreturn]] void leave(bool good) {
  std::_Exit(good ? 0 : 1);
}

TEST(InterruptDeathTest, TheFirstSignalSetsTheFlagAndWakes) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const Cancellation cancellation = install_interrupt_handlers();
        const bool before = !cancellation.requested() && !readable(cancellation.wake_fd());
        raise(SIGINT);
        leave(before && cancellation.requested() && readable(cancellation.wake_fd()) &&
              !asked_to_end());
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(InterruptDeathTest, TerminationIsToldApart) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const Cancellation cancellation = install_interrupt_handlers();
        raise(SIGTERM);
        leave(cancellation.requested() && asked_to_end());
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(InterruptDeathTest, TheSecondSignalEndsTheProgram) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        [[maybe_unused]] const Cancellation cancellation = install_interrupt_handlers();
        raise(SIGINT);
        raise(SIGINT);
        leave(false);
      },
      ::testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptDeathTest, AClosedPipeIsAnErrorNotTheEnd) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        [[maybe_unused]] const Cancellation cancellation = install_interrupt_handlers();
        int ends[2];
        const bool made = pipe(ends) == 0;
        close(ends[0]);
        const ssize_t written = write(ends[1], "x", 1);
        leave(made && written == -1 && errno == EPIPE);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(InterruptDeathTest, AFileThatMayNotGrowIsAnErrorNotTheEnd) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        [[maybe_unused]] const Cancellation cancellation = install_interrupt_handlers();
        rlimit nothing{};
        const bool limited = setrlimit(RLIMIT_FSIZE, &nothing) == 0;
        const int file = open("/tmp", O_TMPFILE | O_WRONLY, 0600);
        const ssize_t written = write(file, "x", 1);
        leave(limited && file >= 0 && written == -1 && errno == EFBIG);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace ros2wasm
