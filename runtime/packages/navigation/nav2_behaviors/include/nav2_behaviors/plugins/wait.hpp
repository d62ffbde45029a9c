// Waits for a time.
#pragma once

#include <memory>

#include "nav2_behaviors/timed_behavior.hpp"
#include "nav2_msgs/action/wait.hpp"

namespace nav2_behaviors {

using WaitAction = nav2_msgs::action::Wait;

class Wait : public TimedBehavior<WaitAction> {
  using CostmapInfoType = nav2_core::CostmapInfoType;

 public:
  using WaitActionGoal = WaitAction::Goal;

  Wait();
  ~Wait();

  ResultStatus onRun(const std::shared_ptr<const WaitActionGoal> command) override;
  ResultStatus onCycleUpdate() override;
  CostmapInfoType getResourceInfo() override { return CostmapInfoType::LOCAL; }

 protected:
  rclcpp::Time wait_end_;
  WaitAction::Feedback::SharedPtr feedback_;
};

}  // namespace nav2_behaviors
