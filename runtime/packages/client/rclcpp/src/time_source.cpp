// /clock is read as background work: whenever the program waits, whoever waits.
#include "rclcpp/time_source.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/detail/background.hpp"
#include "rclcpp/detail/bus_qos.hpp"
#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/detail/type_use.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "ros2wasm/endpoint.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rclcpp {

class TimeSource::State : public std::enable_shared_from_this<TimeSource::State> {
 public:
  explicit State(const rclcpp::QoS& qos_in) : qos(qos_in) {}

  void set_active(bool active) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    if (is_active == active) {
      return;
    }
    is_active = active;
    if (active) {
      subscribe();
    } else {
      background.reset();
      endpoint.reset();
    }
    for (const auto& clock : clocks) {
      apply(*clock);
    }
  }

  void apply(Clock& clock) {
    clock.set_ros_time_active(is_active);
    if (is_active && has_time) {
      clock.set_ros_time(last_time_ns);
    }
  }

  void subscribe() {
    const detail::MessageCallbacks& type =
        detail::callbacks_of(detail::type_support_of<rosgraph_msgs::msg::Clock>());
    endpoint = std::make_unique<ros2wasm::Endpoint>(ros2wasm::EndpointKind::subscription, node_id,
                                                    "/clock", type.type_name, type.type_hash,
                                                    detail::to_bus(detail::resolve_qos(qos)));
    type_use = detail::use_type(node_id, type.type_hash, type.info);
    std::weak_ptr<State> weak = weak_from_this();
    background = detail::add_background(endpoint->id(), [weak] {
      if (const auto state = weak.lock()) {
        state->take_clock();
      }
    });
  }

  void take_clock() {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    ros2wasm::Bytes bytes;
    ros2wasm::SampleInfo info{};
    rosgraph_msgs::msg::Clock message;
    while (endpoint && endpoint->take(bytes, info)) {
      if (!detail::callbacks_of(detail::type_support_of<rosgraph_msgs::msg::Clock>())
               .deserialize(bytes.data(), bytes.size(), &message)) {
        continue;
      }
      last_time_ns = Time(message.clock).nanoseconds();
      has_time = true;
      for (const auto& clock : clocks) {
        clock->set_ros_time(last_time_ns);
      }
    }
  }

  std::recursive_mutex mutex;
  const rclcpp::QoS qos;
  bool use_clock_thread = true;
  int32_t node_id = -1;
  bool is_active = false;
  bool has_time = false;
  int64_t last_time_ns = 0;
  std::vector<Clock::SharedPtr> clocks;
  std::unique_ptr<ros2wasm::Endpoint> endpoint;
  std::shared_ptr<void> background;
  std::shared_ptr<void> type_use;
  // A subscription to /parameter_events, as the graph shows of a time source on a robot. Its
  // messages are dropped.
  std::unique_ptr<ros2wasm::Endpoint> events;
  std::shared_ptr<void> events_background;
  std::shared_ptr<node_interfaces::NodeParametersInterface> parameters;
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr on_set;
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr post_set;
};

TimeSource::TimeSource(std::shared_ptr<rclcpp::Node> node, const rclcpp::QoS& qos,
                       bool use_clock_thread)
    : TimeSource(qos, use_clock_thread) {
  attachNode(std::move(node));
}

TimeSource::TimeSource(const rclcpp::QoS& qos, bool use_clock_thread)
    : state_(std::make_shared<State>(qos)) {
  state_->use_clock_thread = use_clock_thread;
}

TimeSource::~TimeSource() {
  detachNode();
}

void TimeSource::attachNode(std::shared_ptr<rclcpp::Node> node) {
  set_use_clock_thread(node->get_node_options().use_clock_thread());
  attachNode(node->get_node_base_interface(), node->get_node_topics_interface(),
             node->get_node_graph_interface(), node->get_node_services_interface(),
             node->get_node_logging_interface(), node->get_node_clock_interface(),
             node->get_node_parameters_interface());
}

void TimeSource::attachNode(
    std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
    std::shared_ptr<node_interfaces::NodeTopicsInterface>,
    std::shared_ptr<node_interfaces::NodeGraphInterface>,
    std::shared_ptr<node_interfaces::NodeServicesInterface>,
    std::shared_ptr<node_interfaces::NodeLoggingInterface> node_logging,
    std::shared_ptr<node_interfaces::NodeClockInterface>,
    std::shared_ptr<node_interfaces::NodeParametersInterface> node_parameters) {
  const std::shared_ptr<State> state = state_;
  state->node_id = node_base->get_node_id();
  state->parameters = node_parameters;

  const auto& events_type =
      detail::callbacks_of(detail::type_support_of<rcl_interfaces::msg::ParameterEvent>());
  state->events = std::make_unique<ros2wasm::Endpoint>(
      ros2wasm::EndpointKind::subscription, state->node_id, "/parameter_events",
      events_type.type_name, events_type.type_hash,
      detail::to_bus(detail::resolve_qos(rclcpp::ParameterEventsQoS())));
  std::weak_ptr<State> weak = state;
  state->events_background = detail::add_background(state->events->id(), [weak] {
    if (const auto locked = weak.lock()) {
      locked->events->drain();
    }
  });

  // Not declared by a node that declares its overrides itself.
  rclcpp::ParameterValue value(false);
  if (!node_parameters->has_parameter("use_sim_time")) {
    value = node_parameters->declare_parameter("use_sim_time", rclcpp::ParameterValue(false));
  } else {
    value = node_parameters->get_parameter("use_sim_time").get_parameter_value();
  }
  if (value.get_type() != rclcpp::PARAMETER_BOOL) {
    RCLCPP_ERROR(node_logging->get_logger(),
                 "Invalid type '%s' for parameter 'use_sim_time', should be 'bool'",
                 rclcpp::to_string(value.get_type()).c_str());
    throw std::invalid_argument("Invalid type for parameter 'use_sim_time', should be 'bool'");
  }
  state->on_set = node_parameters->add_on_set_parameters_callback(
      [](const std::vector<rclcpp::Parameter>& parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        for (const rclcpp::Parameter& parameter : parameters) {
          if (parameter.get_name() == "use_sim_time" &&
              parameter.get_type() != rclcpp::PARAMETER_BOOL) {
            result.successful = false;
            result.reason = "'use_sim_time' must be a bool";
          }
        }
        return result;
      });
  state->post_set = node_parameters->add_post_set_parameters_callback(
      [weak](const std::vector<rclcpp::Parameter>& parameters) {
        for (const rclcpp::Parameter& parameter : parameters) {
          const auto locked = weak.lock();
          if (locked && parameter.get_name() == "use_sim_time") {
            locked->set_active(parameter.as_bool());
          }
        }
      });
  state->set_active(value.get<bool>());
}

void TimeSource::detachNode() {
  state_->set_active(false);
  state_->events_background.reset();
  state_->events.reset();
  state_->on_set.reset();
  state_->post_set.reset();
  state_->parameters.reset();
}

void TimeSource::attachClock(rclcpp::Clock::SharedPtr clock) {
  if (clock->get_clock_type() != RCL_ROS_TIME) {
    throw std::invalid_argument("Cannot attach clock to a time source that's not a ROS clock");
  }
  const std::lock_guard<std::recursive_mutex> lock(state_->mutex);
  state_->clocks.push_back(clock);
  state_->apply(*clock);
}

void TimeSource::detachClock(rclcpp::Clock::SharedPtr clock) {
  const std::lock_guard<std::recursive_mutex> lock(state_->mutex);
  auto& clocks = state_->clocks;
  const auto found = std::find(clocks.begin(), clocks.end(), clock);
  if (found == clocks.end()) {
    RCLCPP_ERROR(rclcpp::get_logger("rclcpp"), "Failed to remove clock");
    return;
  }
  clocks.erase(found);
}

bool TimeSource::get_use_clock_thread() {
  return state_->use_clock_thread;
}

void TimeSource::set_use_clock_thread(bool use_clock_thread) {
  state_->use_clock_thread = use_clock_thread;
}

bool TimeSource::clock_thread_is_joinable() {
  return false;
}

}  // namespace rclcpp
