// The report of `ros2wasm channel build`.
#include <gtest/gtest.h>

#include "bundler/channel_build.hpp"

namespace ros2wasm {
namespace {

ChannelPackage package(const std::string& name, ChannelPackageState state) {
  return {.name = name, .version = "1.0.0", .origin = {}, .archive = {}, .state = state};
}

ChannelBuildReport report() {
  ChannelBuildReport report;
  report.packages = {package("arm", ChannelPackageState::kAdded),
                     package("camera", ChannelPackageState::kFailed),
                     package("drive", ChannelPackageState::kFailed),
                     package("lift", ChannelPackageState::kSkipped)};
  report.packages[0].archive = "noarch/ros-jazzy-arm-1.0.0-h01234567_0.conda";
  report.packages[0].origin = "git+https://example.org/arm@0123";
  for (const std::size_t i : {1U, 2U})
    report.packages[i].errors = {
        Diagnostic{.code = "R2W0502", .message = "no `a|b` in C:\\lib\r\nat all"}};
  report.packages[3].reason = {"it needs `drive`, which is skipped"};
  return report;
}

TEST(ChannelReport, FailuresOfOneCauseAreOneRowAndNothingBreaksTheTable) {
  const std::string text = channel_report_markdown(report());
  EXPECT_NE(text.find("| R2W0502 | no `a\\|b` in C:\\\\lib  at all | camera, drive |\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| lift | 1.0.0 | skipped | it needs `drive`, which is skipped |  |\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("- failed: 2\n"), std::string::npos) << text;
}

TEST(ChannelReport, JsonHasTheSame) {
  const std::string text = channel_report_json(report());
  EXPECT_NE(text.find(R"("added":1,"unchanged":0,"failed":2,"skipped":1)"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("packages":["camera","drive"])"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("source":"git+https://example.org/arm@0123")"), std::string::npos) << text;
}

}  // namespace
}  // namespace ros2wasm
