// The joints of a robot and their state: which there are, where they are, and how they move by
// themselves. Values in, values out.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sensor_msgs/msg/joint_state.hpp"

namespace joint_state_publisher {

/// A joint that has a state of its own.
struct FreeJoint {
  double min = 0;
  double max = 0;
  std::optional<double> position;
  std::optional<double> velocity;
  std::optional<double> effort;
  bool is_continuous = false;
  bool goes_forward = true;
};

/// A joint that follows another one.
struct DependentJoint {
  std::optional<std::string> parent;
  double factor = 1;
  double offset = 0;
};

struct JointOptions {
  bool use_mimic = true;
  bool use_smallest_limits = true;
  bool publish_positions = true;
  bool publish_velocities = false;
  bool publish_efforts = false;
  std::map<std::string, double> zeros;
  std::map<std::string, DependentJoint> dependent;
};

class Joints {
 public:
  explicit Joints(JointOptions options) : options_(std::move(options)) {}

  /// Replaces the joints by those of a description; `warn` is told of joints that are skipped.
  /// Throws std::runtime_error when it is not an XML or no robot; the joints stay then.
  void configure(const std::string& description,
                 const std::function<void(const std::string&)>& warn);
  /// Takes what is told of free joints.
  void take(const sensor_msgs::msg::JointState& state);
  /// One step of each free joint, back and forth between its limits.
  void move(double delta);
  /// Throws std::runtime_error for joints that follow each other, or one that is not there.
  sensor_msgs::msg::JointState state() const;

 private:
  struct Source {
    const FreeJoint* joint = nullptr;
    double factor = 1;
    double offset = 0;
  };
  Source source_of(const std::string& name) const;

  JointOptions options_;
  std::vector<std::string> names_;  ///< in the order of the description
  std::map<std::string, FreeJoint> free_;
  std::map<std::string, DependentJoint> dependent_;
};

}  // namespace joint_state_publisher
