// Which plugin and which sensor is made by what: a row each in table.cpp.
#pragma once

#include <memory>
#include <vector>

#include "core/simulation.hpp"
#include "plugins/plugin.hpp"
#include "ros/host.hpp"

namespace ros2wasm_sim {

/// Which of the two simulators a world is in: their plugins and sensors differ.
enum class Flavour { kClassic, kSim };

class PluginTable final : public SystemMaker {
 public:
  /// `files` are what cameras draw.
  PluginTable(Host& host, Flavour flavour, SceneFiles files)
      : host_(host), flavour_(flavour), scene_(std::move(files)) {}

  std::vector<std::unique_ptr<System>> systems_of(const Model& model,
                                                  Simulation& simulation) override;
  std::vector<std::unique_ptr<System>> systems_of(const World& world,
                                                  Simulation& simulation) override;

 private:
  Host& host_;
  Flavour flavour_;
  SharedScene scene_;
};

}  // namespace ros2wasm_sim
