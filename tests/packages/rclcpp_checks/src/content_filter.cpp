// Content filters: what expressions say of messages, what is refused, and subscriptions that have
// one.

// Compatibility, works: content filters (`content_filter_options`, `set_content_filter`,
// `get_content_filter`): fields of nested messages, elements of arrays and sequences, = <> < <= >
// >= LIKE BETWEEN, AND OR NOT, %0 to %99

// Compatibility, differs: content filters -> a subscription looks at a message when it takes it,
// so those that it leaves out count towards the depth of keep_last, and wait sets notice them;
// subscriptions by pointer are filtered too; MATCH (regular expressions) is refused as every other
// unknown word

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/detail/content_filter.hpp"
#include "rclcpp/serialization.hpp"
#include "std_msgs/msg/float32.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_msgs/msg/u_int64.hpp"

using rcl_interfaces::msg::ParameterEvent;
using rclcpp::ContentFilterOptions;
using std_msgs::msg::Float32;
using std_msgs::msg::String;
using std_msgs::msg::UInt64;
using namespace std::chrono_literals;

namespace {

template <typename MessageT>
bool passes(const MessageT& message, const std::string& expression,
            const std::vector<std::string>& parameters = {}, size_t cut = 0) {
  rclcpp::SerializedMessage bytes;
  rclcpp::Serialization<MessageT>().serialize_message(&message, &bytes);
  const auto& type = rclcpp::detail::callbacks_of(rclcpp::detail::type_support_of<MessageT>());
  const rclcpp::detail::ContentFilter filter(*type.info, {expression, parameters});
  const auto& raw = bytes.get_rcl_serialized_message();
  return filter.passes(raw.buffer, raw.buffer_length - cut);
}

String text(const std::string& data) {
  String message;
  message.data = data;
  return message;
}

Float32 number(float data) {
  Float32 message;
  message.data = data;
  return message;
}

ParameterEvent event() {
  ParameterEvent message;
  message.stamp.sec = -5;
  message.stamp.nanosec = 7;
  message.node = "/arm";
  message.new_parameters.resize(2);
  message.new_parameters[0].value.string_array_value = {"a", "bc"};
  message.new_parameters[0].value.double_array_value = {1, 2};
  message.new_parameters[0].value.bool_value = true;
  message.new_parameters[1].name = "speed";
  message.new_parameters[1].value.integer_array_value = {-1, 2, 3};
  message.new_parameters[1].value.double_value = 2.5;
  return message;
}

void check_expressions(Checks& checks) {
  CHECK(passes(text("Hello, world! 10"), "data = %0", {"'Hello, world! 10'"}));
  CHECK(!passes(text("Hello, world! 1"), "data = %0", {"'Hello, world! 10'"}));
  CHECK(passes(text("b"), "data > 'a' AND data <= 'b'"));
  CHECK(passes(text("arm_left"), "data LIKE 'arm%'"));
  CHECK(passes(text("arm_left"), "data like '%_l_ft'"));
  CHECK(!passes(text("arm_left"), "data LIKE 'arm'"));
  CHECK(passes(text("b"), "NOT data = 'a'"));
  CHECK(passes(number(-40), "data < %0 OR data > %1", {"-30.000000", "100.000000"}));
  CHECK(!passes(number(0), "data < %0 OR data > %1", {"-30.000000", "100.000000"}));
  CHECK(passes(number(2), "%1 <> data and 2 = data", {"0", "3"}));
  CHECK(passes(number(2), "data BETWEEN 1 AND 2 AND data != 3"));
  CHECK(!passes(number(2), "data NOT BETWEEN 1 AND 2"));
  CHECK(passes(number(1), "data = 1 OR data = 2 AND data = 3"));
  CHECK(!passes(number(1), "(data = 1 OR data = 2) AND data = 3"));
  CHECK(!passes(number(std::numeric_limits<float>::quiet_NaN()), "data < 1 OR data >= 1"));
  UInt64 big;
  big.data = std::numeric_limits<uint64_t>::max();
  CHECK(passes(big, "data = 18446744073709551615"));
  CHECK(passes(big, "data > -1 AND data > 18446744073709551614"));
  const ParameterEvent nested = event();
  CHECK(passes(nested, "stamp.sec = -5 AND stamp.nanosec >= 0x7"));
  CHECK(passes(nested, "node = '/arm'"));
  CHECK(passes(nested, "new_parameters[1].name = 'speed'"));
  CHECK(passes(nested, "new_parameters[1].value.double_value = 2.5e0"));
  CHECK(passes(nested, "new_parameters[1].value.integer_array_value[2] = 3"));
  CHECK(passes(nested, "new_parameters[0].value.string_array_value[1] = 'bc'"));
  CHECK(passes(nested, "new_parameters[0].value.bool_value = TRUE"));
  CHECK(passes(nested, "new_parameters[1].value.bool_value = false"));
  CHECK(!passes(nested, "new_parameters[2].name <> 'x'"));
  CHECK(passes(nested, "stamp.sec < stamp.nanosec"));
}

void check_numbers(Checks& checks) {
  CHECK(passes(number(10), "data = 010"));
  CHECK(passes(number(-9), "data = -09"));
  CHECK(passes(number(31), "data = 0x1F AND data = 0X1f"));
  CHECK(passes(number(-30), "data = -0x1e"));
  CHECK(passes(number(9), "data = %08", {"0", "1", "2", "3", "4", "5", "6", "7", "9"}));
}

/// What a message does not have is neither so nor otherwise.
void check_unknown(Checks& checks) {
  const ParameterEvent nested = event();
  const char* const missing = "new_parameters[2].name = 'x'";
  CHECK(!passes(nested, std::string("NOT ") + missing));
  CHECK(!passes(nested, std::string("NOT NOT ") + missing));
  CHECK(!passes(nested, "new_parameters[0].value.double_array_value[9] NOT BETWEEN 1 AND 2"));
  CHECK(!passes(nested, std::string("NOT (node = '/arm' AND ") + missing + ")"));
  CHECK(!passes(nested, std::string("NOT (") + missing + " OR node = '/leg')"));
  CHECK(passes(nested, std::string("NOT (") + missing + " AND node = '/leg')"));
  CHECK(passes(nested, std::string(missing) + " OR node = '/arm'"));
  CHECK(passes(text("bean"), "NOT data = 'apple'"));
  CHECK(!passes(text("bean"), "NOT data = 'apple'", {}, 1));
  CHECK(!passes(number(1), "data NOT BETWEEN 2 AND 3", {}, 1));
}

void check_refusals(Checks& checks) {
  for (const char* wrong : {"data", "data =", "data = 1", "data = 'a", "dat = 'a'", "data = %0",
                            "data[0] = 'a'", "data = 'a' data = 'b'", "(data = 'a'", "data LIKE 1",
                            "data BETWEEN 'a'", "data = 'a' AND", "data.size = 'a'", "= 'a'"}) {
    CHECK_THROWS(std::invalid_argument, passes(text("a"), wrong));
  }
  CHECK_THROWS(std::invalid_argument, passes(text("a"), "data = %0", {"unquoted"}));
  CHECK_THROWS(std::invalid_argument, passes(event(), "stamp = 1"));
  CHECK_THROWS(std::invalid_argument, passes(event(), "new_parameters.name = 'a'"));
  CHECK_THROWS(std::invalid_argument,
               passes(number(1), "data = 1", std::vector<std::string>(101, "1")));
}

void check_subscriptions(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("content_filter_node");
  std::vector<std::string> heard;
  std::vector<std::string> all;
  rclcpp::SubscriptionOptions options;
  options.content_filter_options = {"data LIKE %0", {"'a%'"}};
  const auto hear = [&heard](const String& message) { heard.push_back(message.data); };
  auto filtered = node->create_subscription<String>("chosen", 10, hear, options);
  options.use_intra_process_comm = rclcpp::IntraProcessSetting::Enable;
  std::vector<std::string> local;
  auto by_pointer = node->create_subscription<String>(
      "chosen", 10, [&local](const String& message) { local.push_back(message.data); }, options);
  auto plain = node->create_subscription<String>(
      "chosen", 10, [&all](const String& message) { all.push_back(message.data); });
  rclcpp::PublisherOptions publishing;
  publishing.use_intra_process_comm = rclcpp::IntraProcessSetting::Enable;
  auto publisher = node->create_publisher<String>("chosen", 10, publishing);
  CHECK(filtered->is_cft_enabled());
  CHECK(!plain->is_cft_enabled());
  CHECK(filtered->get_content_filter().filter_expression == "data LIKE %0");
  CHECK(filtered->get_content_filter().expression_parameters == std::vector<std::string>{"'a%'"});
  CHECK_THROWS(rclcpp::exceptions::RCLError, plain->get_content_filter());
  CHECK_THROWS(rclcpp::exceptions::RCLError, filtered->set_content_filter("data ="));
  options.content_filter_options.filter_expression = "no_such_field = 1";
  CHECK_THROWS(rclcpp::exceptions::RCLError,
               node->create_subscription<String>("chosen", 10, hear, options));

  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  const auto say = [&](const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      publisher->publish(text(word));
    }
    const size_t wanted = all.size() + words.size();
    while (all.size() < wanted && rclcpp::ok()) {
      executor.spin_some(10ms);
    }
    executor.spin_all(0ns);
  };
  say({"apple", "bean", "ant"});
  CHECK((heard == std::vector<std::string>{"apple", "ant"}));
  CHECK((local == std::vector<std::string>{"apple", "ant"}));
  filtered->set_content_filter("data = 'bean'");
  say({"apple", "bean"});
  CHECK((heard == std::vector<std::string>{"apple", "ant", "bean"}));
  filtered->set_content_filter("");
  CHECK(!filtered->is_cft_enabled());
  say({"any"});
  CHECK(heard.size() == 4);
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("content_filter");
  check_expressions(checks);
  check_numbers(checks);
  check_unknown(checks);
  check_refusals(checks);
  check_subscriptions(checks);
  return checks.finish();
}
