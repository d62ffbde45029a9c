// What every node brings: the parameter services, /parameter_events and /rosout, as tools expect
// them.

// Compatibility, works: what every C++ node brings: six parameter services,
// `~/get_type_description` with hashes and sources (`start_type_description_service`),
// `/parameter_events`, `/rosout` (1000, transient local, 10 s), logger services when asked for

// Compatibility, works: `rclcpp::node_interfaces::NodeInterfaces`: some interfaces of a node, in
// place of it

#include <algorithm>
#include <map>
#include <set>

#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rcl_interfaces/msg/log.hpp"
#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_logger_levels.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/node_interfaces/node_interfaces.hpp"
#include "type_description_interfaces/srv/get_type_description.hpp"

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

constexpr char kParameterEventHash[] =
    "RIHS01_043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204";
constexpr char kAddTwoIntsHash[] =
    "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a";

// The service that describes the types that a node uses, as `ros2 bag` and bridges ask it.
void check_types(Checks& checks, const rclcpp::Node::SharedPtr& tool, rclcpp::Executor& executor) {
  using type_description_interfaces::srv::GetTypeDescription;
  const auto ask = [&](const std::string& hash, bool sources) {
    auto request = std::make_shared<GetTypeDescription::Request>();
    request->type_hash = hash;
    request->include_type_sources = sources;
    return call<GetTypeDescription>(tool, executor, "get_type_description", request);
  };
  const auto event = ask(kParameterEventHash, true);
  CHECK(event->successful);
  CHECK(event->failure_reason.empty());
  const auto& whole = event->type_description;
  CHECK(whole.type_description.type_name == "rcl_interfaces/msg/ParameterEvent");
  CHECK(whole.type_description.fields.size() == 5);
  CHECK(whole.type_description.fields[0].name == "stamp");
  CHECK(whole.type_description.fields[0].type.type_id == 1);
  CHECK(whole.type_description.fields[0].type.nested_type_name == "builtin_interfaces/msg/Time");
  CHECK(whole.type_description.fields[2].name == "new_parameters");
  CHECK(whole.type_description.fields[2].type.type_id == 145);
  std::vector<std::string> names;
  for (const auto& one : whole.referenced_type_descriptions) {
    names.push_back(one.type_name);
  }
  CHECK((names == std::vector<std::string>{"builtin_interfaces/msg/Time",
                                           "rcl_interfaces/msg/Parameter",
                                           "rcl_interfaces/msg/ParameterValue"}));
  CHECK(event->type_sources.size() == 4);
  CHECK(event->type_sources[0].type_name == "rcl_interfaces/msg/ParameterEvent");
  CHECK(event->type_sources[0].encoding == "msg");
  CHECK(event->type_sources[0].raw_file_contents.find("Parameter[] new_parameters") !=
        std::string::npos);
  CHECK(ask(kParameterEventHash, false)->type_sources.empty());

  using example_interfaces::srv::AddTwoInts;
  CHECK(ask(kAddTwoIntsHash, true)->failure_reason == "Type not currently in use by this node");
  auto elsewhere =
      tool->create_client<AddTwoInts>("uncalled_add");  // another node's use does not count
  CHECK(!ask(kAddTwoIntsHash, true)->successful);
  CHECK(ask("", true)->failure_reason == "Failed to parse type hash");
  CHECK(ask("RIHS02_" + std::string(kAddTwoIntsHash).substr(7), true)->failure_reason ==
        "Failed to parse type hash");
}

// A node's services change what it can describe.
void check_service_type(Checks& checks, const rclcpp::Node::SharedPtr& node,
                        const rclcpp::Node::SharedPtr& tool, rclcpp::Executor& executor) {
  using example_interfaces::srv::AddTwoInts;
  using type_description_interfaces::srv::GetTypeDescription;
  auto request = std::make_shared<GetTypeDescription::Request>();
  request->type_hash = kAddTwoIntsHash;
  auto client = node->create_client<AddTwoInts>("uncalled_add");
  const auto used = call<GetTypeDescription>(tool, executor, "get_type_description", request);
  CHECK(used->successful);
  std::vector<std::string> names;
  for (const auto& one : used->type_description.referenced_type_descriptions) {
    names.push_back(one.type_name);
  }
  const std::string type = "example_interfaces/srv/AddTwoInts";
  CHECK((names == std::vector<std::string>{"builtin_interfaces/msg/Time", type + "_Event",
                                           type + "_Request", type + "_Response",
                                           "service_msgs/msg/ServiceEventInfo"}));
  CHECK(used->type_sources.size() == 6);
  CHECK(used->type_sources[0].encoding == "srv");
  CHECK(used->type_sources[2].encoding == "implicit");
  CHECK(used->type_sources[2].raw_file_contents.empty());
  client.reset();
  CHECK(!call<GetTypeDescription>(tool, executor, "get_type_description", request)->successful);
  rclcpp::Node silent("silent", rclcpp::NodeOptions().append_parameter_override(
                                    "start_type_description_service", false));
  CHECK(silent.get_service_names_and_types_by_node("silent", "/")
            .count("/silent/get_type_description") == 0);
}

using Few =
    rclcpp::node_interfaces::NodeInterfaces<rclcpp::node_interfaces::NodeBaseInterface,
                                            rclcpp::node_interfaces::NodeTopicsInterface,
                                            rclcpp::node_interfaces::NodeParametersInterface>;

std::string name_of(const Few& node) {
  return node.get_node_base_interface()->get_fully_qualified_name();
}

// What stands for a node where one is asked for.
void check_interfaces(Checks& checks, const rclcpp::Node::SharedPtr& node) {
  using namespace rclcpp::node_interfaces;
  CHECK(name_of(*node) == "/under/test");
  NodeInterfaces<ALL_RCLCPP_NODE_INTERFACES> all(*node);
  CHECK(name_of(all) == "/under/test");
  CHECK(all.get<NodeGraphInterface>() == node->get_node_graph_interface());
  const NodeInterfaces<NodeClockInterface> clock(node->get_node_clock_interface());
  CHECK(clock.get_node_clock_interface()->get_clock() == node->get_clock());
  Few few(all);
  CHECK(few.get<NodeTopicsInterface>() == node->get_node_topics_interface());
  const auto publisher = rclcpp::create_publisher<rcl_interfaces::msg::Parameter>(
      few, "by_interfaces", rclcpp::QoS(1));
  CHECK(node->count_publishers("/under/by_interfaces") == 1);
  const auto another = rclcpp::create_publisher<rcl_interfaces::msg::Parameter>(
      node->get_node_parameters_interface(), node->get_node_topics_interface(), "by_interfaces",
      rclcpp::QoS(1));
  CHECK(node->count_publishers("/under/by_interfaces") == 2);
  const auto subscription = rclcpp::create_subscription<rcl_interfaces::msg::Parameter>(
      node->get_node_parameters_interface(), node->get_node_topics_interface(), "by_interfaces",
      rclcpp::QoS(1), [](const rcl_interfaces::msg::Parameter&) {});
  CHECK(another->get_subscription_count() == 1);
  few.set<NodeTopicsInterface>(nullptr);
  CHECK(few.get_node_topics_interface() == nullptr);
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
  check_interfaces(checks, node);

  const auto services = tool->get_service_names_and_types_by_node("test", "/under");
  const std::map<std::string, std::string> expected = {
      {"get_parameters", "rcl_interfaces/srv/GetParameters"},
      {"get_parameter_types", "rcl_interfaces/srv/GetParameterTypes"},
      {"set_parameters", "rcl_interfaces/srv/SetParameters"},
      {"set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"},
      {"describe_parameters", "rcl_interfaces/srv/DescribeParameters"},
      {"list_parameters", "rcl_interfaces/srv/ListParameters"},
      {"get_logger_levels", "rcl_interfaces/srv/GetLoggerLevels"},
      {"set_logger_levels", "rcl_interfaces/srv/SetLoggerLevels"},
      {"get_type_description", "type_description_interfaces/srv/GetTypeDescription"}};
  CHECK(services.size() == expected.size());
  for (const auto& [name, type] : expected) {
    const auto found = services.find("/under/test/" + name);
    CHECK(found != services.end() && found->second == std::vector<std::string>{type});
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
  for (const char* name : {"count", "use_sim_time", "start_type_description_service",
                           "qos_overrides./parameter_events.publisher.depth",
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
  describe->names = {"count", "qos_overrides./parameter_events.publisher.depth",
                     "start_type_description_service"};
  const auto described =
      call<DescribeParameters>(tool, executor, "describe_parameters", describe)->descriptors;
  CHECK(described.size() == 3);
  CHECK(described[0].type == ParameterType::PARAMETER_INTEGER);
  CHECK(described[1].read_only);
  CHECK(described[2].type == ParameterType::PARAMETER_BOOL);
  CHECK(described[2].read_only);

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
  check_types(checks, tool, executor);
  check_service_type(checks, node, tool, executor);
  return checks.finish();
}
