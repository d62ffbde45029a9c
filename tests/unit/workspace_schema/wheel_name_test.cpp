// Names of wheels: which of them a site can run.
#include "workspace_schema/conda/wheel_name.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

bool runs(const std::string& tags) {
  const auto name = wheel_name("parts-1.2-" + tags + ".whl");
  return name && (name->is_pure() || name->is_for_site_abi());
}

TEST(WheelName, OfTheInterpreterOfSites) {
  for (const char* tags :
       {"py3-none-any", "py2.py3-none-any", "cp312-cp312-pyodide_2024_0_wasm32",
        "cp312-cp312-emscripten_3_1_58_wasm32", "cp39-abi3-pyodide_2024_0_wasm32",
        "cp312-abi3-pyodide_2024_0_wasm32", "cp35-abi3-pyodide_2024_0_wasm32",
        "py3-none-pyodide_2024_0_wasm32", "cp311.cp312-cp312-pyodide_2024_0_wasm32",
        "cp312-cp312-pyodide_2023_0_wasm32.pyodide_2024_0_wasm32"})
    EXPECT_TRUE(runs(tags)) << tags;
}

TEST(WheelName, OfAnotherPythonOrAnotherAbi) {
  for (const char* tags :
       {"cp312-cp312-manylinux_2_17_x86_64", "cp313-cp313-pyodide_2024_0_wasm32",
        "cp311-cp311-pyodide_2024_0_wasm32", "cp312-cp312-pyodide_2025_0_wasm32",
        "cp312-cp312-pyemscripten_2025_0_wasm32", "cp313-abi3-pyodide_2024_0_wasm32",
        "cp312-cp312t-pyodide_2024_0_wasm32", "pp310-abi3-pyodide_2024_0_wasm32",
        "py2-none-pyodide_2024_0_wasm32", "cp312-cp312-any", "cp3x-abi3-pyodide_2024_0_wasm32"})
    EXPECT_FALSE(runs(tags)) << tags;
}

}  // namespace
}  // namespace ros2wasm
