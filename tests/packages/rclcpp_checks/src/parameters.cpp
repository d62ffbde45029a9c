// Parameters: overrides from arguments, types, ranges, callbacks, events, clients.
#include "checks.hpp"

using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("parameters");
  auto node = std::make_shared<rclcpp::Node>(
      "parameters_node", rclcpp::NodeOptions().append_parameter_override("from_options", 3));
  CHECK(node->declare_parameter("from_arguments", 1.0) == 2.5);
  CHECK((node->declare_parameter("names", std::vector<std::string>{}) ==
         std::vector<std::string>{"a", "b"}));
  CHECK(node->declare_parameter("from_options", 0) == 3);
  CHECK(node->declare_parameter("text", "plain") == "plain");
  CHECK(!node->get_parameter("use_sim_time").as_bool());

  rcl_interfaces::msg::ParameterDescriptor even;
  even.integer_range.resize(1);
  even.integer_range[0].from_value = 0;
  even.integer_range[0].to_value = 9;
  even.integer_range[0].step = 2;
  CHECK(node->declare_parameter("even", 4, even) == 4);
  CHECK(node->set_parameter(rclcpp::Parameter("even", 6)).successful);
  CHECK(!node->set_parameter(rclcpp::Parameter("even", 7)).successful);
  CHECK(node->set_parameter(rclcpp::Parameter("even", 9)).successful);
  CHECK(!node->set_parameter(rclcpp::Parameter("text", 5)).successful);
  rcl_interfaces::msg::ParameterDescriptor fixed;
  fixed.read_only = true;
  node->declare_parameter("fixed", true, fixed);
  CHECK(!node->set_parameter(rclcpp::Parameter("fixed", false)).successful);

  using rclcpp::exceptions::ParameterAlreadyDeclaredException;
  using rclcpp::exceptions::ParameterNotDeclaredException;
  CHECK_THROWS(ParameterAlreadyDeclaredException, node->declare_parameter("even", 1));
  CHECK_THROWS(ParameterNotDeclaredException, node->get_parameter("unknown"));
  CHECK_THROWS(rclcpp::exceptions::InvalidParameterTypeException,
               node->get_parameter("text").get_value<int>());
  CHECK(node->get_parameter_or<int>("unknown", 11) == 11);

  std::vector<std::string> order;
  auto pre = node->add_pre_set_parameters_callback([&](std::vector<rclcpp::Parameter>& list) {
    order.push_back("pre");
    if (list[0].get_name() == "text") {
      list.emplace_back("even", 2);
    }
  });
  auto on = node->add_on_set_parameters_callback([&](const std::vector<rclcpp::Parameter>& list) {
    order.push_back("on");
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = list[0].value_to_string() != "forbidden";
    result.reason = "forbidden";
    return result;
  });
  auto post = node->add_post_set_parameters_callback(
      [&](const std::vector<rclcpp::Parameter>&) { order.push_back("post"); });
  CHECK(node->set_parameter(rclcpp::Parameter("text", "new")).successful);
  CHECK((order == std::vector<std::string>{"pre", "on", "post"}));
  CHECK(node->get_parameter("even").as_int() == 2);
  CHECK(node->set_parameter(rclcpp::Parameter("text", "forbidden")).reason == "forbidden");
  CHECK(node->get_parameter("text").as_string() == "new");
  pre.reset();

  double changed = 0;
  rclcpp::ParameterEventHandler events(node);
  auto handle = events.add_parameter_callback(
      "from_arguments", [&](const rclcpp::Parameter& one) { changed = one.as_double(); });
  rclcpp::SyncParametersClient client(node, "parameters_node");
  CHECK(client.wait_for_service(1s));
  CHECK(client.set_parameters({rclcpp::Parameter("from_arguments", 9.0)})[0].successful);
  CHECK(client.get_parameter<double>("from_arguments") == 9.0);
  CHECK(client.has_parameter("even"));
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_all(2s);  // events of other nodes may come first
  CHECK(changed == 9.0);
  return checks.finish();
}
