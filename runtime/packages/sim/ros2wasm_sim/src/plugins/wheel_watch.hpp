// Says what is probably wrong with the wheels of a drive: as they are described, and once the robot
// has come to rest, whether they touch something.
#pragma once

#include <string>
#include <vector>

#include "checks/model_checks.hpp"
#include "plugins/plugin.hpp"

namespace ros2wasm_sim {

class WheelWatch {
 public:
  WheelWatch(const PluginContext& context, const DrivenWheels& wheels);

  /// To be called after each step; it looks at the world once, 2 s after the first call.
  void look(const Now& now) {
    if (now.time_ns >= next_ns_) look_at_world(now.time_ns);
  }

 private:
  struct Wheel {
    LinkHandle link;
    Collision shape;
  };
  struct Side {
    const char* name;
    std::vector<Wheel> wheels;
  };

  void look_at_world(std::int64_t time_ns);
  /// Metres between a wheel and what is below it; nothing for a wheel that moves up or down, or
  /// whose shape is a mesh.
  std::optional<double> gap_below(const Wheel& wheel) const;

  Physics& physics_;
  rclcpp::Logger logger_;
  std::string model_;
  std::vector<Side> sides_;
  std::int64_t next_ns_ = 0;
  bool has_begun_ = false;
};

}  // namespace ros2wasm_sim
