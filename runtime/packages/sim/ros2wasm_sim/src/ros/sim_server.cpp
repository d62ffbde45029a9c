// See sim_server.hpp.
#include "ros/sim_server.hpp"

#include "plugins/gz_topics.hpp"

namespace ros2wasm_sim {

SimServer::SimServer(Host& host, Simulation& simulation, const SimOptions& options)
    : host_(host),
      simulation_(simulation),
      runner_(host.node(), simulation, [this] { publish_clock(); }),
      services_(host, simulation, runner_, [] {}),
      scene_(host, simulation, runner_) {
  report_warnings(host_.node()->get_logger(), simulation_.physics());
  simulation_.begin_at(static_cast<std::int64_t>(options.initial_time * 1e9));
  runner_.pause(!options.runs);
  runner_.end_after(options.steps);
  const std::string world = "/world/" + simulation_.world().name;
  clock_ = publish_gz<rosgraph_msgs::msg::Clock>(host_, "/clock");
  world_clock_ = publish_gz<rosgraph_msgs::msg::Clock>(host_, world + "/clock");
  name_ = host_.node()->create_publisher<std_msgs::msg::String>(kWorldName,
                                                                rclcpp::QoS(1).transient_local());
  std_msgs::msg::String name;
  name.data = simulation_.world().name;
  name_->publish(name);
  if (options.any_make)
    any_make_ = std::make_unique<SimulationServices>(host_, simulation_, runner_);
  if (!options.runs)
    RCLCPP_INFO(host_.node()->get_logger(),
                "the world [%s] is paused: `-r` in its arguments lets it run at once",
                simulation_.world().name.c_str());
}

void SimServer::publish_clock() {
  rosgraph_msgs::msg::Clock message;
  message.clock = stamp_of(simulation_.time_ns());
  for (const auto& publisher : {clock_, world_clock_})
    if (publisher->get_subscription_count() > 0) publisher->publish(message);
}

}  // namespace ros2wasm_sim
