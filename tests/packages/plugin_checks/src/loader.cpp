// Loads plugins by name: of its own package, and of one that is built after it.

// Compatibility, works: pluginlib: descriptions, `ClassLoader` with shared, unique and unmanaged
// objects, its questions and exceptions, plugins of packages that are built after the program

// Compatibility, differs: libraries of plugins -> are linked into the programs of the workspace
// that link pluginlib, when a description names as base the program's package or one that it needs;
// loading a plugin whose library is not a target of its package throws `LibraryLoadException`

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "ament_index_cpp/get_package_prefix.hpp"
#include "checks.hpp"
#include "plugin_checks/shape.hpp"
#include "pluginlib/class_loader.hpp"

using plugin_checks::Shape;
using Loader = pluginlib::ClassLoader<Shape>;

namespace {

template <typename ErrorT>
std::string text_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ErrorT& error) {
    return error.what();
  }
  return {};
}

void check_descriptions(Checks& checks, Loader& loader) {
  CHECK(loader.getDeclaredClasses() ==
        (std::vector<std::string>{"absent", "plugin_checks::Dot", "plugin_shapes/Square",
                                  "triangle"}));
  CHECK(loader.getPluginXmlPaths() ==
        (std::vector<std::string>{"/opt/ros/jazzy/share/plugin_checks/own_plugins.xml",
                                  "/opt/ros/jazzy/share/plugin_shapes/config/shapes.xml"}));
  CHECK(loader.getBaseClassType() == "plugin_checks::Shape");
  CHECK(loader.isClassAvailable("triangle") && !loader.isClassAvailable("circle"));
  CHECK(loader.getClassType("triangle") == "plugin_shapes::Triangle" &&
        loader.getClassType("circle").empty());
  CHECK(loader.getName("plugin_shapes/Square") == "Square" &&
        loader.getName("plugin_checks::Dot") == "Dot");
  CHECK(loader.getClassPackage("triangle") == "plugin_shapes");
  CHECK(loader.getClassDescription("plugin_checks::Dot") == "It has no area & no name of its own.");
  CHECK(loader.getPluginManifestPath("plugin_checks::Dot") == loader.getPluginXmlPaths().front());
  CHECK(loader.getClassLibraryPath("triangle") == "/opt/ros/jazzy/lib/libshapes.so");
}

void check_objects(Checks& checks, Loader& loader) {
  CHECK(!loader.isClassLoaded("triangle") && loader.getRegisteredLibraries().empty());
  CHECK_THROWS(pluginlib::LibraryUnloadException, loader.unloadLibraryForClass("triangle"));
  const std::shared_ptr<Shape> triangle = loader.createSharedInstance("triangle");
  triangle->initialize(10);
  CHECK(triangle->area() > 43.3 && triangle->area() < 43.31);
  CHECK(loader.isClassLoaded("triangle") && loader.isClassLoaded("plugin_shapes/Square"));
  CHECK(loader.getRegisteredLibraries() ==
        (std::vector<std::string>{"/opt/ros/jazzy/lib/libshapes.so"}));
  const int ended = Shape::ended();
  {
    pluginlib::UniquePtr<Shape> square = loader.createUniqueInstance("plugin_shapes/Square");
    square->initialize(10);
    CHECK(square->area() == 100);
  }
  CHECK(Shape::ended() == ended + 1);
  const std::unique_ptr<Shape> dot(loader.createUnmanagedInstance("plugin_checks::Dot"));
  CHECK(dot->area() == 0 && loader.unloadLibraryForClass("plugin_checks::Dot") == 0);
  CHECK(!loader.isClassLoaded("plugin_checks::Dot") && triangle->area() > 43);
  CHECK(loader.unloadLibraryForClass("plugin_checks::Dot") == 0);
}

void check_errors(Checks& checks, Loader& loader) {
  CHECK(text_of<pluginlib::LibraryLoadException>([&] { loader.createSharedInstance("circle"); }) ==
        "According to the loaded plugin descriptions the class circle with base class type "
        "plugin_checks::Shape does "
        "not exist. Declared types are  absent plugin_checks::Dot plugin_shapes/Square triangle");
  CHECK(text_of<pluginlib::LibraryLoadException>([&] {
          loader.createUniqueInstance("absent");
        }).find("Could not find library corresponding to plugin absent.") == 0);
  CHECK_THROWS(pluginlib::LibraryUnloadException, loader.unloadLibraryForClass("circle"));
  CHECK_THROWS(ament_index_cpp::PackageNotFoundError,
               Loader("no_such_package", "plugin_checks::Shape"));
  Loader others("plugin_checks", "plugin_checks::Solid");
  CHECK(others.getDeclaredClasses() == (std::vector<std::string>{"wrong"}));
  CHECK_THROWS(pluginlib::CreateClassException, others.createSharedInstance("wrong"));
  CHECK_THROWS(pluginlib::PluginlibException, others.createSharedInstance("wrong"));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("loader");
  Loader loader("plugin_checks", "plugin_checks::Shape");
  check_descriptions(checks, loader);
  check_objects(checks, loader);
  check_errors(checks, loader);
  return checks.finish();
}
