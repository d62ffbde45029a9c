// What `<service>/_service_event` tells of a call, for each state of the introspection of both
// sides.

// Compatibility, works: `configure_introspection` of services and clients:
// `<service>/_service_event` with the `_Event` type, off, metadata or contents; the page shows it

// Compatibility, works: the type `Service::Event` of every service, of actions' services too, with
// traits, builder, type support and hash: `create_subscription<AddTwoInts::Event>(...)`

#include <algorithm>
#include <vector>

#include "checks.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/serialization.hpp"
#include "service_msgs/msg/service_event_info.hpp"

using example_interfaces::srv::AddTwoInts;
using namespace std::chrono_literals;

namespace {

constexpr char kTopic[] = "/observed_add/_service_event";
constexpr char kType[] = "example_interfaces/srv/AddTwoInts_Event";
using Event = AddTwoInts::Event;
using Info = service_msgs::msg::ServiceEventInfo;
using Goals = example_interfaces::action::Fibonacci::Impl::SendGoalService;

/// What each event says of its type.
uint8_t type_of(const Event& event) {
  return event.info.event_type;
}

}  // namespace

// An event is a message as any other.
void check_type(Checks& checks, const rclcpp::Node::SharedPtr& node) {
  namespace traits = rosidl_generator_traits;
  CHECK(std::string(traits::name<Event>()) == kType);
  CHECK(std::string(traits::data_type<Event>()) == "example_interfaces::srv::AddTwoInts_Event");
  CHECK(traits::is_message<Event>::value && !traits::is_service<Event>::value);
  CHECK(!traits::has_fixed_size<Event>::value && traits::has_bounded_size<Event>::value);
  Event event = example_interfaces::build<Event>().info(Info()).request({}).response({});
  event.info.event_type = Info::RESPONSE_SENT;
  event.request.resize(1);
  event.request[0].a = -3;
  CHECK(example_interfaces::srv::to_yaml(event, true).find("request: [{a: -3, b: 0}]") !=
        std::string::npos);
  bool is_bounded = false;
  try {
    event.request.resize(2);
  } catch (const std::length_error&) {
    is_bounded = true;
  }
  CHECK(is_bounded);

  const rclcpp::Serialization<Event> serialization;
  rclcpp::SerializedMessage bytes;
  serialization.serialize_message(&event, &bytes);
  CHECK(bytes.size() == 4 + 40 + 8 + 16 + 4);  // header, info, count and request, count
  Event read;
  serialization.deserialize_message(&bytes, &read);
  CHECK(read == event);

  // Those of an action's services.
  auto goals = node->create_publisher<Goals::Event>("goals", 1);
  CHECK(node->get_publishers_info_by_topic("goals").at(0).topic_type() ==
        "example_interfaces/action/Fibonacci_SendGoal_Event");
  Goals::Event goal;
  goal.request.resize(1);
  goal.request[0].goal.order = 5;
  goals->publish(goal);
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("introspection");
  auto server_node = std::make_shared<rclcpp::Node>("adder");
  auto client_node = std::make_shared<rclcpp::Node>("asker");
  auto watcher = std::make_shared<rclcpp::Node>("watcher");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(server_node);
  executor.add_node(client_node);
  executor.add_node(watcher);
  auto server = server_node->create_service<AddTwoInts>(
      "observed_add", [](const std::shared_ptr<AddTwoInts::Request> request,
                         std::shared_ptr<AddTwoInts::Response> response) {
        response->sum = request->a + request->b;
      });
  auto client = client_node->create_client<AddTwoInts>("observed_add");
  client->wait_for_service();

  std::vector<Event> events;
  auto subscription = watcher->create_subscription<Event>(
      kTopic, rclcpp::QoS(100), [&](const Event& event) { events.push_back(event); });
  CHECK(watcher->get_subscriptions_info_by_topic(kTopic).at(0).topic_type() == kType);
  const auto call = [&] {
    auto request = std::make_shared<AddTwoInts::Request>();
    request->a = 40;
    request->b = 2;
    auto answer = client->async_send_request(request);
    CHECK(executor.spin_until_future_complete(answer) == rclcpp::FutureReturnCode::SUCCESS);
    CHECK(answer.get()->sum == 42);
  };
  const auto call_and_hear = [&](size_t count) {
    events.clear();
    call();
    while (events.size() < count) {
      executor.spin_once();
    }
    executor.spin_some();
    CHECK(events.size() == count);
    std::sort(events.begin(), events.end(),
              [](const Event& left, const Event& right) { return type_of(left) < type_of(right); });
  };

  check_type(checks, watcher);

  // Nobody tells anything at first.
  CHECK(watcher->count_publishers(kTopic) == 0);
  call();

  const auto clock = server_node->get_clock();
  const rclcpp::QoS qos = rclcpp::QoS(7).reliable();
  server->configure_introspection(clock, qos, RCL_SERVICE_INTROSPECTION_CONTENTS);
  const auto publishers = watcher->get_publishers_info_by_topic(kTopic);
  CHECK(publishers.size() == 1);
  CHECK(publishers[0].node_name() == "adder");
  CHECK(publishers[0].topic_type() == kType);
  CHECK(publishers[0].qos_profile().depth() == 7);
  const int64_t before = clock->now().nanoseconds();
  call_and_hear(2);
  CHECK(type_of(events[0]) == Info::REQUEST_RECEIVED);
  CHECK(events[0].request.size() == 1 && events[0].request[0].a == 40 &&
        events[0].request[0].b == 2);
  CHECK(events[0].response.empty());
  CHECK(type_of(events[1]) == Info::RESPONSE_SENT);
  CHECK(events[1].request.empty());
  CHECK(events[1].response.size() == 1 && events[1].response[0].sum == 42);
  CHECK(events[0].info.sequence_number == events[1].info.sequence_number);
  CHECK(events[0].info.client_gid == events[1].info.client_gid);
  const int64_t stamp = rclcpp::Time(events[0].info.stamp).nanoseconds();
  CHECK(stamp >= before && stamp <= clock->now().nanoseconds());

  // Both sides; the client tells less.
  client->configure_introspection(client_node->get_clock(), qos,
                                  RCL_SERVICE_INTROSPECTION_METADATA);
  CHECK(watcher->count_publishers(kTopic) == 2);
  const int64_t last = events[0].info.sequence_number;
  call_and_hear(4);
  for (uint8_t type = 0; type < 4; ++type) {
    CHECK(type_of(events[type]) == type);
    CHECK(events[type].info.client_gid == events[0].info.client_gid);
    CHECK(events[type].info.sequence_number == last + 1);
  }
  CHECK(events[0].request.empty());
  CHECK(events[1].request.size() == 1);
  CHECK(events[2].response.size() == 1);
  CHECK(events[3].response.empty());

  // A change of state keeps the publisher; OFF ends it.
  client->configure_introspection(client_node->get_clock(), qos,
                                  RCL_SERVICE_INTROSPECTION_CONTENTS);
  call_and_hear(4);
  CHECK(events[0].request.size() == 1);
  CHECK(events[3].response.at(0).sum == 42);
  server->configure_introspection(clock, qos, RCL_SERVICE_INTROSPECTION_OFF);
  call_and_hear(2);
  CHECK(type_of(events[0]) == Info::REQUEST_SENT);
  CHECK(type_of(events[1]) == Info::RESPONSE_RECEIVED);
  client->configure_introspection(clock, qos, RCL_SERVICE_INTROSPECTION_OFF);
  CHECK(watcher->count_publishers(kTopic) == 0);
  return checks.finish();
}
