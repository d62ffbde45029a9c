// The part of ClassLoader that does not depend on its base class.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "pluginlib/class_desc.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib {

class ClassLoaderBase {
 public:
  virtual ~ClassLoaderBase() = default;

  virtual std::vector<std::string> getPluginXmlPaths() = 0;
  virtual std::vector<std::string> getDeclaredClasses() = 0;
  virtual void refreshDeclaredClasses() = 0;
  virtual std::string getName(const std::string& lookup_name) = 0;
  virtual bool isClassAvailable(const std::string& lookup_name) = 0;
  virtual std::string getClassType(const std::string& lookup_name) = 0;
  virtual std::string getClassDescription(const std::string& lookup_name) = 0;
  virtual std::string getBaseClassType() const = 0;
  virtual std::string getClassPackage(const std::string& lookup_name) = 0;
  virtual std::string getPluginManifestPath(const std::string& lookup_name) = 0;
  virtual std::vector<std::string> getRegisteredLibraries() = 0;
  virtual std::string getClassLibraryPath(const std::string& lookup_name) = 0;
  virtual bool isClassLoaded(const std::string& lookup_name) = 0;
  virtual void loadLibraryForClass(const std::string& lookup_name) = 0;
  virtual int unloadLibraryForClass(const std::string& lookup_name) = 0;
};

namespace impl {

/// The classes of one base that the descriptions tell of, and the libraries of them that are in
/// use.
class DeclaredClasses {
 public:
  /// Throws ament_index_cpp::PackageNotFoundError for the base class's package.
  DeclaredClasses(std::string package, std::string base_class, std::string attribute,
                  std::vector<std::string> paths);

  void refresh();
  [[nodiscard]] std::vector<std::string> names() const;
  /// Throws the error for a class that no description has, of the kind that the caller throws.
  template <typename ErrorT>
  ClassDesc& at(const std::string& lookup_name) {
    const auto found = classes_.find(lookup_name);
    if (found == classes_.end()) {
      throw ErrorT(unknown_text(lookup_name));
    }
    return found->second;
  }
  [[nodiscard]] const ClassDesc* find(const std::string& lookup_name) const;
  [[nodiscard]] const std::string& base_class() const { return base_class_; }
  [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
  /// The paths of the libraries in use.
  [[nodiscard]] std::vector<std::string> libraries() const;
  /// Empty when the program was linked without it.
  [[nodiscard]] std::string library_path(const std::string& lookup_name) const;
  [[nodiscard]] bool is_loaded(const std::string& lookup_name) const;
  /// Throws LibraryLoadException.
  class_loader::ClassLoader& load(const std::string& lookup_name);
  /// How often it is still loaded. Throws LibraryUnloadException for a class that was not loaded.
  int unload(const std::string& lookup_name);

 private:
  [[nodiscard]] std::string unknown_text(const std::string& lookup_name) const;

  std::string package_;
  std::string base_class_;
  std::string attribute_;
  bool paths_are_given_;
  std::vector<std::string> paths_;
  std::map<std::string, ClassDesc> classes_;
  std::map<std::string, class_loader::ClassLoader> loaded_;  ///< by path
};

}  // namespace impl
}  // namespace pluginlib
