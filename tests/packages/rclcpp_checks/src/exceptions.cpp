// Exceptions reach their catch with the class and the text that ROS 2 gives them, whatever else the
// program keeps: thread-local variables too.
#include <array>
#include <typeinfo>

#include "checks.hpp"

namespace {

thread_local std::array<int, 512> many{1, 2, 3};
thread_local std::string text = "made when first used";
thread_local int last = 7;

// The text of an exception that is exactly an ErrorT; empty when there is no such exception.
template <typename ErrorT>
std::string text_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return typeid(error) == typeid(ErrorT) ? error.what() : "";
  }
  return "";
}

bool starts(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

void init_with(const std::vector<const char*>& arguments) {
  std::make_shared<rclcpp::Context>()->init(static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace

int main(int argc, char** argv) {
  namespace errors = rclcpp::exceptions;
  const std::string without_init =
      text_of<errors::RCLError>([] { rclcpp::Node node("too_early"); });
  rclcpp::init(argc, argv);
  Checks checks("exceptions");
  CHECK(starts(without_init,
               "failed to initialize rcl node: the given context is not valid, either rcl_init() "
               "was not called or "
               "rcl_shutdown() was called., at "));

  CHECK(many[0] == 1 && many[2] == 3 && many[3] == 0 && many[511] == 0);
  CHECK(text == "made when first used" && last == 7);
  many.fill(-1);
  CHECK_THROWS(
      errors::RCLError,
      rclcpp::Node("n", rclcpp::NodeOptions().context(std::make_shared<rclcpp::Context>())));
  CHECK(many[0] == -1 && many[511] == -1 && last == 7);

  CHECK(text_of<errors::UnknownROSArgsError>([] {
          init_with({"p", "--ros-args", "--custom", "-x"});
        }) == "found unknown ROS arguments: '--custom', '-x'");
  CHECK(starts(text_of<errors::RCLInvalidROSArgsError>([] {
                 init_with({"p", "--ros-args", "-r", "no_rule"});
               }),
               "failed to initialize rcl: Couldn't parse remap rule: '-r no_rule'. Error: "));
  CHECK(starts(text_of<errors::RCLInvalidROSArgsError>([] {
                 init_with({"p", "--ros-args", "-p"});
               }),
               "failed to initialize rcl: Couldn't parse trailing -p flag. No value found."));
  CHECK(
      starts(text_of<errors::RCLInvalidROSArgsError>([] {
               rclcpp::Node node(
                   "n", rclcpp::NodeOptions().arguments({"--ros-args", "-r", "__ns:=relative"}));
             }),
             "failed to parse arguments: Couldn't parse remap rule: '-r __ns:=relative'. Error: "));

  rclcpp::Node node("exceptions_node");
  node.declare_parameter("number", 1);
  CHECK(text_of<errors::ParameterAlreadyDeclaredException>([&] {
          node.declare_parameter("number", 2);
        }) == "parameter 'number' has already been declared");
  CHECK(text_of<errors::ParameterNotDeclaredException>([&] { node.get_parameter("absent"); }) ==
        "absent");
  CHECK(text_of<errors::InvalidParametersException>([&] { node.declare_parameter("", 2); }) ==
        "parameter name must not be empty");
  CHECK(text_of<errors::UninitializedStaticallyTypedParameterException>([&] {
          node.declare_parameter<int>("unset");
        }) == "Statically typed parameter 'unset' must be initialized.");
  rcl_interfaces::msg::ParameterDescriptor small;
  small.integer_range.resize(1);
  small.integer_range[0].to_value = 3;
  CHECK(starts(text_of<errors::InvalidParameterValueException>(
                   [&] { node.declare_parameter("small", 4, small); }),
               "parameter 'small' could not be set: "));
  CHECK(text_of<rclcpp::ParameterTypeException>([&] {
          node.get_parameter("number").as_string();
        }) == "expected [string] got [integer]");
  CHECK(starts(text_of<errors::InvalidNamespaceError>([] { rclcpp::Node bad("n", "1/2"); }),
               "Invalid namespace: "));
  return checks.finish();
}
