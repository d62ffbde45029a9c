// See class_loader_base.hpp.
#include "pluginlib/class_loader_base.hpp"

#include <utility>

#include "ament_index_cpp/get_package_prefix.hpp"
#include "descriptions.hpp"
#include "rcutils/logging_macros.h"

namespace pluginlib::impl {
namespace {

/// `polygons` of a description is lib/libpolygons.so, and so is `lib/libpolygons`.
std::string path_of(const ClassDesc& declared) {
  std::string name = declared.library_name_.substr(declared.library_name_.rfind('/') + 1);
  if (name.rfind("lib", 0) != 0) {
    name.insert(0, "lib");
  }
  return ament_index_cpp::get_package_prefix(declared.package_) + "/lib/" + name + ".so";
}

bool is_linked(const std::string& path) {
  try {
    class_loader::impl::require_library(path);
    return true;
  } catch (const class_loader::LibraryLoadException&) {
    return false;
  }
}

}  // namespace

DeclaredClasses::DeclaredClasses(std::string package, std::string base_class, std::string attribute,
                                 std::vector<std::string> paths)
    : package_(std::move(package)),
      base_class_(std::move(base_class)),
      attribute_(std::move(attribute)),
      paths_are_given_(!paths.empty()),
      paths_(std::move(paths)) {
  refresh();
  // A site has the index entries of packages with files; a package of headers that plugins name as
  // their base exists all the same.
  if (paths_.empty()) ament_index_cpp::get_package_prefix(package_);
}

/// Classes of libraries in use stay as they are.
void DeclaredClasses::refresh() {
  if (!paths_are_given_) {
    paths_ = description_paths(package_, attribute_);
  }
  std::map<std::string, ClassDesc> found;
  for (const auto& [name, declared] : classes_) {
    if (is_loaded(name)) {
      found.emplace(name, declared);
    }
  }
  for (const std::string& path : paths_) {
    try {
      for (ClassDesc& declared : read_description(path)) {
        if (declared.base_class_ == base_class_) {
          std::string name = declared.lookup_name_;
          found.emplace(std::move(name), std::move(declared));
        }
      }
    } catch (const InvalidXMLException& error) {
      RCUTILS_LOG_ERROR_NAMED("pluginlib.ClassLoader", "Skipped loading plugin with error: %s.",
                              error.what());
    }
  }
  classes_ = std::move(found);
}

std::vector<std::string> DeclaredClasses::names() const {
  std::vector<std::string> result;
  for (const auto& [name, declared] : classes_) {
    result.push_back(name);
  }
  return result;
}

const ClassDesc* DeclaredClasses::find(const std::string& lookup_name) const {
  const auto found = classes_.find(lookup_name);
  return found == classes_.end() ? nullptr : &found->second;
}

std::vector<std::string> DeclaredClasses::libraries() const {
  std::vector<std::string> result;
  for (const auto& [path, loader] : loaded_) {
    result.push_back(path);
  }
  return result;
}

std::string DeclaredClasses::library_path(const std::string& lookup_name) const {
  const ClassDesc* const declared = find(lookup_name);
  if (declared == nullptr) {
    return {};
  }
  const std::string path = path_of(*declared);
  return is_linked(path) ? path : std::string();
}

bool DeclaredClasses::is_loaded(const std::string& lookup_name) const {
  const ClassDesc* const declared = find(lookup_name);
  return declared != nullptr && loaded_.count(path_of(*declared)) > 0;
}

class_loader::ClassLoader& DeclaredClasses::load(const std::string& lookup_name) {
  ClassDesc& declared = at<LibraryLoadException>(lookup_name);
  const std::string path = path_of(declared);
  if (!is_linked(path)) {
    throw LibraryLoadException("Could not find library corresponding to plugin " + lookup_name +
                               ". Make sure that the library '" + declared.library_name_ +
                               "' actually exists.");
  }
  declared.resolved_library_path_ = path;
  return loaded_.try_emplace(path, path).first->second;
}

int DeclaredClasses::unload(const std::string& lookup_name) {
  const ClassDesc& declared = at<LibraryUnloadException>(lookup_name);
  if (declared.resolved_library_path_ == ClassDesc::kUnresolved) {
    throw LibraryUnloadException(unknown_text(lookup_name));
  }
  loaded_.erase(declared.resolved_library_path_);
  return 0;
}

std::string DeclaredClasses::unknown_text(const std::string& lookup_name) const {
  std::string text = "According to the loaded plugin descriptions the class " + lookup_name +
                     " with base class type " + base_class_ +
                     " does not exist. Declared types are ";
  for (const std::string& name : names()) {
    text += " " + name;
  }
  return text;
}

}  // namespace pluginlib::impl
