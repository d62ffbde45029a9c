// Forms of the client library that few programs use.

// Compatibility, works: generic publishers and subscriptions, sub nodes, `spin_node_once` and its
// kin, groups that an executor is given by themselves, graph events, `wait_for_message`, loaned
// messages, type adapters, QoS from parameters, requests with their responses, pruning of requests,
// `AsyncParametersClient`, `ParameterEventsFilter`, InitOptions, callbacks before shutdown

#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/create_generic_publisher.hpp"
#include "rclcpp/create_generic_subscription.hpp"
#include "rclcpp/parameter_events_filter.hpp"
#include "rclcpp/serialization.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rclcpp/wait_for_message.hpp"
#include "sensor_msgs/fill_image.hpp"
#include "sensor_msgs/image_encodings.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::Int32;
using std_msgs::msg::String;
using namespace std::chrono_literals;

template <>
struct rclcpp::TypeAdapter<std::string, String> {
  using is_specialized = std::true_type;
  using custom_type = std::string;
  using ros_message_type = String;
  static void convert_to_ros_message(const std::string& source, String& destination) {
    destination.data = source;
  }
  static void convert_to_custom(const String& source, std::string& destination) {
    destination = source.data;
  }
};

namespace {

void check_generic(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("generic_forms");
  std::vector<std::string> heard;
  auto subscription = node->create_generic_subscription(
      "bytes", "std_msgs/msg/String", rclcpp::QoS(10),
      [&](std::shared_ptr<const rclcpp::SerializedMessage> bytes, const rclcpp::MessageInfo&) {
        String message;
        rclcpp::Serialization<String>().deserialize_message(bytes.get(), &message);
        heard.push_back(message.data);
      });
  auto publisher = node->create_generic_publisher("bytes", "std_msgs/msg/String", rclcpp::QoS(10));
  String message;
  message.data = "through bytes";
  rclcpp::SerializedMessage bytes;
  rclcpp::Serialization<String>().serialize_message(&message, &bytes);
  publisher->publish(bytes);
  publisher->publish_as_loaned_msg(bytes);
  rclcpp::spin_all(node, 1s);
  CHECK((heard == std::vector<std::string>{"through bytes", "through bytes"}));
  CHECK_THROWS(std::runtime_error, node->create_generic_publisher("bytes", "String", 10));
}

void check_nodes(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("forms_node", "/forms");
  auto inner = node->create_sub_node("inner");
  CHECK(inner->get_sub_namespace() == "inner");
  CHECK(inner->get_effective_namespace() == "/forms/inner");
  CHECK(inner->create_sub_node("most")->get_effective_namespace() == "/forms/inner/most");
  auto publisher = inner->create_publisher<String>("topic", 10);
  CHECK(std::string(publisher->get_topic_name()) == "/forms/inner/topic");
  CHECK(std::string(inner->create_publisher<String>("/far", 10)->get_topic_name()) == "/far");
  CHECK_THROWS(rclcpp::exceptions::NameValidationError, node->create_sub_node("/absolute"));

  const auto values = node->declare_parameters<int64_t>("arm", {{"length", 3}, {"joints", 6}});
  CHECK((values == std::vector<int64_t>{6, 3}));  // in the order of their names
  CHECK(node->get_parameter("arm.joints").as_int() == 6);
  std::map<std::string, int64_t> arm;
  CHECK(node->get_parameters("arm", arm));
  CHECK(arm.at("length") == 3);
  node->declare_parameter("loose", rclcpp::PARAMETER_INTEGER);
  rcl_interfaces::msg::ParameterDescriptor dynamic;
  dynamic.dynamic_typing = true;
  node->declare_parameter("going", rclcpp::ParameterValue(1), dynamic);
  node->undeclare_parameter("going");
  CHECK(!node->has_parameter("going"));
  CHECK_THROWS(rclcpp::exceptions::ParameterNotDeclaredException,
               node->undeclare_parameter("going"));
  CHECK_THROWS(rclcpp::exceptions::InvalidParameterTypeException,
               node->undeclare_parameter("arm.length"));

  // What one of the executor's forms with a node runs.
  int ticks = 0;
  auto timer = node->create_wall_timer(1ms, [&] { ++ticks; });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.spin_node_once(node, 1s);
  CHECK(ticks == 1);
  executor.spin_node_once(node->get_node_base_interface(), std::chrono::nanoseconds(1s));
  CHECK(ticks == 2);
  timer->cancel();
  executor.spin_node_some(node);
  std::promise<int> promise;
  std::shared_future<int> future = promise.get_future();
  CHECK(rclcpp::spin_until_future_complete(node, future, 2ms) == rclcpp::FutureReturnCode::TIMEOUT);
  rclcpp::TimerBase::SharedPtr late;
  late = node->create_wall_timer(1ms, [&] {
    late->cancel();
    promise.set_value(1);
  });
  CHECK(rclcpp::spin_until_future_complete(node->get_node_base_interface(), future, 1s) ==
        rclcpp::FutureReturnCode::SUCCESS);
  CHECK(rclcpp::executors::spin_node_until_future_complete(executor, node, future, 1s) ==
        rclcpp::FutureReturnCode::SUCCESS);

  // A group that an executor is given by itself.
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  int in_group = 0;
  auto grouped = node->create_wall_timer(
      1ms, [&] { ++in_group; }, group);
  rclcpp::executors::SingleThreadedExecutor of_group;
  of_group.add_callback_group(group, node->get_node_base_interface());
  CHECK(of_group.get_manually_added_callback_groups().size() == 1);
  CHECK_THROWS(std::runtime_error,
               executor.add_callback_group(group, node->get_node_base_interface()));
  rclcpp::sleep_for(2ms);
  executor.spin_node_some(node);
  CHECK(in_group == 0);
  of_group.spin_once(1s);
  CHECK(in_group == 1);
  of_group.remove_callback_group(group);
  CHECK(of_group.get_all_callback_groups().empty());
}

void check_graph(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("graph_forms");
  auto event = node->get_graph_event();
  node->wait_for_graph_change(event, 2ms);
  event->check_and_clear();
  auto publisher = node->create_publisher<String>("graph_topic", 10);
  node->wait_for_graph_change(event, 1s);
  CHECK(event->check_and_clear());
  CHECK(node->count_publishers("graph_topic") == 1);

  String found;
  CHECK(!rclcpp::wait_for_message(found, node, "/latched_word", 2ms));
  auto latched = node->create_publisher<String>("latched_word", rclcpp::QoS(1).transient_local());
  String word;
  word.data = "latched";
  latched->publish(word);
  CHECK(
      rclcpp::wait_for_message(found, node, "/latched_word", 1s, rclcpp::QoS(1).transient_local()));
  CHECK(found.data == "latched");
}

void check_messages(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("message_forms",
                                             rclcpp::NodeOptions().use_intra_process_comms(true));
  std::string heard;
  rclcpp::SubscriptionOptions options;
  options.intra_process_buffer_type = rclcpp::IntraProcessBufferType::SharedPtr;
  auto shared = node->create_subscription<String>(
      "buffered", 10, [&](String::ConstSharedPtr message) { heard += message->data; }, options);
  options.intra_process_buffer_type = rclcpp::IntraProcessBufferType::UniquePtr;
  auto unique = node->create_subscription<String>(
      "buffered", 10, [&](String::UniquePtr message) { heard += message->data; }, options);
  auto buffered = node->create_publisher<String>("buffered", 10);
  auto message = std::make_unique<String>();
  message->data = "b";
  buffered->publish(std::move(message));
  rclcpp::spin_all(node, 1s);
  CHECK(heard == "bb");

  // A message that the publisher lends.
  auto plain = std::make_shared<rclcpp::Node>("loan_forms");
  int32_t number = 0;
  auto numbers =
      plain->create_subscription<Int32>("loaned", 10, [&](const Int32& one) { number = one.data; });
  auto lender = plain->create_publisher<Int32>("loaned", 10);
  CHECK(!lender->can_loan_messages());
  auto loaned = lender->borrow_loaned_message();
  CHECK(loaned.is_valid());
  loaned.get().data = 7;
  lender->publish(std::move(loaned));
  rclcpp::spin_all(plain, 1s);
  CHECK(number == 7);

  // A type of the user's own in place of a message.
  using Adapted = rclcpp::TypeAdapter<std::string, String>;
  std::string custom;
  std::string plain_text;
  auto adapted = plain->create_subscription<Adapted>(
      "adapted", 10, [&](const std::string& text) { custom = text; });
  auto unadapted = plain->create_subscription<String>(
      "adapted", 10, [&](const String& one) { plain_text = one.data; });
  auto speaker = plain->create_publisher<Adapted>("adapted", 10);
  speaker->publish(std::string("own type"));
  rclcpp::spin_all(plain, 1s);
  CHECK(custom == "own type");
  CHECK(plain_text == "own type");

  // QoS from parameters, with a check of it.
  rclcpp::NodeOptions overrides;
  overrides.parameter_overrides({{"qos_overrides./tuned.publisher.depth", 3}});
  auto tuned_node = std::make_shared<rclcpp::Node>("tuned", overrides);
  rclcpp::PublisherOptions tuned_options;
  tuned_options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  auto tuned = tuned_node->create_publisher<String>("/tuned", 10, tuned_options);
  CHECK(tuned->get_actual_qos().depth() == 3);
  CHECK(tuned_node->has_parameter("qos_overrides./tuned.publisher.reliability"));
  tuned_options.qos_overriding_options = rclcpp::QosOverridingOptions(
      {rclcpp::QosPolicyKind::Depth},
      [](const rclcpp::QoS&) {
        rclcpp::QosCallbackResult result;
        result.successful = false;
        result.reason = "never";
        return result;
      },
      "other");
  CHECK_THROWS(rclcpp::exceptions::InvalidQosOverridesException,
               tuned_node->create_publisher<String>("/tuned", 10, tuned_options));

  sensor_msgs::msg::Image image;
  const std::vector<uint8_t> pixels{1, 2, 3, 4, 5, 6};
  CHECK(sensor_msgs::fillImage(image, sensor_msgs::image_encodings::MONO8, 2, 3, 3, pixels.data()));
  CHECK(image.data == pixels && image.height == 2 && image.width == 3 && image.step == 3);
  sensor_msgs::clearImage(image);
  CHECK(image.data.empty());
}

void check_requests(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("request_forms");
  auto service = node->create_service<AddTwoInts>(
      "add", [](AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
        response->sum = request->a + request->b;
      });
  auto client = node->create_client<AddTwoInts>("add");
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 2;
  request->b = 5;
  int64_t first = 0;
  int64_t sum = 0;
  using WithRequest = rclcpp::Client<AddTwoInts>::SharedFutureWithRequest;
  auto future = client->async_send_request(request, [&](WithRequest done) {
    first = done.get().first->a;
    sum = done.get().second->sum;
  });
  CHECK(rclcpp::spin_until_future_complete(node, future.future, 1s) ==
        rclcpp::FutureReturnCode::SUCCESS);
  CHECK(first == 2 && sum == 7);
  auto lonely = node->create_client<AddTwoInts>("nobody");
  auto lost = lonely->async_send_request(request);
  auto gone = lonely->async_send_request(request);
  std::vector<int64_t> pruned;
  CHECK(lonely->prune_requests_older_than(std::chrono::system_clock::now() - 1h, &pruned) == 0);
  CHECK(lonely->remove_pending_request(lost));
  CHECK(lonely->prune_requests_older_than(std::chrono::system_clock::now() + 1s, &pruned) == 1);
  CHECK((pruned == std::vector<int64_t>{gone.request_id}));
  auto another = lonely->async_send_request(request);
  CHECK(lonely->prune_pending_requests() == 1);

  auto parameters = std::make_shared<rclcpp::AsyncParametersClient>(node);
  node->declare_parameter("speed", 1.5);
  CHECK(parameters->wait_for_service(1s));
  CHECK(parameters->service_is_ready());
  bool called = false;
  auto got = parameters->get_parameters(
      {"speed"}, [&](std::shared_future<std::vector<rclcpp::Parameter>>) { called = true; });
  CHECK(rclcpp::spin_until_future_complete(node, got, 1s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(got.get().at(0).as_double() == 1.5);
  CHECK(called);
  auto set = parameters->set_parameters({rclcpp::Parameter("speed", 2.0)});
  CHECK(rclcpp::spin_until_future_complete(node, set, 1s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(set.get().at(0).successful);
  auto types = parameters->get_parameter_types({"speed"});
  CHECK(rclcpp::spin_until_future_complete(node, types, 1s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(types.get().at(0) == rclcpp::PARAMETER_DOUBLE);

  auto told = std::make_shared<rcl_interfaces::msg::ParameterEvent>();
  told->new_parameters.push_back(rclcpp::Parameter("a", 1).to_parameter_msg());
  told->changed_parameters.push_back(rclcpp::Parameter("b", 2).to_parameter_msg());
  told->deleted_parameters.push_back(rclcpp::Parameter("c", 3).to_parameter_msg());
  using Filter = rclcpp::ParameterEventsFilter;
  const Filter filter(told, {"a", "b", "x"},
                      {Filter::EventType::CHANGED, Filter::EventType::DELETED});
  CHECK(filter.get_events().size() == 1);
  CHECK(filter.get_events().at(0).first == Filter::EventType::CHANGED);
  CHECK(filter.get_events().at(0).second->name == "b");
}

void check_contexts(Checks& checks) {
  auto context = std::make_shared<rclcpp::Context>();
  rclcpp::InitOptions options;
  CHECK(options.shutdown_on_signal);
  options.shutdown_on_signal = false;
  options.auto_initialize_logging(false).set_domain_id(3);
  context->init(0, nullptr, options);
  CHECK(context->get_domain_id() == 3);
  CHECK(!context->get_init_options().auto_initialize_logging());
  std::string order;
  auto removed = context->add_pre_shutdown_callback([&] { order += "never "; });
  context->add_pre_shutdown_callback([&] { order += context->is_valid() ? "pre " : "late "; });
  context->on_shutdown([&] { order += context->is_valid() ? "early" : "on"; });
  CHECK(context->remove_pre_shutdown_callback(removed));
  CHECK(!context->remove_pre_shutdown_callback(removed));
  CHECK(context->get_pre_shutdown_callbacks().size() == 1);
  CHECK(context->shutdown("done with it"));
  CHECK(order == "pre on");
  CHECK(context->shutdown_reason() == "done with it");
  CHECK(!context->is_valid());
  CHECK(rclcpp::ok());
}

/// The stamp of a message moves by a duration as it is.
void check_stamps(Checks& checks) {
  builtin_interfaces::msg::Time stamp;
  stamp.sec = 7;
  stamp.nanosec = 600'000'000;
  const builtin_interfaces::msg::Time later = stamp + rclcpp::Duration::from_seconds(0.5);
  CHECK(later.sec == 8 && later.nanosec == 100'000'000);
  CHECK((later - rclcpp::Duration::from_seconds(0.5)) == stamp);
  stamp.sec = -1;
  CHECK_THROWS(std::runtime_error, (void)(stamp + rclcpp::Duration(1, 0)));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::SigInt);
  Checks checks("forms");
  CHECK(rclcpp::signal_handlers_installed());
  CHECK(rclcpp::get_current_signal_handler_options() == rclcpp::SignalHandlerOptions::SigInt);
  CHECK(rclcpp::uninstall_signal_handlers());
  CHECK(!rclcpp::signal_handlers_installed());
  CHECK(rclcpp::install_signal_handlers());
  check_generic(checks);
  check_nodes(checks);
  check_graph(checks);
  check_messages(checks);
  check_requests(checks);
  check_contexts(checks);
  check_stamps(checks);
  return checks.finish();
}
