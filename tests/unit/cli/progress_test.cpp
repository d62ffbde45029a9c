// Progress as bar, lines and JSON, with a clock of the test's own.
#include "cli/progress.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

ProgressEvent event(std::uint64_t done, std::uint64_t total = 4) {
  return {.step = "fetch",
          .item = "ros-jazzy-rclcpp",
          .done = done,
          .total = total,
          .unit = "packages"};
}

TEST(Progress, BarIsRedrawnInPlaceAndWipedAtTheEnd) {
  std::int64_t now = 0;
  Progress progress(ProgressForm::kBar, 80, [&] { return now; });
  EXPECT_EQ(progress.show(event(1)),
            "\r\x1b[2Kfetch    [######..................] 1/4 packages  ros-jazzy-rclcpp");
  EXPECT_EQ(progress.show(event(2)), "") << "too soon";
  now += 100;
  EXPECT_NE(progress.show(event(2)).find("[############............] 2/4"), std::string::npos);
  EXPECT_EQ(progress.show(event(4)), "\r\x1b[2K");
  EXPECT_EQ(progress.wipe(), "");
}

TEST(Progress, BarNeverBreaksTheLine) {
  Progress progress(ProgressForm::kBar, 40, [] { return std::int64_t{0}; });
  const std::string text =
      progress.show({.step = "build", .item = std::string(500, 'x') + "\n", .done = 1, .total = 2});
  EXPECT_LE(text.size(), 40U + 5U);
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(Progress, LinesForFinishedStepsOnly) {
  Progress progress(ProgressForm::kLines, 80, [] { return std::int64_t{0}; });
  EXPECT_EQ(progress.show(event(1)), "");
  EXPECT_EQ(progress.show(event(4)), "fetch: 4/4 packages\n");
  EXPECT_EQ(
      progress.show({.step = "fetch", .done = 1'500'000, .total = 1'500'000, .unit = "bytes"}),
      "fetch: 1500/1500 kB\n");
}

TEST(Progress, JsonIsThrottledButShowsTheLast) {
  std::int64_t now = 0;
  Progress progress(ProgressForm::kJson, 80, [&] { return now; });
  EXPECT_EQ(
      progress.show(event(1)),
      R"({"event":"progress","step":"fetch","item":"ros-jazzy-rclcpp","done":1,"total":4,"unit":"packages"})"
      "\n");
  EXPECT_EQ(progress.show(event(2)), "");
  EXPECT_NE(progress.show(event(4)), "");
}

TEST(Progress, NoneSaysNothing) {
  Progress progress(ProgressForm::kNone, 80, [] { return std::int64_t{0}; });
  EXPECT_EQ(progress.show(event(4)), "");
}

}  // namespace
}  // namespace ros2wasm
