// Counts down in a timer, one goal at a time; a service holds it for some steps.

// Compatibility, works: `rosidl_default_generators` brings what generated services and actions
// need, so that a package with an action need not name action_msgs

#include <memory>

#include "countdown_interfaces/action/countdown.hpp"
#include "countdown_interfaces/srv/hold.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using countdown_interfaces::action::Countdown;
using countdown_interfaces::srv::Hold;
using GoalHandle = rclcpp_action::ServerGoalHandle<Countdown>;
using namespace std::chrono_literals;

class Server : public rclcpp::Node {
 public:
  Server() : Node("countdown_server") {
    actions_ = rclcpp_action::create_server<Countdown>(
        this, "countdown",
        [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Countdown::Goal> goal) {
          return goal->start > 0 && goal_ == nullptr
                     ? rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE
                     : rclcpp_action::GoalResponse::REJECT;
        },
        [](std::shared_ptr<GoalHandle>) { return rclcpp_action::CancelResponse::ACCEPT; },
        [this](std::shared_ptr<GoalHandle> goal) {
          goal_ = std::move(goal);
          left_ = goal_->get_goal()->start;
        });
    hold_ = create_service<Hold>("hold", [this](const std::shared_ptr<Hold::Request> request,
                                                std::shared_ptr<Hold::Response> response) {
      held_steps_ = request->steps;
      response->held = true;
      RCLCPP_INFO(get_logger(), "held for %d", request->steps);
    });
    timer_ = create_wall_timer(20ms, [this] { step(); });
  }

 private:
  void step() {
    if (goal_ == nullptr || held_steps_-- > 0) {
      return;
    }
    auto feedback = std::make_shared<Countdown::Feedback>();
    feedback->left = --left_;
    goal_->publish_feedback(feedback);
    if (left_ > 0) {
      return;
    }
    auto result = std::make_shared<Countdown::Result>();
    result->steps = goal_->get_goal()->start;
    goal_->succeed(result);
    goal_.reset();
  }

  rclcpp_action::Server<Countdown>::SharedPtr actions_;
  rclcpp::Service<Hold>::SharedPtr hold_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::shared_ptr<GoalHandle> goal_;
  int left_ = 0;
  int held_steps_ = 0;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Server>());
  rclcpp::shutdown();
  return 0;
}
