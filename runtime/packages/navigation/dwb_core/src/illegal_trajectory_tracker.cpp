// See illegal_trajectory_tracker.hpp.
#include "dwb_core/illegal_trajectory_tracker.hpp"

#include <cstdio>

namespace dwb_core {

void IllegalTrajectoryTracker::addIllegalTrajectory(const IllegalTrajectoryException& e) {
  ++counts_[{e.getCriticName(), e.what()}];
  ++illegal_count_;
}

void IllegalTrajectoryTracker::addLegalTrajectory() {
  ++legal_count_;
}

std::map<std::pair<std::string, std::string>, double> IllegalTrajectoryTracker::getPercentages()
    const {
  std::map<std::pair<std::string, std::string>, double> result;
  for (const auto& [reason, count] : counts_) {
    result[reason] = static_cast<double>(count) / (legal_count_ + illegal_count_);
  }
  return result;
}

std::string IllegalTrajectoryTracker::getMessage() const {
  char text[160];
  const unsigned int total = legal_count_ + illegal_count_;
  if (legal_count_ == 0) {
    std::snprintf(text, sizeof(text), "No valid trajectories out of %u! ", illegal_count_);
  } else {
    std::snprintf(text, sizeof(text), "%u valid trajectories found (%g%% of %u). ", legal_count_,
                  100.0 * legal_count_ / total, total);
  }
  return text;
}

}  // namespace dwb_core
