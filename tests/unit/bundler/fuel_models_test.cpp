// Models of Gazebo Fuel: which are needed, and how they come from a mirror into lock and site.
#include "bundler/fuel_models.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/zip_writer.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/workspace/fuel_needs.hpp"
#include "unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

const std::string kFuel = "https://fuel.gazebosim.org";
const std::string kModels = kFuel + "/1.0/Somebody/models/";

std::string include(const std::string& uri) {
  return "<include><uri>" + uri + "</uri></include>";
}

std::string model(const std::string& inside = "<link name='l'/>") {
  return "<sdf version='1.9'><model name='m'>" + inside + "</model></sdf>";
}

class FuelModels : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(tree_ / "lab/src/lab");
    roots_.working_directory = tree_ / "lab";
    roots_.cache = tree_ / "cache";
    roots_.network.offline = true;
    roots_.network.mirrors.push_back({.base = kFuel, .urls = {(tree_ / "mirror").string()}});
    LocalPackage package;
    package.xml.name.value = "lab";
    package.directory = tree_ / "lab/src/lab";
    packages_.push_back(std::move(package));
    manifest_.fetches_fuel = true;
  }

  void world(const std::string& inside) const {
    tree_.write("lab/src/lab/worlds/w.sdf",
                "<sdf version='1.9'><world name='w'>" + inside + "</world></sdf>");
  }

  /// The mirror has a model of Somebody with these files.
  void offer(const std::string& name, const std::map<std::string, std::string>& files,
             const std::string& version = "tip") const {
    ZipWriter zip;
    for (const auto& [path, bytes] : files) zip.member(path, bytes);
    tree_.write("mirror/1.0/Somebody/models/" + name + "/" + version + "/" + name + ".zip",
                zip.finish());
  }

  std::string titles() const {
    std::string text;
    for (const FuelNeed& one : fuel_needs(packages_, tree_ / "lab", "lab"))
      text += one.title + " " + one.span.file + ":" + std::to_string(one.span.line) + ":" +
              std::to_string(one.span.column) + "\n";
    return text;
  }

  /// Codes of errors and warnings, or "none".
  std::string add(bool must_be_locked = false) {
    sources_ = {};
    Diagnostics found;
    const auto added = add_fuel_models(
        manifest_,
        {.folder = tree_ / "lab", .shown_folder = "lab", .must_be_locked = must_be_locked}, roots_,
        limits_, packages_, sources_, found, {}, {});
    if (!added) found.insert(found.end(), added.errors().begin(), added.errors().end());
    std::string text;
    for (const Diagnostic& one : found)
      text += (text.empty() ? "" : " ") + std::string(one.code) + " " +
              std::to_string(one.span ? one.span->line : 0);
    return text.empty() ? "none" : text;
  }

  void write_lock() const {
    Lock lock;
    lock.sources = sources_to_lock(sources_.trees, packages_);
    tree_.write("lab/ros2wasm.lock", write_lock_text(lock));
  }
  static std::string write_lock_text(const Lock& lock) { return ros2wasm::write_lock(lock); }

  std::string site_files() const {
    SharedFiles files;
    EXPECT_TRUE(collect_fuel_models(sources_.trees, files).ok());
    std::string text;
    for (const auto& [path, bytes] : files) text += path + "\n";
    return text;
  }

  testing::TemporaryTree tree_;
  ChannelRoots roots_;
  ExtractLimits limits_;
  Manifest manifest_;
  std::vector<LocalPackage> packages_;
  WorkspaceSources sources_;
};

TEST_F(FuelModels, AddressesAreFoundInWorldsModelsAndLaunchFiles) {
  world(include(kModels + "Red Ball/2") + "<!-- " + include(kModels + "Comment") + " -->\n" +
        include(kFuel + "/1.0/OpenRobotics/models/Sun") + include(kModels + "At Home") +
        "<description>like " + kModels + "Prose</description>");
  tree_.write("lab/src/lab/models/at_home/model.sdf", model());
  tree_.write("lab/src/lab/urdf/robot.urdf.xacro",
              "<robot xmlns:xacro='x'><mesh filename='" + kModels +
                  "Arm/tip/files/meshes/a.dae'/><mesh filename='" + kModels + "${name}'/></robot>");
  tree_.write("lab/src/lab/launch/a.launch.py", "a = ['-file', '" + kModels + "Cone', f'" +
                                                    kModels + "{name}']  # not '" + kModels +
                                                    "No'\n");
  tree_.write("lab/src/lab/launch/b.launch.xml", "<launch><node args='-name x -file " + kModels +
                                                     "Cone'/><node args='-file " + kModels +
                                                     "Door -x 1'/><node args='-file \"" + kModels +
                                                     "Old Gate\"'/></launch>");
  tree_.write("lab/src/lab/launch/c.launch.yaml",
              "args: -file " + kModels + "Gate  # " + kModels + "No\n");
  tree_.write("lab/src/lab/package.xml", "<package><url>" + kModels + "No</url></package>");
  EXPECT_EQ(titles(),
            "Somebody/Cone lab/src/lab/launch/a.launch.py:1:16\n"
            "Somebody/Door lab/src/lab/launch/b.launch.xml:1:107\n"
            "Somebody/Old Gate lab/src/lab/launch/b.launch.xml:1:185\n"
            "Somebody/Gate lab/src/lab/launch/c.launch.yaml:1:13\n"
            "Somebody/Arm lab/src/lab/urdf/robot.urdf.xacro:1:40\n"
            "Somebody/Red Ball/2 lab/src/lab/worlds/w.sdf:1:50\n");
}

TEST_F(FuelModels, WithoutTheManifestsWordTheyAreWarnings) {
  manifest_.fetches_fuel = false;
  world("\n" + include(kModels + "Ball"));
  EXPECT_EQ(add(), "R2W0532 2");
  EXPECT_TRUE(sources_.trees.empty());
}

TEST_F(FuelModels, AreLockedAndFetchedOnceWithTheModelsThatTheyName) {
  world(include(kModels + "Red%20Ball"));
  offer("Red%20Ball", {{"model.sdf", model(include(kModels + "Stand/3"))},
                       {"materials/red.png", "png"},
                       {"thumbnails/1.png", "png"}});
  // Models that name each other come once each.
  offer("Stand",
        {{"model.config", "<model><sdf>s.sdf</sdf></model>"},
         {"s.sdf", model(include(kModels + "Red Ball"))}},
        "3");
  ASSERT_EQ(add(), "none");
  ASSERT_EQ(sources_.trees.size(), 2U);
  EXPECT_EQ(site_files(),
            "share/ros2wasm_sim/fuel/somebody/red_ball/tip/materials/red.png\n"
            "share/ros2wasm_sim/fuel/somebody/red_ball/tip/model.sdf\n"
            "share/ros2wasm_sim/fuel/somebody/stand/3/model.config\n"
            "share/ros2wasm_sim/fuel/somebody/stand/3/s.sdf\n");
  const LockedSource ball = sources_.trees[0].locked;
  EXPECT_EQ(ball.model, "Somebody/Red Ball");
  EXPECT_EQ(ball.archive, kModels + "Red%20Ball/tip/Red%20Ball.zip");
  const fs::path archive = tree_ / "mirror/1.0/Somebody/models/Red%20Ball/tip/Red%20Ball.zip";
  EXPECT_EQ(ball.sha256, hash_file(archive)->sha256);
  EXPECT_EQ(ball.size, fs::file_size(archive));

  // With the lock, the cache is enough, and a new version on Fuel changes nothing.
  write_lock();
  offer("Red%20Ball", {{"model.sdf", model()}});
  EXPECT_EQ(add(true), "none");
  EXPECT_EQ(sources_.trees[0].locked, ball);
  fs::remove_all(tree_ / "mirror");
  EXPECT_EQ(add(true), "none");
  EXPECT_EQ(sources_.trees.size(), 2U);
  // Without the cache it must be fetched, and only the locked one is accepted.
  fs::remove_all(roots_.cache);
  EXPECT_EQ(add(true), "R2W0253 1");
}

TEST_F(FuelModels, ALockThatMustFitIsNotAddedTo) {
  world(include(kModels + "Ball"));
  offer("Ball", {{"model.sdf", model()}});
  EXPECT_EQ(add(true), "R2W0311 1");
  EXPECT_FALSE(fs::exists(roots_.cache / "archives"));
}

TEST_F(FuelModels, OneThatIsNotThereIsNamedWithItsPlace) {
  world("\n\n" + include(kModels + "Ball"));
  EXPECT_EQ(add(), "R2W0232 3");
}

// Guarantee, hostile input: models of Fuel with names that lead outside, bombs, and no model
TEST_F(FuelModels, HostileArchivesAreRefused) {
  world(include(kModels + "Ball"));
  offer("Ball", {{"model.sdf", model()}, {"../../../out", "x"}});
  EXPECT_EQ(add(), "R2W0222 1");
  EXPECT_FALSE(fs::exists(tree_ / "cache/sources/out"));
  offer("Ball", {{"model.sdf", model()}, {"Model.SDF", model()}});
  EXPECT_EQ(add(), "R2W0224 1");
  offer("Ball", {{"readme.txt", "x"}});
  EXPECT_EQ(add(), "R2W0536 1");
  tree_.write("mirror/1.0/Somebody/models/Ball/tip/Ball.zip", "<html>Please log in</html>");
  EXPECT_EQ(add(), "R2W0221 1");
  offer("Ball", {{"model.sdf", model()}, {"large.bin", std::string(100'000, 'x')}});
  limits_.total_bytes = 50'000;
  EXPECT_EQ(add(), "R2W0225 1");
}

TEST_F(FuelModels, ModelsThatNameOthersWithoutEndAreRefused) {
  world(include(kModels + "M0"));
  for (int i = 0; i <= 201; ++i)
    offer("M" + std::to_string(i),
          {{"model.sdf", model(include(kModels + "M" + std::to_string(i + 1)))}});
  EXPECT_EQ(add(), "R2W0536 1");
}

TEST_F(FuelModels, ALockOfAStrangerNamesNoPlaceOutside) {
  for (const char* title : {"", "a", "../b", "a/../b", "a/..", "./a"})
    EXPECT_EQ(fuel_folder_of(title), "") << title;
  EXPECT_EQ(fuel_folder_of("Open Robotics/Coke Can/2"), "open_robotics/coke_can/2");
  EXPECT_EQ(fuel_folder_of("O/M/../../x"), "o/m/tip");
  EXPECT_EQ(fuel_folder_of("o/m\n"), "o/m_0a/tip");
}

}  // namespace
}  // namespace ros2wasm
