// A server from its start to its end: the part of main() that both servers share.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugins/table.hpp"
#include "ros/host.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

struct ServerSettings {
  std::string node;  ///< its name
  Flavour flavour = Flavour::kClassic;
  std::uint64_t seed = 1;  ///< of the noise of sensors
  /// Nothing when the world cannot be used; the reason has been logged.
  std::function<std::optional<World>(const rclcpp::Logger& logger)> load;
  std::vector<PluginRow> plugins;  ///< of other packages, for models
  /// Offers the topics and services of the world for as long as the result lives.
  std::function<std::shared_ptr<void>(Host& host, Simulation& simulation)> offer;
};

/// Runs until the program is asked to stop. Returns the exit code: 255 when the world cannot be
/// simulated.
int run_server(const ServerSettings& settings);

/// The programs, with plugins of other packages. They return the exit code.
int run_gzserver(int argc, char** argv, std::vector<PluginRow> plugins = {});
int run_gz_sim(int argc, char** argv, std::vector<PluginRow> plugins = {});

}  // namespace ros2wasm_sim
