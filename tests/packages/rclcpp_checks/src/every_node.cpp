// What every node brings: the parameter services, /parameter_events and /rosout, as tools expect
// them.
#include <algorithm>
#include <map>
#include <set>

#include "checks.hpp"
#include "rcl_interfaces/msg/log.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_logger_levels.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"

using namespace std::chrono_literals;
using rcl_interfaces::msg::Log;
using rcl_interfaces::msg::ParameterEvent;
using rcl_interfaces::msg::ParameterType;

namespace {

// Calls a service of the node under test, as a tool does that knows its name only.
template <typename ServiceT>
std::shared_ptr<typename ServiceT::Response> call(
    const rclcpp::Node::SharedPtr& tool, rclcpp::Executor& executor, const std::string& name,
    const std::shared_ptr<typename ServiceT::Request>& request) {
  auto client = tool->create_client<ServiceT>("/under/test/" + name);
  client->wait_for_service();
  auto answer = client->async_send_request(request);
  executor.spin_until_future_complete(answer);
  return answer.get();
}

rcl_interfaces::msg::Parameter integer(const std::string& name, int64_t value) {
  return rclcpp::Parameter(name, value).to_parameter_msg();
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("every_node");
  auto node = std::make_shared<rclcpp::Node>("test", "/under",
                                             rclcpp::NodeOptions().enable_logger_service(true));
  auto tool = std::make_shared<rclcpp::Node>("tool");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(tool);
  node->declare_parameter("count", 1);

  const auto services = tool->get_service_names_and_types_by_node("test", "/under");
  const std::map<std::string, std::string> expected = {
      {"get_parameters", "GetParameters"},
      {"get_parameter_types", "GetParameterTypes"},
      {"set_parameters", "SetParameters"},
      {"set_parameters_atomically", "SetParametersAtomically"},
      {"describe_parameters", "DescribeParameters"},
      {"list_parameters", "ListParameters"},
      {"get_logger_levels", "GetLoggerLevels"},
      {"set_logger_levels", "SetLoggerLevels"}};
  CHECK(services.size() == expected.size());
  for (const auto& [name, type] : expected) {
    const auto found = services.find("/under/test/" + name);
    CHECK(found != services.end() &&
          found->second == std::vector<std::string>{"rcl_interfaces/srv/" + type});
  }

  // QoS of the two topics, as `ros2 topic info --verbose` shows it.
  const auto is_ours = [](const rclcpp::TopicEndpointInfo& info) {
    return info.node_name() == "test";
  };
  const auto rosout = node->get_publishers_info_by_topic("/rosout");
  const auto log = std::find_if(rosout.begin(), rosout.end(), is_ours);
  CHECK(log != rosout.end());
  CHECK(log->qos_profile().depth() == 1000);
  CHECK(log->qos_profile().durability() == rclcpp::DurabilityPolicy::TransientLocal);
  CHECK(log->qos_profile().reliability() == rclcpp::ReliabilityPolicy::Reliable);
  CHECK(log->qos_profile().lifespan() == rclcpp::Duration(10s));
  CHECK(log->topic_type() == "rcl_interfaces/msg/Log");
  const auto events = node->get_publishers_info_by_topic("/parameter_events");
  const auto event = std::find_if(events.begin(), events.end(), is_ours);
  CHECK(event != events.end());
  CHECK(event->qos_profile().depth() == 1000);
  CHECK(event->qos_profile().durability() == rclcpp::DurabilityPolicy::Volatile);

  // Who comes late still reads what was logged; the logger's name has the namespace.
  RCLCPP_WARN(node->get_logger(), "said %d before", 1);
  std::vector<Log> heard;
  auto late = tool->create_subscription<Log>("/rosout", rclcpp::RosoutQoS(), [&](const Log& one) {
    if (one.name == "under.test") {
      heard.push_back(one);
    }
  });
  while (heard.empty()) {
    executor.spin_once();
  }
  CHECK(heard[0].msg == "said 1 before");
  CHECK(heard[0].level == Log::WARN);
  CHECK(heard[0].function == "main");
  CHECK(heard[0].line > 0);

  std::vector<ParameterEvent> told;
  auto listener = tool->create_subscription<ParameterEvent>(
      "/parameter_events", rclcpp::ParameterEventsQoS(), [&](const ParameterEvent& one) {
        if (one.node == "/under/test") {
          told.push_back(one);
        }
      });

  using rcl_interfaces::srv::ListParameters;
  const auto listed = call<ListParameters>(tool, executor, "list_parameters",
                                           std::make_shared<ListParameters::Request>());
  const std::set<std::string> names(listed->result.names.begin(), listed->result.names.end());
  for (const char* name :
       {"count", "use_sim_time", "qos_overrides./parameter_events.publisher.depth",
        "qos_overrides./parameter_events.publisher.durability",
        "qos_overrides./parameter_events.publisher.history",
        "qos_overrides./parameter_events.publisher.reliability"}) {
    CHECK(names.count(name) == 1);
  }

  using rcl_interfaces::srv::SetParameters;
  auto set = std::make_shared<SetParameters::Request>();
  set->parameters = {integer("count", 5), integer("undeclared", 5)};
  const auto results = call<SetParameters>(tool, executor, "set_parameters", set)->results;
  CHECK(results.size() == 2);
  CHECK(results[0].successful);
  CHECK(!results[1].successful);
  using rcl_interfaces::srv::SetParametersAtomically;
  auto together = std::make_shared<SetParametersAtomically::Request>();
  together->parameters = {integer("count", 6), integer("undeclared", 6)};
  CHECK(!call<SetParametersAtomically>(tool, executor, "set_parameters_atomically", together)
             ->result.successful);

  using rcl_interfaces::srv::GetParameters;
  auto get = std::make_shared<GetParameters::Request>();
  get->names = {"count"};
  const auto values = call<GetParameters>(tool, executor, "get_parameters", get)->values;
  CHECK(values.size() == 1);
  CHECK(values[0].type == ParameterType::PARAMETER_INTEGER);
  CHECK(values[0].integer_value == 5);
  using rcl_interfaces::srv::GetParameterTypes;
  auto types = std::make_shared<GetParameterTypes::Request>();
  types->names = {"use_sim_time"};
  CHECK((call<GetParameterTypes>(tool, executor, "get_parameter_types", types)->types ==
         std::vector<uint8_t>{ParameterType::PARAMETER_BOOL}));
  using rcl_interfaces::srv::DescribeParameters;
  auto describe = std::make_shared<DescribeParameters::Request>();
  describe->names = {"count", "qos_overrides./parameter_events.publisher.depth"};
  const auto described =
      call<DescribeParameters>(tool, executor, "describe_parameters", describe)->descriptors;
  CHECK(described.size() == 2);
  CHECK(described[0].type == ParameterType::PARAMETER_INTEGER);
  CHECK(described[1].read_only);

  // One event for the change that was made, none for those that were refused.
  while (told.empty()) {
    executor.spin_once();
  }
  executor.spin_all(2s);
  CHECK(told.size() == 1);
  CHECK(told[0].changed_parameters.size() == 1);
  CHECK(told[0].changed_parameters[0].name == "count");
  CHECK(told[0].changed_parameters[0].value.integer_value == 5);
  CHECK(told[0].new_parameters.empty());

  using rcl_interfaces::srv::GetLoggerLevels;
  auto levels = std::make_shared<GetLoggerLevels::Request>();
  levels->names = {"under.test"};
  CHECK(call<GetLoggerLevels>(tool, executor, "get_logger_levels", levels)->levels.size() == 1);
  return checks.finish();
}
