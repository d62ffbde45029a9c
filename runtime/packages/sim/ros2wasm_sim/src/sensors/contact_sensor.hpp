// A contact sensor: some collisions of its link, and what touches them.
#pragma once

#include <string>
#include <vector>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

class ContactSensor {
 public:
  /// Reads the names in <contact>, which are those of collisions of `link`.
  ContactSensor(const Sensor& sensor, Physics& physics, const std::string& model, const Link& link);

  /// One for each name that does not exist, with the one that may be meant.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// The contacts of the last step, with the collision of the sensor as the first one. A contact
  /// between two collisions of the sensor is there from both sides, as in Gazebo.
  std::vector<Contact> touching() const;

 private:
  bool is_own(std::string_view collision) const;

  Physics& physics_;
  std::vector<std::string> collisions_;  ///< `model::link::collision`
  std::vector<std::string> warnings_;
};

/// The same contact as the second collision sees it.
Contact from_other_side(const Contact& contact);

}  // namespace ros2wasm_sim
