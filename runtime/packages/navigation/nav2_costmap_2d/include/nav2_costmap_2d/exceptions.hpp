// Errors of collision checks.
#pragma once

#include <stdexcept>
#include <string>

namespace nav2_costmap_2d {

class CollisionCheckerException : public std::runtime_error {
 public:
  explicit CollisionCheckerException(const std::string description)
      : std::runtime_error(description) {}
};

/// A pose that must not be reached, by the name of the critic that refused it.
class IllegalPoseException : public CollisionCheckerException {
 public:
  IllegalPoseException(const std::string name, const std::string description)
      : CollisionCheckerException(description), name_(name) {}
  std::string getCriticName() const { return name_; }

 protected:
  std::string name_;
};

}  // namespace nav2_costmap_2d
