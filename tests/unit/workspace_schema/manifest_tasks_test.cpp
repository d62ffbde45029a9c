// `tasks:` of a manifest: what becomes of one, and what is refused where.
#include "workspace_schema/schema/manifest_tasks.hpp"

#include <gtest/gtest.h>

#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

const std::string kHead = "schema: 1\nname: lab\nlaunch: [{package: p, executable: e}]\ntasks:\n";

/// The codes and messages of what is wrong.
std::string refused(const std::string& tasks) {
  const auto manifest = read_manifest(kHead + tasks, "workspace.yaml");
  std::string all;
  if (manifest) return all;
  for (const Diagnostic& error : manifest.errors()) all += error.code + " " + error.message + ";";
  return all;
}

TEST(ManifestTasks, HaveTextsAndChecks) {
  const auto manifest =
      read_manifest(kHead +
                        "  - title: Drive\n"
                        "    text: |\n      To the **wall**.\n\n      Stop there.\n"
                        "    checks:\n"
                        "      - {topic: odom, field: pose.x, above: 2}\n"
                        "      - {title: told, log: wall}\n"
                        "    hint: Use teleop.\n"
                        "  - {title: Stop, checks: [{topic: /odom}]}\n",
                    "workspace.yaml");
  ASSERT_TRUE(manifest);
  ASSERT_EQ(manifest->tasks.size(), 2U);
  const TaskEntry& drive = manifest->tasks.front();
  EXPECT_EQ(drive.title.value, "Drive");
  EXPECT_EQ(drive.text, "To the **wall**.\n\nStop there.\n");
  EXPECT_EQ(drive.hint, "Use teleop.");
  EXPECT_EQ(drive.solution, "");
  ASSERT_EQ(drive.checks.size(), 2U);
  EXPECT_EQ(std::get<MessageCheck>(drive.checks[0].what).topic, "/odom");
  EXPECT_EQ(drive.checks[1].title, "told");
  EXPECT_TRUE(manifest->checks.empty());
}

TEST(ManifestTasks, WhatCannotBeDoneIsRefused) {
  EXPECT_EQ(
      refused("  - {title: a, checks: [{topic: /a}]}\n  - {title: a, checks: [{topic: /b}]}\n"),
      "R2W0126 two tasks have the title `a`;");
  EXPECT_EQ(refused("  - {title: a, checks: [{topic: /a, within: 5 s}]}\n"),
            "R2W0117 `within` does not belong to a check of a task;");
  EXPECT_EQ(refused("  - {title: a}\n").substr(0, 7), "R2W0106");
  EXPECT_EQ(refused("  - {title: a, checks: []}\n").substr(0, 7), "R2W0106");
  EXPECT_EQ(refused("  - {checks: [{topic: /a}]}\n").substr(0, 7), "R2W0106");
  EXPECT_EQ(refused("  - {title: a, text: [b], checks: [{topic: /a}]}\n").substr(0, 7), "R2W0103");
  EXPECT_EQ(refused("  - words\n").substr(0, 7), "R2W0103");
}

}  // namespace
}  // namespace ros2wasm
