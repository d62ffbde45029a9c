// A sensor of Gazebo Sim that publishes one message with a header at its rate.
#pragma once

#include <string>

#include "plugins/gz_topics.hpp"
#include "plugins/sensor_names.hpp"

namespace ros2wasm_sim {

template <typename Message>
class GzSensor : public System {
 public:
  /// `what`: the end of the topic's default name, such as `/imu`.
  GzSensor(const PluginContext& context, const std::string& what)
      : rate_(whole_milliseconds(context.sensor->update_rate)),
        frame_(sensor_frame(context)),
        publisher_(publish_gz<Message>(context.host, sensor_topic(context, what))) {}

  void after_step(const Now& now) final {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    Message message = measure();
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    publisher_->publish(message);
  }
  void on_reset() final { rate_.reset(); }

 protected:
  /// The header is set afterwards.
  virtual Message measure() = 0;

 private:
  Rate rate_;
  std::string frame_;
  typename rclcpp::Publisher<Message>::SharedPtr publisher_;
};

}  // namespace ros2wasm_sim
