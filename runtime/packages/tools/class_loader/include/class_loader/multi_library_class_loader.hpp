// Classes of several libraries, by name.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"

namespace class_loader {

using LibraryPath = std::string;
using ClassLoaderVector = std::vector<ClassLoader*>;

class MultiLibraryClassLoader {
 public:
  explicit MultiLibraryClassLoader(bool enable_ondemand_loadunload)
      : on_demand_(enable_ondemand_loadunload) {}
  virtual ~MultiLibraryClassLoader() = default;

  template <class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string& class_name) {
    return with_class<Base>(class_name).template createSharedInstance<Base>(class_name);
  }
  template <class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string& class_name,
                                             const std::string& library_path) {
    return of_library(library_path).template createSharedInstance<Base>(class_name);
  }
  template <class Base>
  std::shared_ptr<Base> createInstance(const std::string& class_name) {
    return createSharedInstance<Base>(class_name);
  }
  template <class Base>
  std::shared_ptr<Base> createInstance(const std::string& class_name,
                                       const std::string& library_path) {
    return createSharedInstance<Base>(class_name, library_path);
  }
  template <class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(const std::string& class_name) {
    return with_class<Base>(class_name).template createUniqueInstance<Base>(class_name);
  }
  template <class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(const std::string& class_name,
                                                    const std::string& library_path) {
    return of_library(library_path).template createUniqueInstance<Base>(class_name);
  }
  template <class Base>
  Base* createUnmanagedInstance(const std::string& class_name) {
    return with_class<Base>(class_name).template createUnmanagedInstance<Base>(class_name);
  }
  template <class Base>
  Base* createUnmanagedInstance(const std::string& class_name, const std::string& library_path) {
    return of_library(library_path).template createUnmanagedInstance<Base>(class_name);
  }
  template <class Base>
  bool isClassAvailable(const std::string& class_name) {
    return find_class<Base>(class_name) != nullptr;
  }
  bool isLibraryAvailable(const std::string& library_path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return loaders_.count(library_path) != 0;
  }
  template <class Base>
  std::vector<std::string> getAvailableClasses() {
    std::vector<std::string> all;
    for (ClassLoader* const loader : loaders()) {
      for (std::string& name : loader->getAvailableClasses<Base>()) {
        all.push_back(std::move(name));
      }
    }
    return all;
  }
  template <class Base>
  std::vector<std::string> getAvailableClassesForLibrary(const std::string& library_path) {
    return of_library(library_path).template getAvailableClasses<Base>();
  }
  std::vector<std::string> getRegisteredLibraries() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> paths;
    for (const auto& [path, loader] : loaders_) {
      paths.push_back(path);
    }
    return paths;
  }
  /// Throws LibraryLoadException when the program has nothing of the library.
  void loadLibrary(const std::string& library_path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto& loader = loaders_[library_path];
    if (!loader) {
      try {
        loader = std::make_unique<ClassLoader>(library_path, on_demand_);
      } catch (...) {
        loaders_.erase(library_path);
        throw;
      }
    }
  }
  /// How often the library must still be unloaded: never.
  int unloadLibrary(const std::string& library_path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    loaders_.erase(library_path);
    return 0;
  }

 private:
  ClassLoaderVector loaders() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ClassLoaderVector all;
    for (const auto& [path, loader] : loaders_) {
      all.push_back(loader.get());
    }
    return all;
  }
  template <class Base>
  ClassLoader* find_class(const std::string& class_name) {
    for (ClassLoader* const loader : loaders()) {
      if (loader->isClassAvailable<Base>(class_name)) {
        return loader;
      }
    }
    return nullptr;
  }
  template <class Base>
  ClassLoader& with_class(const std::string& class_name) {
    ClassLoader* const loader = find_class<Base>(class_name);
    if (loader == nullptr) {
      throw CreateClassException(
          "MultiLibraryClassLoader: Could not create object of class type " + class_name +
          " as no factory exists for it. Make sure that the library exists and was explicitly "
          "loaded through MultiLibraryClassLoader::loadLibrary()");
    }
    return *loader;
  }
  ClassLoader& of_library(const std::string& library_path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = loaders_.find(library_path);
    if (found == loaders_.end()) {
      throw NoClassLoaderExistsException(
          "Could not create instance as there is no ClassLoader in MultiLibraryClassLoader bound "
          "to library " +
          library_path + " Ensure you called MultiLibraryClassLoader::loadLibrary()");
    }
    return *found->second;
  }

  const bool on_demand_;
  std::mutex mutex_;
  std::map<LibraryPath, std::unique_ptr<ClassLoader>> loaders_;
};

}  // namespace class_loader
