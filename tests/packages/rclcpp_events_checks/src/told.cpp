// Callbacks that are told of what came: messages, requests, responses, events, resets.

// Compatibility, works: callbacks that are told of what came: `set_on_new_message_callback`,
// `set_on_new_request_callback`, `set_on_new_response_callback`, `set_on_new_qos_event_callback`,
// `set_on_ready_callback` of events, `set_on_new_intra_process_message_callback`,
// `set_on_reset_callback` of timers
//
// Compatibility, differs: who calls those callbacks -> no thread of the middleware does: whoever
// waits next in the process (an executor, a wait set, `rclcpp::sleep_for`, a rate,
// `wait_for_service`), so a program that only waits for a condition variable is not told

#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "std_msgs/msg/string.hpp"

using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

// Whether it comes to hold: on a busy machine what comes takes its time.
template <typename Condition>
bool comes(const Condition& condition) {
  for (int i = 0; i < 10000; ++i) {
    if (condition()) return true;
    rclcpp::sleep_for(1ms);
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("told");
  auto node = std::make_shared<rclcpp::Node>("told_node");
  auto other = std::make_shared<rclcpp::Node>("told_other");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  String message;
  message.data = "x";

  // Of messages from the bus: those that lie there at once, others when someone waits.
  std::vector<std::string> heard;
  auto subscription = node->create_subscription<String>(
      "bell", 3, [&](const String& one) { heard.push_back(one.data); });
  auto publisher = other->create_publisher<String>("bell", 10);
  size_t told = 0;
  publisher->publish(message);
  publisher->publish(message);
  CHECK_THROWS(std::invalid_argument, subscription->set_on_new_message_callback(nullptr));
  subscription->set_on_new_message_callback([&](size_t count) { told += count; });
  CHECK(told == 2);
  publisher->publish(message);
  CHECK(heard.empty());
  CHECK(comes([&] { return told == 3; }));
  CHECK(heard.empty());
  executor.spin_some();
  executor.spin_some();
  executor.spin_some();
  CHECK(heard.size() == 3);
  CHECK(told == 3);
  // An executor that finds it tells first; the history keeps three.
  for (const char* text : {"1", "2", "3", "4", "5"}) {
    message.data = text;
    publisher->publish(message);
  }
  heard.clear();
  executor.spin_all(1s);
  CHECK(told > 3 && told <= 8);
  CHECK((heard == std::vector<std::string>{"3", "4", "5"}));
  // What throws is logged, and the message stays.
  subscription->set_on_new_message_callback([](size_t) { throw std::runtime_error("no"); });
  publisher->publish(message);
  rclcpp::sleep_for(1ms);
  String taken;
  rclcpp::MessageInfo info;
  CHECK(comes([&] { return subscription->take(taken, info); }));
  CHECK(taken.data == "5");
  CHECK(!subscription->take(taken, info));
  subscription->clear_on_new_message_callback();
  told = 0;
  publisher->publish(message);
  rclcpp::sleep_for(1ms);
  CHECK(comes([&] { return subscription->take(taken, info); }));
  CHECK(told == 0);

  // A wait set tells too, and has the message to take.
  size_t in_wait = 0;
  subscription->set_on_new_message_callback([&](size_t count) { in_wait += count; });
  publisher->publish(message);
  {
    rclcpp::WaitSet wait_set({{{subscription}}});
    CHECK(wait_set.wait(10s).kind() == rclcpp::WaitResultKind::Ready);
  }
  CHECK(in_wait == 1);
  CHECK(subscription->take(taken, info));
  subscription->clear_on_new_message_callback();

  // By pointer: of its own callback only.
  auto local = std::make_shared<rclcpp::Node>("told_local",
                                              rclcpp::NodeOptions().use_intra_process_comms(true));
  auto by_pointer = local->create_subscription<String>("local", 10, [](String::UniquePtr) {});
  auto sender = local->create_publisher<String>("local", 10);
  size_t from_bus = 0;
  size_t from_here = 0;
  by_pointer->set_on_new_message_callback([&](size_t count) { from_bus += count; });
  sender->publish(message);
  by_pointer->set_on_new_intra_process_message_callback([&](size_t count) { from_here += count; });
  CHECK(from_here == 1);
  sender->publish(message);
  CHECK(comes([&] { return from_here == 2; }));
  CHECK(from_bus == 0);
  by_pointer->clear_on_new_intra_process_message_callback();
  sender->publish(message);
  CHECK(from_here == 2);

  // Of requests and responses.
  auto service = node->create_service<AddTwoInts>(
      "add",
      [](const AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
        response->sum = request->a + request->b;
      });
  auto client = node->create_client<AddTwoInts>("add");
  size_t requests = 0;
  size_t responses = 0;
  service->set_on_new_request_callback([&](size_t count) { requests += count; });
  client->set_on_new_response_callback([&](size_t count) { responses += count; });
  CHECK(client->wait_for_service(10s));
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 2;
  request->b = 3;
  auto future = client->async_send_request(request);
  CHECK(comes([&] { return requests == 1; }));
  CHECK(executor.spin_until_future_complete(future, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(future.get()->sum == 5);
  CHECK(responses == 1);
  service->clear_on_new_request_callback();
  client->clear_on_new_response_callback();
  future = client->async_send_request(request);
  CHECK(executor.spin_until_future_complete(future, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(requests == 1);
  CHECK(responses == 1);

  // Of events, for which there must be a handler.
  rclcpp::SubscriptionOptions options;
  int matched_callbacks = 0;
  options.event_callbacks.matched_callback = [&](rclcpp::MatchedInfo&) { ++matched_callbacks; };
  rclcpp::PublisherOptions publisher_options;
  publisher_options.event_callbacks.matched_callback = [](rclcpp::MatchedInfo&) {};
  auto pub = other->create_publisher<String>("events", 10, publisher_options);
  size_t publisher_events = 0;
  pub->set_on_new_qos_event_callback([&](size_t count) { publisher_events += count; },
                                     RCL_PUBLISHER_MATCHED);
  auto sub = node->create_subscription<String>(
      "events", 10, [](const String&) {}, options);
  size_t subscription_events = 0;
  sub->set_on_new_qos_event_callback([&](size_t count) { subscription_events += count; },
                                     RCL_SUBSCRIPTION_MATCHED);
  CHECK(sub->get_event_handlers().count(RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED) == 0);
  sub->set_on_new_qos_event_callback([](size_t) {}, RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED);
  CHECK(comes([&] { return publisher_events > 0 && subscription_events > 0; }));
  CHECK(publisher_events == 1);
  CHECK(subscription_events == 1);
  executor.spin_all(1s);
  CHECK(matched_callbacks == 1);
  sub->clear_on_new_qos_event_callback(RCL_SUBSCRIPTION_MATCHED);
  pub.reset();
  executor.spin_all(1s);
  CHECK(subscription_events == 1);
  const auto handler = sub->get_event_handlers().at(RCL_SUBSCRIPTION_MATCHED);
  size_t ready = 0;
  int kind = -1;
  handler->set_on_ready_callback([&](size_t count, int entity) {
    ready += count;
    kind = entity;
  });
  pub = other->create_publisher<String>("events", 10, publisher_options);
  CHECK(comes([&] { return ready >= 1; }));
  CHECK(kind == static_cast<int>(rclcpp::EventHandlerBase::EntityType::Event));
  handler->clear_on_ready_callback();

  // Of resets, those before too.
  auto timer = node->create_wall_timer(1h, [] {});
  timer->reset();
  size_t resets = 0;
  timer->set_on_reset_callback([&](size_t count) { resets += count; });
  CHECK(resets == 1);
  timer->reset();
  CHECK(resets == 2);
  timer->clear_on_reset_callback();
  timer->reset();
  CHECK(resets == 2);
  return checks.finish();
}
