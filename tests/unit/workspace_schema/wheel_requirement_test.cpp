// Names of wheels, and what their Requires-Dist lines ask for in a site.
#include "workspace_schema/conda/wheel_requirement.hpp"

#include <gtest/gtest.h>

#include "workspace_schema/conda/wheel_name.hpp"

namespace ros2wasm {
namespace {

TEST(WheelName, SaysWhatAWheelRunsOn) {
  const auto pure = [](const char* name) {
    const auto wheel = wheel_name(name);
    return wheel ? wheel->project + " " + wheel->version + (wheel->is_pure() ? "" : " compiled")
                 : "none";
  };
  EXPECT_EQ(pure("transforms3d-0.4.2-py3-none-any.whl"), "transforms3d 0.4.2");
  EXPECT_EQ(pure("a_b.c-1!2.0+x-7-py2.py3-none-any.whl"), "a_b.c 1!2.0+x");
  EXPECT_EQ(pure("a-1-cp312-cp312-linux_x86_64.whl"), "a 1 compiled");
  EXPECT_EQ(pure("a-1-py2-none-any.whl"), "a 1 compiled");
  EXPECT_EQ(pure("a-1-py3-none-win32.whl"), "a 1 compiled");
  for (const char* name : {"", "a.whl", "a-1.whl", "a-1-py3-none-any.zip", "a--py3-none-any.whl",
                           "a-1-2-3-py3-none-any.whl", "a/b-1-py3-none-any.whl"})
    EXPECT_EQ(pure(name), "none") << name;
  EXPECT_EQ(normal_project_name("My__Parts.x-Y"), "my-parts-x-y");
}

std::string asked(std::string_view text) {
  const auto need = wheel_requirement(text);
  if (!need) return "none";
  return need->project + (need->versions.empty() ? "" : " ") + need->versions +
         (need->applies ? "" : " not here");
}

TEST(WheelRequirement, NamesAndVersions) {
  EXPECT_EQ(asked("numpy"), "numpy");
  EXPECT_EQ(asked("NumPy (>= 1.20, <3)"), "numpy >=1.20,<3");
  EXPECT_EQ(asked("my_parts[fast, more]~=1.4.2"), "my-parts ~=1.4.2");
  EXPECT_EQ(asked("parts @ https://example.org/parts.whl"), "parts");
  EXPECT_EQ(asked(""), "none");
  EXPECT_EQ(asked("[x]"), "none");
  EXPECT_EQ(asked("parts[x"), "none");
}

TEST(WheelRequirement, MarkersAreThoseOfASite) {
  EXPECT_EQ(asked("a; python_version < '3.8'"), "a not here");
  EXPECT_EQ(asked("a; python_version >= \"3.8\" and python_version < '4'"), "a");
  EXPECT_EQ(asked("a; sys_platform == 'win32' or sys_platform == 'emscripten'"), "a");
  EXPECT_EQ(asked("a; extra == 'test'"), "a not here");
  EXPECT_EQ(asked("a; (os_name != 'posix' or extra == 'x') and python_version > '3'"),
            "a not here");
  EXPECT_EQ(asked("a; platform_system in 'Linux Emscripten'"), "a");
  EXPECT_EQ(asked("a; platform_system not in 'Linux Emscripten'"), "a not here");
}

// Guarantee, hostile input: wheels: requirements that are none, and markers without end
TEST(WheelRequirement, WhatCannotBeReadApplies) {
  for (const char* marker : {"moon_phase == 'full'", "python_version", "python_version < '3", "(",
                             ")", "extra == 'x' nonsense", "python_version =< '3'"})
    EXPECT_EQ(asked("a; " + std::string(marker)), "a") << marker;
  EXPECT_EQ(asked("a; " + std::string(100'000, '(')), "a");
}

TEST(WheelRequirement, Versions) {
  EXPECT_TRUE(fits_versions("2.0.1", ">=1.20,<3"));
  EXPECT_FALSE(fits_versions("2.0.1", "<2"));
  EXPECT_TRUE(fits_versions(kSitePython, ">=3.8"));
  EXPECT_FALSE(fits_versions(kSitePython, ">=3.13"));
  EXPECT_TRUE(fits_versions("1", "what is this"));
}

}  // namespace
}  // namespace ros2wasm
