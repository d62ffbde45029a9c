// Makes objects of the plugins whose descriptions name base class T. A site links everything
// statically: a program is linked with the plugins of its workspace when all packages are built.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pluginlib/class_loader_base.hpp"

namespace pluginlib {

template <typename T>
using UniquePtr = class_loader::ClassLoader::UniquePtr<T>;

template <class T>
class ClassLoader : public ClassLoaderBase {
 public:
  ClassLoader(std::string package, std::string base_class, std::string attrib_name = "plugin",
              std::vector<std::string> plugin_xml_paths = std::vector<std::string>())
      : classes_(std::move(package), std::move(base_class), std::move(attrib_name),
                 std::move(plugin_xml_paths)) {}
  ~ClassLoader() override = default;

  std::shared_ptr<T> createSharedInstance(const std::string& lookup_name) {
    return std::shared_ptr<T>(createUnmanagedInstance(lookup_name));
  }
  UniquePtr<T> createUniqueInstance(const std::string& lookup_name) {
    return UniquePtr<T>(createUnmanagedInstance(lookup_name), [](T* object) { delete object; });
  }
  T* createUnmanagedInstance(const std::string& lookup_name) {
    class_loader::ClassLoader& loader = classes_.load(lookup_name);
    try {
      return loader.createUnmanagedInstance<T>(getClassType(lookup_name));
    } catch (const class_loader::CreateClassException& error) {
      throw CreateClassException(error.what());
    }
  }

  std::vector<std::string> getPluginXmlPaths() override { return classes_.paths(); }
  std::vector<std::string> getDeclaredClasses() override { return classes_.names(); }
  void refreshDeclaredClasses() override { classes_.refresh(); }
  /// The last part of `package/name` or `package::name`.
  std::string getName(const std::string& lookup_name) override {
    const auto at = lookup_name.find_last_of("/:");
    return at == std::string::npos ? lookup_name : lookup_name.substr(at + 1);
  }
  bool isClassAvailable(const std::string& lookup_name) override {
    return classes_.find(lookup_name) != nullptr;
  }
  /// These are empty for a class that no description has.
  std::string getClassType(const std::string& lookup_name) override {
    return told(lookup_name, &ClassDesc::derived_class_);
  }
  std::string getClassDescription(const std::string& lookup_name) override {
    return told(lookup_name, &ClassDesc::description_);
  }
  std::string getClassPackage(const std::string& lookup_name) override {
    return told(lookup_name, &ClassDesc::package_);
  }
  std::string getPluginManifestPath(const std::string& lookup_name) override {
    return told(lookup_name, &ClassDesc::plugin_manifest_path_);
  }
  std::string getBaseClassType() const override { return classes_.base_class(); }
  std::vector<std::string> getRegisteredLibraries() override { return classes_.libraries(); }
  std::string getClassLibraryPath(const std::string& lookup_name) override {
    return classes_.library_path(lookup_name);
  }
  bool isClassLoaded(const std::string& lookup_name) override {
    return classes_.is_loaded(lookup_name);
  }
  void loadLibraryForClass(const std::string& lookup_name) override { classes_.load(lookup_name); }
  int unloadLibraryForClass(const std::string& lookup_name) override {
    return classes_.unload(lookup_name);
  }

 private:
  std::string told(const std::string& lookup_name, std::string ClassDesc::*what) const {
    const ClassDesc* const found = classes_.find(lookup_name);
    return found == nullptr ? std::string() : found->*what;
  }

  impl::DeclaredClasses classes_;
};

}  // namespace pluginlib
