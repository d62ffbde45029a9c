// Which plugin and which sensor is made by what: a row each in table.cpp.
#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/simulation.hpp"
#include "plugins/plugin.hpp"
#include "ros/host.hpp"

namespace ros2wasm_sim {

/// Which of the two simulators a world is in: their plugins and sensors differ.
enum class Flavour { kClassic, kSim };

struct PluginRow {
  Flavour flavour;
  std::string_view
      name;  ///< of the library without `lib` and `.so`, or of the class without its namespaces
  MakePlugin make;
  bool is_of_sensor = false;  ///< it needs a <sensor> of a link around it
};

class PluginTable final : public SystemMaker {
 public:
  /// `files` are what cameras draw; `more` are plugins of models from other packages.
  PluginTable(Host& host, Flavour flavour, SceneFiles files, std::vector<PluginRow> more = {})
      : host_(host), flavour_(flavour), scene_(std::move(files)), more_(std::move(more)) {}

  std::vector<std::unique_ptr<System>> systems_of(const Model& model,
                                                  Simulation& simulation) override;
  std::vector<std::unique_ptr<System>> systems_of(const World& world,
                                                  Simulation& simulation) override;

 private:
  Host& host_;
  Flavour flavour_;
  SharedScene scene_;
  std::vector<PluginRow> more_;
};

}  // namespace ros2wasm_sim
