// Drives straight backwards by a distance, whatever the signs of the goal are.
#pragma once

#include <memory>

#include "nav2_behaviors/plugins/drive_on_heading.hpp"
#include "nav2_msgs/action/back_up.hpp"

using BackUpAction = nav2_msgs::action::BackUp;

namespace nav2_behaviors {

class BackUp : public DriveOnHeading<nav2_msgs::action::BackUp> {
 public:
  using BackUpActionGoal = BackUpAction::Goal;
  using BackUpActionResult = BackUpAction::Result;

  ResultStatus onRun(const std::shared_ptr<const BackUpActionGoal> command) override;
};

}  // namespace nav2_behaviors
