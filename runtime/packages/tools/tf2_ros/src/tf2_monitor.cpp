// usage: tf2_monitor [FRAME_A FRAME_B]
// Every ten seconds: how old transforms are when they come, and how often they come.
#include <algorithm>
#include <deque>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/transform_listener.hpp"

namespace {

using std::chrono_literals::operator""ms;
using tf2_msgs::msg::TFMessage;

constexpr std::size_t kKept = 1000;                             // numbers of each kind
constexpr int kLooksOfAReport = 20;                             // one each half second
constexpr const char* kAuthority = "<no authority available>";  // as ROS 2 knows none

/// The last numbers of a kind.
class Samples {
 public:
  void add(double value) {
    values_.push_back(value);
    if (values_.size() > kKept) values_.pop_front();
  }
  double average() const {
    double sum = 0;
    for (const double value : values_) sum += value;
    return sum / static_cast<double>(values_.size());
  }
  double max() const { return std::max(0.0, *std::max_element(values_.begin(), values_.end())); }
  /// For values that are times in seconds: how many of them come in a second.
  double rate() const {
    return static_cast<double>(values_.size()) /
           std::max(0.00000001, values_.back() - values_.front());
  }
  bool empty() const { return values_.empty(); }

 private:
  std::deque<double> values_;
};

class Monitor {
 public:
  /// All frames, or the chain between two.
  Monitor(const rclcpp::Node::SharedPtr& node, const std::vector<std::string>& ends)
      : node_(node), ends_(ends), buffer_(node->get_clock()), listener_(buffer_) {
    if (has_chain()) find_chain();
    const auto heard = [this](TFMessage::ConstSharedPtr message) { on_message(*message); };
    moving_ = node->create_subscription<TFMessage>("tf", rclcpp::QoS(100), heard);
    fixed_ = node->create_subscription<TFMessage>("tf_static", rclcpp::QoS(100).transient_local(),
                                                  heard);
    std::cout << "Gathering data on " << (has_chain() ? ends_[0] + " -> " + ends_[1] : "all frames")
              << " for 10 seconds...\n"
              << std::flush;
    timer_ = node->create_wall_timer(500ms, [this] { look(); });
  }

 private:
  bool has_chain() const { return !ends_.empty(); }
  double now() const { return node_->get_clock()->now().seconds(); }

  void find_chain() {
    std::cout << "Waiting for transform chain to become available between " << ends_[0] << " and "
              << ends_[1] << " " << std::flush;
    while (rclcpp::ok() && !buffer_.canTransform(ends_[0], ends_[1], tf2::TimePointZero,
                                                 tf2::durationFromSec(1.0))) {
      std::cout << "." << std::flush;
    }
    std::cout << std::endl;
    if (rclcpp::ok()) {
      buffer_._chainAsVector(ends_[1], tf2::TimePointZero, ends_[0], tf2::TimePointZero, ends_[1],
                             chain_);
    }
  }

  void on_message(const TFMessage& message) {
    double sum = 0;
    for (const auto& transform : message.transforms) {
      const double delay = now() - tf2_ros::timeToSec(transform.header.stamp);
      delays_[transform.child_frame_id].add(delay);
      sum += delay;
    }
    message_delays_.add(sum /
                        static_cast<double>(std::max<std::size_t>(1, message.transforms.size())));
    moments_.add(now());
  }

  void look() {
    if (has_chain()) {
      const auto found = buffer_.lookupTransform(ends_[0], ends_[1], tf2::TimePointZero);
      const double delay = now() - tf2_ros::timeToSec(found.header.stamp);
      constexpr double kNewPart = 0.01;
      average_delay_ = kNewPart * delay + (1 - kNewPart) * average_delay_;
      max_delay_ = std::max(max_delay_, delay);
    }
    if (++looks_ > kLooksOfAReport) {
      looks_ = 0;
      report();
    }
  }

  void report() const {
    std::cout << "\n\n\nRESULTS: for ";
    if (has_chain()) {
      std::cout << ends_[0] << " to " << ends_[1] << "\nChain is: ";
      for (std::size_t i = 0; i < chain_.size(); ++i) {
        std::cout << (i == 0 ? "" : " -> ") << chain_[i];
      }
      std::cout << "\nNet delay     avg = " << average_delay_ << ": max = " << max_delay_ << "\n";
    } else {
      std::cout << "all Frames\n";
    }
    std::cout << "\nFrames:\n";
    for (const auto& [frame, delays] : delays_) {
      if (has_chain() && std::find(chain_.begin(), chain_.end(), frame) == chain_.end()) continue;
      std::cout << "Frame: " << frame << ", published by " << kAuthority
                << ", Average Delay: " << delays.average() << ", Max Delay: " << delays.max()
                << "\n";
    }
    std::cout << "\nAll Broadcasters:\n";
    if (!moments_.empty()) {
      std::cout << "Node: " << kAuthority << " " << moments_.rate()
                << " Hz, Average Delay: " << message_delays_.average()
                << " Max Delay: " << message_delays_.max() << "\n";
    }
    std::cout << std::flush;
  }

  const rclcpp::Node::SharedPtr node_;
  const std::vector<std::string> ends_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  std::vector<std::string> chain_;
  std::map<std::string, Samples> delays_;
  Samples message_delays_;
  Samples moments_;
  double average_delay_ = 0;
  double max_delay_ = 0;
  int looks_ = 0;
  rclcpp::Subscription<TFMessage>::SharedPtr moving_;
  rclcpp::Subscription<TFMessage>::SharedPtr fixed_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char** argv) {
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (words.size() != 1 && words.size() != 3) {
    std::cout << "TF_Monitor: usage: tf2_monitor framea frameb" << std::flush;
    return -1;
  }
  const auto node = rclcpp::Node::make_shared("tf2_monitor_main");
  try {
    const Monitor monitor(node, {words.begin() + 1, words.end()});
    rclcpp::spin(node);
  } catch (const tf2::TransformException& error) {
    std::cout << "Transform Exception " << error.what() << std::endl;
    return 1;
  }
  rclcpp::shutdown();
  return 0;
}
