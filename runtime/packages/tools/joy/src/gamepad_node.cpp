// See gamepad_node.hpp.
#include "gamepad_node.hpp"

#include <algorithm>

namespace joy {
namespace {

constexpr size_t kDepth = 10;
/// How long a gamepad may take to appear before the log says that there is none.
constexpr std::chrono::seconds kPatience{2};

}  // namespace

GamepadNode::GamepadNode(const std::string& name, GamepadLayout layout,
                         const rclcpp::NodeOptions& options)
    : rclcpp::Node(name, options) {
  read_parameters();
  state_.emplace(settings_);
  publisher_ = create_publisher<Joy>("joy", kDepth);
  rumble_ = create_publisher<Feedback>(kRumbleTopic, kDepth);
  feedback_ = create_subscription<Feedback>("joy/set_feedback", rclcpp::QoS(kDepth),
                                            [this](const Feedback& feedback) { rumble(feedback); });
  const std::chrono::milliseconds interval{settings_.autorepeat_interval_ms()};
  if (interval.count() > 0) repeat_ = create_wall_timer(interval, [this] { publish(); });
  const std::chrono::milliseconds wait{std::max<int64_t>(settings_.coalesce_interval_ms, 1)};
  coalesce_ = create_wall_timer(wait, [this] { publish(); });
  coalesce_->cancel();
  patience_ = create_wall_timer(kPatience, [this] { say_none(); });
  subscribe(layout);
}

void GamepadNode::read_parameters() {
  device_id_ = static_cast<int>(declare_parameter("device_id", 0));
  device_name_ = declare_parameter("device_name", std::string());
  settings_.deadzone = declare_parameter("deadzone", settings_.deadzone);
  settings_.autorepeat_rate = declare_parameter("autorepeat_rate", settings_.autorepeat_rate);
  settings_.has_sticky_buttons = declare_parameter("sticky_buttons", false);
  settings_.coalesce_interval_ms = declare_parameter("coalesce_interval_ms", 1);
  settings_.check();
}

void GamepadNode::subscribe(GamepadLayout layout) {
  const auto qos = rclcpp::QoS(kDepth).transient_local();
  for (int number = 0; number < kMostDevices; ++number) {
    gamepads_.push_back(create_subscription<Joy>(
        device_topic(layout, number), qos, [this, number](const Joy& raw) { take(number, raw); }));
  }
}

void GamepadNode::say_none() {
  patience_->cancel();
  if (!devices_.empty()) return;
  RCLCPP_INFO(get_logger(),
              "No gamepad yet. A page sees one after one of its buttons is pressed; a headless "
              "run has none.");
}

void GamepadNode::take(int number, const Joy& raw) {
  if (raw.axes.empty() && raw.buttons.empty()) {
    remove(number);
    return;
  }
  if (devices_.count(number) == 0) {
    const auto device = parse_device(raw.header.frame_id);
    if (!device) return;
    add(number, *device, raw);
  }
  if (open_ == number) follow(raw);
}

void GamepadNode::add(int number, const GamepadDevice& device, const Joy& raw) {
  devices_.emplace(number, device);
  say_connected(devices_, device_name_);
  if (!device_name_.empty()) {
    const auto named = std::find_if(devices_.begin(), devices_.end(), [this](const auto& one) {
      return one.second.name == device_name_;
    });
    if (named == devices_.end()) {
      say_no_device_named(device_name_);
      return;
    }
    device_id_ = named->first;
  }
  if (number != device_id_) return;
  state_->open(raw.axes, raw.buttons.size());
  open_ = number;
  say_opened(device, settings_.deadzone);
}

void GamepadNode::remove(int number) {
  const auto found = devices_.find(number);
  if (found == devices_.end()) return;
  const GamepadDevice device = found->second;
  devices_.erase(found);
  if (open_ != number) return;
  // The axes come to rest before the gamepad goes.
  if (!coalesce_->is_canceled()) publish();
  open_.reset();
  state_->close();
  say_removed(device);
}

void GamepadNode::follow(const Joy& raw) {
  const JoyChange change = state_->update(raw.axes, raw.buttons);
  if (change == JoyChange::kNone) return;
  if (change == JoyChange::kButtons || settings_.coalesce_interval_ms == 0) {
    publish();
  } else if (coalesce_->is_canceled()) {
    coalesce_->reset();
  }
}

void GamepadNode::publish() {
  coalesce_->cancel();
  if (!open_) return;
  Joy message;
  message.header.frame_id = "joy";
  message.header.stamp = now();
  message.axes = state_->axes();
  message.buttons = state_->buttons();
  publisher_->publish(message);
  if (repeat_) repeat_->reset();
}

void GamepadNode::rumble(const Feedback& feedback) {
  const auto device = open_ ? devices_.find(*open_) : devices_.end();
  if (device == devices_.end() || !device->second.can_rumble) return;
  // A gamepad has one motor for upstream: others, and strengths that it does not have, are ignored.
  if (feedback.type != Feedback::TYPE_RUMBLE || feedback.id != 0) return;
  if (!(feedback.intensity >= 0.0F && feedback.intensity <= 1.0F)) return;
  Feedback message = feedback;
  message.id = static_cast<uint8_t>(*open_);
  rumble_->publish(message);
}

}  // namespace joy
