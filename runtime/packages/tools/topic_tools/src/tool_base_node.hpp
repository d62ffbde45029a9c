// A node that passes messages of any type from one topic to another one.
#pragma once

#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <string>

namespace topic_tools {

class ToolBaseNode : public rclcpp::Node {
 public:
  ToolBaseNode(const std::string& name, const rclcpp::NodeOptions& options);

 protected:
  /// Begins to look for publishers of the input. The last thing that a constructor does.
  void start();
  /// Connects with the input as its publishers are now: their type, reliability and durability.
  void look();
  /// Ends both sides.
  void disconnect();
  virtual void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) = 0;
  /// Nothing is sent while no publisher of the input is known.
  void send(const rclcpp::SerializedMessage& message);

  /// Empty: none.
  std::string input_topic_;
  /// Empty: none.
  std::string output_topic_;
  /// Whether it subscribes only while somebody subscribes to the output.
  bool lazy_ = false;

 private:
  struct Source {
    std::string type;
    rclcpp::QoS qos;
  };
  std::optional<Source> find_source();
  std::string full_name(const std::string& topic) const;

  std::optional<Source> source_;
  rclcpp::GenericPublisher::SharedPtr publisher_;
  rclcpp::GenericSubscription::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace topic_tools
