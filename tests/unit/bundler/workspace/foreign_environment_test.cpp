// Files of other tools as a start: what is taken over, what is refused.
#include "bundler/workspace/foreign_environment.hpp"

#include <gtest/gtest.h>

#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/manifest_init.hpp"
#include "unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/schema/lock.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

using Texts = std::vector<std::string>;

ForeignEnvironment taken(const std::string& text, const std::string& file,
                         const std::string& environment = {}) {
  auto read = read_foreign_environment(text, file, environment);
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.errors().front().message);
  return read.ok() ? std::move(*read) : ForeignEnvironment();
}

std::string refusal(const std::string& text, const std::string& file) {
  const auto read = read_foreign_environment(text, file, {});
  return read.ok() ? "taken over" : read.errors().front().code.text();
}

constexpr const char* kPixiLock = R"(version: 6
environments:
  default:
    channels:
    - url: https://host/forge/
    packages:
      linux-64:
      - conda: https://host/forge/linux-64/other-1-0.conda
  web:
    channels:
    - url: https://host/forge/
    packages:
      emscripten-wasm32:
      - conda: https://host/forge/noarch/a-1.0-h_0.conda
      - conda: https://host/forge/emscripten-wasm32/b-lib-2.0-h_1.tar.bz2
      - pypi: https://files/x.whl
packages:
- conda: https://host/forge/linux-64/other-1-0.conda
- conda: https://host/forge/noarch/a-1.0-h_0.conda
  sha256: e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855
  md5: d41d8cd98f00b204e9800998ecf8427e
  depends:
  - b-lib >=2
  size: 7
- conda: https://host/forge/emscripten-wasm32/b-lib-2.0-h_1.tar.bz2
  build_number: 1
  depends: []
  constrains:
  - c <1
)";

constexpr const char* kCondaLock = R"(version: 1
metadata:
  channels:
  - url: conda-forge
  platforms: [emscripten-wasm32, linux-64]
package:
- {name: a, version: '1.0', manager: conda, platform: emscripten-wasm32, dependencies: {b: '>=1', __unix: ''},
   url: 'https://host/forge/noarch/a-1.0-h_0.conda', hash: {md5: d41d8cd98f00b204e9800998ecf8427e}}
- {name: b, version: '1.1', manager: conda, platform: emscripten-wasm32, dependencies: {},
   url: 'https://host/forge/emscripten-wasm32/b-1.1-0.conda', hash: {}}
- {name: b, version: '1.1', manager: conda, platform: linux-64, dependencies: {},
   url: 'https://host/forge/linux-64/b-1.1-0.conda', hash: {}}
- {name: p, version: '1', manager: pip, platform: emscripten-wasm32, dependencies: {}, url: 'https://x'}
)";

TEST(ForeignEnvironment, EnvironmentFiles) {
  const auto made = taken(R"(name: course
channels: [https://host/forge/, nodefaults]
dependencies:
  - python >=3.11
  - forge::numpy=1.25
  - pip:
      - requests
)",
                          "environment.yml");
  EXPECT_EQ(made.name, "course");
  EXPECT_EQ(made.channels, Texts{"https://host/forge"});
  EXPECT_EQ(made.specs, (Texts{"python >=3.11", "forge::numpy=1.25"}));
  EXPECT_EQ(made.left_out, Texts{"requests (of pip)"});
  EXPECT_EQ(refusal("dependencies: ['a >=']", "environment.yml"), "R2W0340");
  EXPECT_EQ(refusal("other: 1", "environment.yml"), "R2W0340");
  EXPECT_EQ(refusal("[", "environment.yml"), "R2W0340");
}

TEST(ForeignEnvironment, PixiManifests) {
  const auto made = taken(R"(# a comment
[workspace]
name = "course"  # another
channels = ["https://host/forge", { channel = 'other', priority = 1 }]
platforms = ["emscripten-wasm32",
  "linux-64", # the last
]

[dependencies]
python = ">=3.11,<3.12"
numpy = { version = "1.25.*", build = "*_0", channel = "forge" }
"pkg.x" = "*"
own = { path = "../own" }
[target.emscripten-wasm32.dependencies]
pyjs = "==2.1"
[target.linux-64.dependencies]
gcc = "*"
[pypi-dependencies]
requests = "*"
[tasks]
run = { cmd = ["a", "b"], env = { X = "1" } }
)",
                          "pixi.toml");
  EXPECT_EQ(made.name, "course");
  EXPECT_EQ(made.channels, (Texts{"https://host/forge", "other"}));
  EXPECT_EQ(made.specs, (Texts{"python >=3.11,<3.12", "forge::numpy 1.25.*[build='*_0']", "pkg.x",
                               "pyjs ==2.1"}));
  EXPECT_EQ(made.left_out, (Texts{"own (from elsewhere than a channel)",
                                  "requests (of pypi-dependencies)", "gcc (of target)"}));
  for (const char* text :
       {"", "[workspace]\nname = \"x\"", "[workspace", "[workspace]\nchannels = [",
        "[workspace]\nchannels = [\"x", "[dependencies]\na = \"><\"", "a.b"}) {
    EXPECT_EQ(refusal(text, "pixi.toml"), "R2W0340") << text;
  }
  EXPECT_EQ(refusal("a = " + std::string(10'000, '['), "pixi.toml"), "R2W0340");
}

TEST(ForeignEnvironment, PixiLocks) {
  const auto made = taken(kPixiLock, "pixi.lock");
  EXPECT_EQ(made.name, "web");  // the only one for the platform
  EXPECT_EQ(made.specs, Texts{"a"});
  EXPECT_EQ(made.left_out, Texts{"https://files/x.whl (of PyPI)"});
  ASSERT_EQ(made.packages.size(), 2U);
  EXPECT_EQ(made.packages[0].channel, "https://host/forge");
  EXPECT_EQ(made.packages[0].size, 7U);
  EXPECT_EQ(made.packages[1].name, "b-lib");
  EXPECT_EQ(made.packages[1].subdir, "emscripten-wasm32");
  EXPECT_EQ(made.packages[1].constrains, Texts{"c <1"});
  EXPECT_TRUE(check_solution({}, made.packages).empty());
  EXPECT_FALSE(read_foreign_environment(kPixiLock, "pixi.lock", "default").ok());
  EXPECT_EQ(refusal("environments: {}\npackages: []\n", "pixi.lock"), "R2W0341");
}

TEST(ForeignEnvironment, CondaLocks) {
  const auto made = taken(kCondaLock, "conda-lock.yml");
  EXPECT_EQ(made.format, "conda-lock");
  ASSERT_EQ(made.packages.size(), 2U);
  EXPECT_EQ(made.packages[0].depends, (Texts{"b >=1", "__unix"}));
  EXPECT_EQ(made.specs, Texts{"a"});
  EXPECT_EQ(made.left_out, Texts{"p (of pip)"});
}

TEST(ForeignEnvironment, BecomesAWorkspaceWithALock) {
  testing::TemporaryTree tree;
  const auto file = tree.write("course/pixi.lock", kPixiLock);
  const auto report = init_from_environment(file, {}, {});
  ASSERT_TRUE(report.ok()) << report.errors().front().message;
  ASSERT_EQ(report->written.size(), 2U);
  const auto manifest = read_manifest(tree.read("course/workspace.yaml"), "workspace.yaml");
  ASSERT_TRUE(manifest.ok());
  EXPECT_EQ(manifest->dependencies.front().value, "a");
  EXPECT_EQ(manifest->channels.back().value, "https://host/forge");
  const auto lock = read_lock(tree.read("course/ros2wasm.lock"), "ros2wasm.lock");
  ASSERT_TRUE(lock.ok());
  EXPECT_EQ(lock->packages.size(), 2U);
  const auto again = init_from_environment(file, {}, {});
  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.errors().front().code.text(), "R2W0630");
}

}  // namespace
}  // namespace ros2wasm
