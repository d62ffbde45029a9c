// Classes that register themselves and are made by name. A site links everything statically, so
// "loading a library" finds the classes of it that were linked into the program.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "class_loader/exceptions.hpp"

namespace class_loader {

namespace impl {

/// One registered class. `make` returns a new object as a pointer to its base.
struct RegisteredClass {
  std::string name;
  std::string base;
  std::string library;  ///< file name, empty when the build did not say
  void* (*make)();
};

void register_class(RegisteredClass registered);
/// Throws LibraryLoadException when the program has nothing of the library.
void require_library(const std::string& path);
/// The classes of one library (a path or a file name), or of all when it is empty.
std::vector<std::string> class_names(const std::string& base, const std::string& library);
/// Name and library of each.
std::vector<std::pair<std::string, std::string>> classes_and_libraries(const std::string& base);
/// Throws CreateClassException for an unknown name.
void* make_object(const std::string& name, const std::string& base, const std::string& library);

template <typename Derived, typename Base>
struct Registrar {
  Registrar(const char* name, const char* library) {
    register_class({name, typeid(Base).name(), library,
                    []() -> void* { return static_cast<Base*>(new Derived); }});
  }
};

}  // namespace impl

class ClassLoader {
 public:
  template <typename Base>
  using DeleterType = std::function<void(Base*)>;
  template <typename Base>
  using UniquePtr = std::unique_ptr<Base, DeleterType<Base>>;

  explicit ClassLoader(const std::string& library_path, bool ondemand_load_unload = false)
      : library_path_(library_path), on_demand_(ondemand_load_unload) {
    impl::require_library(library_path_);
  }
  virtual ~ClassLoader() = default;

  template <class Base>
  std::vector<std::string> getAvailableClasses() const {
    return impl::class_names(typeid(Base).name(), library_path_);
  }
  template <class Base>
  std::shared_ptr<Base> createInstance(const std::string& derived_class_name) {
    return std::shared_ptr<Base>(make<Base>(derived_class_name));
  }
  template <class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string& derived_class_name) {
    return createInstance<Base>(derived_class_name);
  }
  template <class Base>
  UniquePtr<Base> createUniqueInstance(const std::string& derived_class_name) {
    return UniquePtr<Base>(make<Base>(derived_class_name), [](Base* object) { delete object; });
  }
  template <class Base>
  Base* createUnmanagedInstance(const std::string& derived_class_name) {
    return make<Base>(derived_class_name);
  }
  template <class Base>
  bool isClassAvailable(const std::string& class_name) const {
    for (const std::string& name : getAvailableClasses<Base>()) {
      if (name == class_name) {
        return true;
      }
    }
    return false;
  }
  const std::string& getLibraryPath() const { return library_path_; }
  bool isLibraryLoaded() const { return true; }
  bool isLibraryLoadedByAnyClassloader() const { return true; }
  bool isOnDemandLoadUnloadEnabled() const { return on_demand_; }
  void loadLibrary() {}
  int unloadLibrary() { return 0; }

 private:
  template <class Base>
  Base* make(const std::string& name) {
    return static_cast<Base*>(impl::make_object(name, typeid(Base).name(), library_path_));
  }

  std::string library_path_;
  bool on_demand_;
};

}  // namespace class_loader

#include "class_loader/register_macro.hpp"
