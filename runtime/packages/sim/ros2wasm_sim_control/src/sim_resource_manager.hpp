// Makes the hardware of a description that asks for Gazebo's.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "hardware_interface/resource_manager.hpp"
#include "sim_hardware.hpp"

namespace ros2wasm_sim {

class SimResourceManager final : public hardware_interface::ResourceManager {
 public:
  SimResourceManager(const hardware_interface::ResourceManagerParams& params,
                     Simulation& simulation, SimHardwareSettings settings)
      : ResourceManager(params, false), simulation_(simulation), settings_(std::move(settings)) {}

  /// The simulated hardware; other hardware of the description is reported and left out.
  bool load_and_initialize_components(
      const hardware_interface::ResourceManagerParams& params) override;
  using ResourceManager::load_and_initialize_components;
  /// In Hz; it is known when the manager has read its parameters.
  void set_update_rate(unsigned int rate) { settings_.update_rate = rate; }

 private:
  Simulation& simulation_;
  SimHardwareSettings settings_;
};

}  // namespace ros2wasm_sim
