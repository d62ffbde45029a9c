// Where a sensor is: fixed to a link, which moves.
#pragma once

#include <string>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

class Mount {
 public:
  Mount(const Sensor& sensor, Physics& physics, const std::string& model, const std::string& link)
      : physics_(physics), link_(physics.link(model, link)), pose_(sensor.pose) {}

  /// In the world.
  Pose pose() const { return physics_.pose(link_) * pose_; }
  /// m/s, along the axes of the world.
  Vector3 velocity() const {
    const Motion motion = physics_.velocity(link_);
    return motion.linear +
           cross(motion.angular, rotate(physics_.pose(link_).orientation, pose_.position));
  }

 private:
  Physics& physics_;
  LinkHandle link_;
  Pose pose_;  ///< in the link
};

}  // namespace ros2wasm_sim
