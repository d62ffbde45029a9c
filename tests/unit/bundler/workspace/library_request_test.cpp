// The libraries of Pyodide's distribution that a workspace asks for.
#include "bundler/workspace/library_request.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bundler/workspace/python_requirements.hpp"

namespace ros2wasm {
namespace {

std::string row(const std::string& name, const std::string& version, const std::string& imports,
                const std::string& depends) {
  return "\"" + name + R"(": {"version": ")" + version + R"(", "file_name": ")" + name +
         R"(-1.whl", "package_type": "package", "sha256": ")" + std::string(64, 'a') +
         R"(", "imports": [)" + imports + R"(], "depends": [)" + depends + "]}";
}

PythonLibraries distribution() {
  const std::string text =
      R"({"info": {"abi_version": "2024_0", "version": "0.27.8"}, "packages": {)" +
      row("opencv-python", "4.10.0", R"("cv2")", R"("numpy")") + "," +
      row("scipy", "1.14.1", R"("scipy")", R"("numpy", "openblas")") + "," +
      row("openblas", "0.3", "", "") + "," + row("numpy", "2.0.2", R"("numpy")", "") + "," +
      row("scikit-image", "0.25", R"("skimage")", R"("scipy", "Pillow", "lazy_loader")") + "," +
      row("Pillow", "10.2", R"("PIL")", "") + "," +
      row("matplotlib", "3.8.4", R"("matplotlib")", "") + "," +
      row("lazy-loader", "0.4", R"("lazy_loader")", "") + "," +
      row("requests", "2.31", R"("requests")", "") + "}}";
  auto read = read_python_libraries(text, "lock");
  EXPECT_TRUE(read);
  return *std::move(read);
}

class LibraryRequests : public ::testing::Test {
 protected:
  LibraryRequests() : libraries_(distribution()) { packages_.emplace_back(); }

  void import(const std::string& module, std::vector<std::string> names = {}, bool needed = true) {
    packages_.front().python_uses.push_back(
        {.module = module, .names = std::move(names), .needed = needed, .span = {}});
  }
  void depend(const std::string& key) {
    packages_.front().xml.dependencies.push_back(
        {.kind = DependencyKind::kExec, .name = {.value = key, .span = {}}, .version_limits = {}});
  }

  Outcome<LibraryRequest> request() {
    return library_request({.manifest = manifest_,
                            .packages = packages_,
                            .left_out = {},
                            .wheels = {},
                            .known = known_,
                            .notebook_modules = {},
                            .libraries = libraries_});
  }

  std::vector<std::string> asked() {
    std::vector<std::string> names;
    const auto made = request();
    EXPECT_TRUE(made);
    for (const LockedLibrary& one : made->libraries) names.push_back(one.project);
    for (const RequestedSpec& one : made->specs) names.push_back("channel " + one.text);
    return names;
  }

  using Names = std::vector<std::string>;
  PythonLibraries libraries_;
  Manifest manifest_;
  std::vector<LocalPackage> packages_;
  KnownNames known_{.names = {"numpy", "pyyaml", "scipy"}, .of_lock = false, .absent = {}};
};

TEST_F(LibraryRequests, TakesWhatNobodyElseHas) {
  EXPECT_EQ(asked(), Names{});
  import("numpy");
  import("yaml");
  EXPECT_EQ(asked(), Names{});
  import("cv2.aruco");
  EXPECT_EQ(asked(), (Names{"opencv-python", "channel numpy"}));
}

TEST_F(LibraryRequests, LeavesTheChannelsPartWhereItIsEnough) {
  import("scipy.spatial.transform", {"Rotation", "Slerp"});
  EXPECT_EQ(asked(), Names{});
  import("scipy.spatial.transform", {"RotationSpline"});
  EXPECT_EQ(asked(), (Names{"openblas", "scipy", "channel numpy"}));
}

TEST_F(LibraryRequests, LeavesTheChannelsOpenCvWhereItIsEnough) {
  known_.names = {"numpy", "py-opencv"};
  import("cv2");
  import("cv2.aruco");
  EXPECT_EQ(asked(), Names{});
  packages_.front().python_uses.back().module = "cv2";
  packages_.front().python_uses.back().attributes = {"cvtColor", "findContours"};
  EXPECT_EQ(asked(), Names{});
  packages_.front().python_uses.back().attributes = {"cvtColor", "findChessboardCorners"};
  EXPECT_EQ(asked(), (Names{"opencv-python", "channel numpy"}));
  packages_.front().python_uses.back() = {.module = "cv2", .names = {"dnn"}, .span = {}};
  EXPECT_EQ(asked(), (Names{"opencv-python", "channel numpy"}));
}

TEST_F(LibraryRequests, TakesAllOfALibraryThatAnotherNeeds) {
  import("skimage");
  EXPECT_EQ(asked(),
            (Names{"lazy-loader", "openblas", "pillow", "scikit-image", "scipy", "channel numpy"}));
}

TEST_F(LibraryRequests, AsksForThePanelsOfLibrariesWithWindows) {
  manifest_.distro = "jazzy";
  known_.names = {"numpy", "ros-jazzy-ros2wasm-figures"};
  import("scipy");
  const Names without = asked();
  EXPECT_EQ(std::count(without.begin(), without.end(), "channel ros-jazzy-ros2wasm-figures"), 0);
  for (const char* module : {"matplotlib", "PIL"}) {
    packages_.front().python_uses.clear();
    import(module);
    const Names with = asked();
    EXPECT_EQ(std::count(with.begin(), with.end(), "channel ros-jazzy-ros2wasm-figures"), 1)
        << module;
  }
}

TEST_F(LibraryRequests, TakesWhatAProgramCanDoWithoutOnlyByItsKey) {
  import("cv2", {}, false);
  EXPECT_EQ(asked(), Names{});
  depend("python3-opencv");
  EXPECT_EQ(asked(), (Names{"opencv-python", "channel numpy"}));
}

TEST_F(LibraryRequests, TakesNothingThatNeedsSocketsByItsImport) {
  import("requests");
  EXPECT_EQ(asked(), Names{});
  manifest_.python_packages.push_back({.value = "requests", .span = {}});
  EXPECT_EQ(asked(), Names{"requests"});
}

TEST_F(LibraryRequests, ComparesVersions) {
  manifest_.python_packages.push_back({.value = "numpy>=2", .span = {}});
  packages_.front().python_requirements = requirements_of_setup(
      "setup(install_requires=['numpy<2', \"scipy\", 'absent>1'])", "setup.py");
  const auto made = request();
  ASSERT_TRUE(made);
  ASSERT_EQ(made->warnings.size(), 1U);
  EXPECT_EQ(made->warnings.front().message, "a site has `numpy` 2.0.2, and not `numpy<2`");
  manifest_.python_packages.push_back({.value = "nunpy", .span = {}});
  const auto unknown = request();
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.errors().front().code.text(), "R2W0127");
  EXPECT_EQ(unknown.errors().front().fix, Names{"write `numpy`"});
}

TEST(PythonLibraries, FindsProjectsByTheirNames) {
  const PythonLibraries libraries = distribution();
  for (const char* name : {"python3-opencv", "opencv-python", "cv2", "opencv-python-headless"})
    EXPECT_EQ(library_project(name, libraries), "opencv-python") << name;
  for (const char* name : {"python3-pil", "PIL", "pillow", "python3-pil-pip"})
    EXPECT_EQ(library_project(name, libraries), "pillow") << name;
  EXPECT_EQ(library_project("python3-skimage", libraries), "scikit-image");
  EXPECT_EQ(library_project("rclpy", libraries), "");
}

TEST(PythonLibraries, RefusesOtherLocks) {
  const auto code = [](const std::string& text) {
    const auto read = read_python_libraries(text, "lock");
    return read ? "read" : read.errors().front().code.text();
  };
  EXPECT_EQ(code("{"), "R2W0128");
  EXPECT_EQ(code("[]"), "R2W0128");
  const std::string begin = R"({"info": {"abi_version": "2024_0"}, "packages": {"x": )";
  EXPECT_EQ(
      code(begin + R"({"file_name": "../x.whl", "sha256": ")" + std::string(64, 'a') + "\"}}}"),
      "R2W0128");
  EXPECT_EQ(code(begin + R"({"file_name": "x.whl", "sha256": "abc"}}})"), "R2W0128");
  EXPECT_EQ(code(R"({"info": {"abi_version": "2025_0"}, "packages": {"x": {}}})"), "R2W0128");
}

TEST(PythonRequirements, OfAList) {
  std::vector<std::string> texts;
  for (const auto& one : requirements_of_list("# what it needs\nnumpy>=1.20  # fast\n\n-r "
                                              "more.txt\n./here\nhttps://x/y.whl\n  pandas\r\n",
                                              "requirements.txt"))
    texts.push_back(one.value + "@" + std::to_string(one.span.line));
  EXPECT_EQ(texts, (std::vector<std::string>{"numpy>=1.20@2", "pandas@7"}));
  EXPECT_TRUE(requirements_of_setup("setup(install_requires=['numpy", "setup.py").empty());
  EXPECT_TRUE(requirements_of_setup("install_requires", "setup.py").empty());
}

}  // namespace
}  // namespace ros2wasm
