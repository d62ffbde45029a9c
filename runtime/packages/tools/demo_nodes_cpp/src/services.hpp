// A service that adds two numbers, and a client of it.
#pragma once

#include <chrono>
#include <cinttypes>
#include <memory>
#include <rclcpp/rclcpp.hpp>

#include "example_interfaces/srv/add_two_ints.hpp"

namespace demo_nodes_cpp {

using AddTwoInts = example_interfaces::srv::AddTwoInts;

class ServerNode : public rclcpp::Node {
 public:
  explicit ServerNode(const rclcpp::NodeOptions& options) : Node("add_two_ints_server", options) {
    service_ = create_service<AddTwoInts>(
        "add_two_ints", [this](const std::shared_ptr<AddTwoInts::Request>& request,
                               const std::shared_ptr<AddTwoInts::Response>& response) {
          RCLCPP_INFO(get_logger(), "Incoming request\na: %" PRId64 " b: %" PRId64, request->a,
                      request->b);
          response->sum = request->a + request->b;
          was_asked_ = true;
        });
    if (!declare_parameter("one_shot", false)) return;
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] {
      if (was_asked_) rclcpp::shutdown();
    });
  }

 private:
  rclcpp::Service<AddTwoInts>::SharedPtr service_;
  rclcpp::TimerBase::SharedPtr timer_;
  bool was_asked_ = false;
};

/// False when the program was interrupted before there was a service.
inline bool wait_for(rclcpp::Client<AddTwoInts>& client, const rclcpp::Logger& logger) {
  while (!client.wait_for_service(std::chrono::seconds(1))) {
    if (!rclcpp::ok()) {
      RCLCPP_ERROR(logger, "Interrupted while waiting for the service. Exiting.");
      return false;
    }
    RCLCPP_INFO(logger, "service not available, waiting again...");
  }
  return true;
}

inline std::shared_ptr<AddTwoInts::Request> two_and_three() {
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 2;
  request->b = 3;
  return request;
}

class ClientNode : public rclcpp::Node {
 public:
  explicit ClientNode(const rclcpp::NodeOptions& options) : Node("add_two_ints_client", options) {
    client_ = create_client<AddTwoInts>("add_two_ints");
    if (!wait_for(*client_, get_logger())) return;
    client_->async_send_request(
        two_and_three(), [this](const rclcpp::Client<AddTwoInts>::SharedFuture& answer) {
          RCLCPP_INFO(get_logger(), "Result of add_two_ints: %" PRId64, answer.get()->sum);
          rclcpp::shutdown();
        });
  }

 private:
  rclcpp::Client<AddTwoInts>::SharedPtr client_;
};

}  // namespace demo_nodes_cpp
