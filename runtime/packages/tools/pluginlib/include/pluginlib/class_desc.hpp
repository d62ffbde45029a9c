// One class as a description of plugins tells it.
#pragma once

#include <string>
#include <utility>

namespace pluginlib {

class ClassDesc {
 public:
  /// In place of a path, until the class's library was loaded for it.
  static constexpr const char* kUnresolved = "UNRESOLVED";

  ClassDesc(std::string lookup_name, std::string derived_class, std::string base_class,
            std::string package, std::string description, std::string library_name,
            std::string plugin_manifest_path)
      : lookup_name_(std::move(lookup_name)),
        derived_class_(std::move(derived_class)),
        base_class_(std::move(base_class)),
        package_(std::move(package)),
        description_(std::move(description)),
        library_name_(std::move(library_name)),
        plugin_manifest_path_(std::move(plugin_manifest_path)) {}

  std::string lookup_name_;
  std::string derived_class_;
  std::string base_class_;
  std::string package_;
  std::string description_;
  std::string library_name_;  ///< as the description names it
  std::string resolved_library_path_ = kUnresolved;
  std::string plugin_manifest_path_;
};

}  // namespace pluginlib
