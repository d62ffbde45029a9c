// The definitions of message types, as bags have them.
#pragma once

#include <exception>
#include <string>
#include <utility>

#include "rosbag2_storage/message_definition.hpp"

namespace rosbag2_cpp {

class DefinitionNotFoundError : public std::exception {
 public:
  explicit DefinitionNotFoundError(std::string name) : name_(std::move(name)) {}
  const char* what() const noexcept override { return name_.c_str(); }

 private:
  std::string name_;
};

/// A program has the definitions of the types that it uses.
class LocalMessageDefinitionSource final {
 public:
  LocalMessageDefinitionSource() = default;
  LocalMessageDefinitionSource(const LocalMessageDefinitionSource&) = delete;
  LocalMessageDefinitionSource& operator=(const LocalMessageDefinitionSource&) = delete;

  /// With those of all types inside it. Throws DefinitionNotFoundError.
  rosbag2_storage::MessageDefinition get_full_text(const std::string& root_type);
};

}  // namespace rosbag2_cpp
