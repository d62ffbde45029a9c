// The error of a critic that forbids a trajectory.
#pragma once

#include <memory>
#include <string>

#include "nav2_core/controller_exceptions.hpp"

namespace dwb_core {

class IllegalTrajectoryException : public nav2_core::ControllerException {
 public:
  IllegalTrajectoryException(const std::string& critic_name, const std::string& description)
      : nav2_core::ControllerException(description), critic_name_(critic_name) {}
  std::string getCriticName() const { return critic_name_; }

 protected:
  std::string critic_name_;
};

}  // namespace dwb_core
