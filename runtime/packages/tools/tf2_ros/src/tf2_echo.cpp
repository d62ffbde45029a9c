// usage: tf2_echo SOURCE_FRAME TARGET_FRAME [ECHO_RATE]
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/exceptions.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/transform_listener.hpp"

namespace {

constexpr int kNoNumber = 2;
constexpr int kMoreThanANumber = 3;
constexpr const char* kUsage =
    "Usage: tf2_echo source_frame target_frame [echo_rate]\n\n"
    "This will echo the transform from the coordinate frame of the source_frame\n"
    "to the coordinate frame of the target_frame. \n"
    "Note: This is the transform to get data from target_frame into the source_frame.\n"
    "Default echo rate is 1 if echo_rate is not given.\n";

/// In `rate`; else the exit code.
std::optional<int> read_rate(const std::string& word, double& rate) {
  std::size_t end = 0;
  std::optional<int> failure;
  try {
    rate = std::stof(word, &end);
    if (end != word.size()) failure = kMoreThanANumber;
  } catch (const std::logic_error&) {
    failure = kNoNumber;
  }
  if (failure) {
    std::fprintf(stderr, "Failed to convert rate argument '%s' to a floating-point number\n",
                 word.c_str());
  }
  return failure;
}

void print(const geometry_msgs::msg::TransformStamped& stamped) {
  const auto& stamp = stamped.header.stamp;
  const auto& move = stamped.transform.translation;
  const auto& turn = stamped.transform.rotation;
  const tf2::Matrix3x3 matrix(tf2::Quaternion(turn.x, turn.y, turn.z, turn.w));
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  matrix.getEulerYPR(yaw, pitch, roll);
  constexpr double kDegrees = 180 / M_PI;
  std::printf("At time %d.%u\n", static_cast<int>(stamp.sec), static_cast<unsigned>(stamp.nanosec));
  std::printf("- Translation: [%.3f, %.3f, %.3f]\n", move.x, move.y, move.z);
  std::printf("- Rotation: in Quaternion [%.3f, %.3f, %.3f, %.3f]\n", turn.x, turn.y, turn.z,
              turn.w);
  std::printf("- Rotation: in RPY (radian) [%.3f, %.3f, %.3f]\n", roll, pitch, yaw);
  std::printf("- Rotation: in RPY (degree) [%.3f, %.3f, %.3f]\n", roll * kDegrees, pitch * kDegrees,
              yaw * kDegrees);
  std::printf("- Matrix:\n");
  const double column[] = {move.x, move.y, move.z};
  for (int i = 0; i < 3; ++i) {
    const tf2::Vector3& row = matrix[i];
    std::printf(" %6.3f %6.3f %6.3f %6.3f\n", row.x(), row.y(), row.z(), column[i]);
  }
  std::printf(" %6.3f %6.3f %6.3f %6.3f\n", 0.0, 0.0, 0.0, 1.0);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (words.size() != 3 && words.size() != 4) {
    std::printf("%s", kUsage);
    return 1;
  }
  double rate_hz = 1;
  if (words.size() == 4) {
    if (const auto failure = read_rate(words[3], rate_hz)) return *failure;
  }
  rclcpp::Rate rate(rate_hz);
  const auto node = rclcpp::Node::make_shared("tf2_echo");
  const auto clock = node->get_clock();
  tf2_ros::Buffer buffer(clock);
  const tf2_ros::TransformListener listener(buffer);
  const std::string& source = words[1];
  const std::string& target = words[2];

  std::string why;
  while (rclcpp::ok() && !buffer.canTransform(source, target, tf2::TimePoint(), &why)) {
    RCLCPP_INFO_THROTTLE(node->get_logger(), *clock, 1000, "Waiting for transform %s ->  %s: %s",
                         source.c_str(), target.c_str(), why.c_str());
    rate.sleep();
  }
  while (rclcpp::ok()) {
    try {
      print(buffer.lookupTransform(source, target, tf2::TimePoint()));
    } catch (const tf2::TransformException& error) {
      std::printf("Failure at %.3f\nException thrown:%s\nThe current list of frames is:\n%s\n",
                  clock->now().seconds(), error.what(), buffer.allFramesAsString().c_str());
      std::fflush(stdout);
    }
    rate.sleep();
  }
  rclcpp::shutdown();
  return 0;
}
