// Takes the sensor through its life by its services, and watches that it measures only while it is
// active. Logs one line when everything went as it should; ends with an error where it did not.

// Compatibility, works: managed nodes of rclcpp_lifecycle: the states, transitions, numbers and
// labels of ROS 2, callbacks that fail, throw or err, the five services and `~/transition_event`,
// publishers that are mute while inactive

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/transition.hpp"
#include "lifecycle_msgs/msg/transition_event.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

using lifecycle_msgs::msg::Transition;
using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetAvailableStates;
using lifecycle_msgs::srv::GetAvailableTransitions;
using lifecycle_msgs::srv::GetState;

class Manager : public rclcpp::Node {
 public:
  Manager() : Node("manager") {
    events_ = create_subscription<lifecycle_msgs::msg::TransitionEvent>(
        "sensor/transition_event", 10, [this](const lifecycle_msgs::msg::TransitionEvent& event) {
          reached_.push_back(event.goal_state.label);
        });
    measurements_ = create_subscription<std_msgs::msg::Int32>(
        "measurement", 10, [this](const std_msgs::msg::Int32&) { ++measured_; });
  }

  bool change(uint8_t id, const std::string& label = "") {
    auto request = std::make_shared<ChangeState::Request>();
    request->transition.id = id;
    request->transition.label = label;
    return call<ChangeState>("change_state", request)->success;
  }
  std::string state() { return call<GetState>("get_state")->current_state.label; }
  size_t count_states() {
    return call<GetAvailableStates>("get_available_states")->available_states.size();
  }
  std::vector<std::string> transitions(const std::string& service) {
    std::vector<std::string> labels;
    const auto answer = call<GetAvailableTransitions>(service);
    for (const auto& one : answer->available_transitions) {
      labels.push_back(one.start_state.label + "." + one.transition.label);
    }
    return labels;
  }
  /// Spins until so many more measurements came.
  void measure(int count) {
    for (const int until = measured_ + count; measured_ < until;) {
      executor_.spin_node_some(shared_from_this());
    }
  }
  int measured() const { return measured_; }
  const std::vector<std::string>& reached() const { return reached_; }

 private:
  template <typename ServiceT>
  typename ServiceT::Response::SharedPtr call(const std::string& name,
                                              typename ServiceT::Request::SharedPtr request =
                                                  std::make_shared<typename ServiceT::Request>()) {
    auto client = create_client<ServiceT>("sensor/" + name);
    client->wait_for_service();
    auto answer = client->async_send_request(request);
    rclcpp::spin_until_future_complete(shared_from_this(), answer);
    return answer.get();
  }

  rclcpp::executors::SingleThreadedExecutor executor_;
  rclcpp::Subscription<lifecycle_msgs::msg::TransitionEvent>::SharedPtr events_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr measurements_;
  std::vector<std::string> reached_;
  int measured_ = 0;
};

void expect(bool holds, const std::string& what) {
  if (!holds) {
    throw std::runtime_error(what);
  }
}

void lead(Manager& manager) {
  using Labels = std::vector<std::string>;
  expect(manager.state() == "unconfigured", "starts unconfigured");
  expect(manager.count_states() == 11, "all states are listed");
  expect(manager.transitions("get_transition_graph").size() == 25, "all transitions are listed");
  expect(manager.transitions("get_available_transitions") ==
             Labels{"unconfigured.configure", "unconfigured.shutdown"},
         "transitions of an unconfigured node");
  expect(!manager.change(Transition::TRANSITION_ACTIVATE), "cannot be activated yet");
  expect(!manager.change(0, "fly"), "an unknown transition is refused");

  expect(manager.change(Transition::TRANSITION_CONFIGURE), "configure");
  expect(manager.state() == "inactive", "is inactive");
  expect(manager.measured() == 0, "does not measure while inactive");
  // The label goes before the number.
  expect(manager.change(Transition::TRANSITION_CLEANUP, "activate"), "activate by label");
  expect(manager.state() == "active", "is active");
  manager.measure(3);

  expect(manager.change(Transition::TRANSITION_DEACTIVATE), "deactivate");
  expect(manager.change(Transition::TRANSITION_CLEANUP), "cleanup");
  expect(manager.change(0, "configure"), "configure again");
  expect(manager.change(0, "activate"), "activate again");
  manager.measure(3);
  expect(manager.change(0, "shutdown"), "shutdown");
  expect(manager.state() == "finalized", "is finalized");
  expect(manager.transitions("get_available_transitions").empty(), "nothing is left to do");
  expect(
      manager.reached() == Labels{"configuring", "inactive", "activating", "active", "deactivating",
                                  "inactive", "cleaningup", "unconfigured", "configuring",
                                  "inactive", "activating", "active", "shuttingdown", "finalized"},
      "every step was told");
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto manager = std::make_shared<Manager>();
  try {
    lead(*manager);
  } catch (const std::runtime_error& error) {
    RCLCPP_ERROR(manager->get_logger(), "does not hold: %s", error.what());
    return EXIT_FAILURE;
  }
  RCLCPP_INFO(manager->get_logger(), "led the sensor through its whole life");
  rclcpp::shutdown();
  return EXIT_SUCCESS;
}
