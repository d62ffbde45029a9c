// What `<service>/_service_event` tells of a call, for each state of the introspection of both
// sides.

// Compatibility, works: `configure_introspection` of services and clients:
// `<service>/_service_event` with the `_Event` type, off, metadata or contents; the page shows it

#include <algorithm>
#include <vector>

#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "ros2wasm_typesupport/cdr.hpp"

using example_interfaces::srv::AddTwoInts;
using namespace std::chrono_literals;

namespace {

constexpr char kTopic[] = "/observed_add/_service_event";
constexpr char kType[] = "example_interfaces/srv/AddTwoInts_Event";

struct Event {
  uint8_t type = 0;
  int32_t seconds = 0;
  uint32_t nanoseconds = 0;
  std::vector<uint8_t> client_gid = std::vector<uint8_t>(16);
  int64_t sequence_number = 0;
  /// a and b of each request, the sums of the responses.
  std::vector<int64_t> request;
  std::vector<int64_t> response;
};

Event read(const rclcpp::SerializedMessage& message, Checks& checks) {
  const auto& bytes = message.get_rcl_serialized_message();
  ros2wasm_typesupport::CdrReader reader(bytes.buffer, bytes.buffer_length);
  Event event;
  uint32_t count = 0;
  reader.get(event.type);
  reader.get(event.seconds);
  reader.get(event.nanoseconds);
  reader.get_bytes(event.client_gid.data(), 16, 1);
  reader.get(event.sequence_number);
  reader.get(count);
  event.request.resize(2 * count);
  for (int64_t& value : event.request) {
    reader.get(value);
  }
  reader.get(count);
  event.response.resize(count);
  for (int64_t& value : event.response) {
    reader.get(value);
  }
  CHECK(reader.ok());
  CHECK(reader.take(1, 1) == nullptr);
  return event;
}

}  // namespace

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
  auto subscription = watcher->create_generic_subscription(
      kTopic, kType, rclcpp::QoS(100), [&](std::shared_ptr<rclcpp::SerializedMessage> message) {
        events.push_back(read(*message, checks));
      });
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
              [](const Event& left, const Event& right) { return left.type < right.type; });
  };

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
  CHECK(events[0].type == 1);  // REQUEST_RECEIVED
  CHECK((events[0].request == std::vector<int64_t>{40, 2}));
  CHECK(events[0].response.empty());
  CHECK(events[1].type == 2);  // RESPONSE_SENT
  CHECK(events[1].request.empty());
  CHECK((events[1].response == std::vector<int64_t>{42}));
  CHECK(events[0].sequence_number == events[1].sequence_number);
  CHECK(events[0].client_gid == events[1].client_gid);
  const int64_t stamp = events[0].seconds * 1'000'000'000LL + events[0].nanoseconds;
  CHECK(stamp >= before && stamp <= clock->now().nanoseconds());

  // Both sides; the client tells less.
  client->configure_introspection(client_node->get_clock(), qos,
                                  RCL_SERVICE_INTROSPECTION_METADATA);
  CHECK(watcher->count_publishers(kTopic) == 2);
  const int64_t last = events[0].sequence_number;
  call_and_hear(4);
  for (uint8_t type = 0; type < 4; ++type) {
    CHECK(events[type].type == type);
    CHECK(events[type].client_gid == events[0].client_gid);
    CHECK(events[type].sequence_number == last + 1);
  }
  CHECK(events[0].request.empty());
  CHECK(events[1].request.size() == 2);
  CHECK(events[2].response.size() == 1);
  CHECK(events[3].response.empty());

  // A change of state keeps the publisher; OFF ends it.
  client->configure_introspection(client_node->get_clock(), qos,
                                  RCL_SERVICE_INTROSPECTION_CONTENTS);
  call_and_hear(4);
  CHECK(events[0].request.size() == 2);
  CHECK((events[3].response == std::vector<int64_t>{42}));
  server->configure_introspection(clock, qos, RCL_SERVICE_INTROSPECTION_OFF);
  call_and_hear(2);
  CHECK(events[0].type == 0);
  CHECK(events[1].type == 3);
  client->configure_introspection(clock, qos, RCL_SERVICE_INTROSPECTION_OFF);
  CHECK(watcher->count_publishers(kTopic) == 0);
  return checks.finish();
}
