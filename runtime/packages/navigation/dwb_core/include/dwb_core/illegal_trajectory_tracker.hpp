// Counts the trajectories that critics forbid, by critic and reason.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "dwb_core/exceptions.hpp"
#include "nav2_core/controller_exceptions.hpp"

namespace dwb_core {

class IllegalTrajectoryTracker {
 public:
  void addIllegalTrajectory(const IllegalTrajectoryException& e);
  void addLegalTrajectory();
  /// The share of all trajectories, from 0 to 1, by critic and reason.
  std::map<std::pair<std::string, std::string>, double> getPercentages() const;
  std::string getMessage() const;

 protected:
  std::map<std::pair<std::string, std::string>, unsigned int> counts_;
  unsigned int legal_count_ = 0;
  unsigned int illegal_count_ = 0;
};

class NoLegalTrajectoriesException : public nav2_core::ControllerException {
 public:
  explicit NoLegalTrajectoriesException(const IllegalTrajectoryTracker& tracker)
      : ControllerException(tracker.getMessage()), tracker_(tracker) {}
  IllegalTrajectoryTracker tracker_;
};

}  // namespace dwb_core
