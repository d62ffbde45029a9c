// The values of joints by name and interface, and which joints are in joint_states. Knows nothing
// of ROS.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace joint_state_broadcaster {

/// A state interface, e.g. joint `wheel`, interface `position`.
struct JointInterface {
  std::string joint;
  std::string interface;
};

struct JointDataOptions {
  /// Interface of the hardware -> position, velocity or effort.
  std::map<std::string, std::string> standard_names;
  /// Published with 0 when they have no interface.
  std::vector<std::string> extra_joints;
  bool filters_by_model = false;
  /// The movable joints of the model, for the filter; joint_states has them in this order.
  std::vector<std::string> model_joints;
};

class JointData {
 public:
  JointData() = default;
  JointData(const std::vector<JointInterface>& interfaces, const JointDataOptions& options);
  // The slots point into it.
  JointData(JointData&&) = default;
  JointData& operator=(JointData&&) = default;
  JointData(const JointData&) = delete;
  JointData& operator=(const JointData&) = delete;

  /// The joints of joint_states.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Stores the value of the interface at that place of those given.
  void set(size_t interface, double value) { *slots_[interface] = value; }
  /// NaN when the joint has no such interface.
  [[nodiscard]] double value(const std::string& joint, const std::string& interface) const;
  /// All of them: joint -> interface -> value.
  [[nodiscard]] const std::map<std::string, std::map<std::string, double>>& all() const {
    return values_;
  }

 private:
  void choose_names(const std::vector<JointInterface>& interfaces, const JointDataOptions& options);
  void add_extra_joints(const std::vector<std::string>& extra_joints);

  std::map<std::string, std::map<std::string, double>> values_;
  std::vector<double*> slots_;  ///< of each interface that was given
  std::vector<std::string> names_;
};

}  // namespace joint_state_broadcaster
