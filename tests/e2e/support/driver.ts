// The beginning of a driver in C++ of a test: it asks servers from outside, and logs what they answer.

/** Its node, which `main` makes; `say` logs, and the others let the node work until something is so. Needs <functional>. */
export const driverStart = `inline rclcpp::Node::SharedPtr node;

template <typename... T>
void say(const char* format, T... values) { RCLCPP_INFO(node->get_logger(), format, values...); }

template <typename FutureT>
auto wait(FutureT future) {
  rclcpp::spin_until_future_complete(node, future);
  return future.get();
}

inline bool spin_until(const std::function<bool()>& is_done, std::chrono::nanoseconds most = std::chrono::seconds(60)) {
  const auto end = node->now() + rclcpp::Duration(most);
  while (rclcpp::ok() && !is_done() && node->now() < end) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(std::chrono::milliseconds(2));
  }
  return is_done();
}

inline void pass(std::chrono::nanoseconds time) { spin_until([] { return false; }, time); }`;
