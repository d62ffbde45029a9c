// Every form of subscription callback, intra-process delivery, serialized messages, the graph.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/serialization.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> heard;

void free_function(const String& message) {
  heard.push_back("function " + message.data);
}

class Member : public rclcpp::Node {
 public:
  Member() : Node("member") {
    plain_ = create_subscription<String>("forms", 10,
                                         std::bind(&Member::on, this, std::placeholders::_1));
    with_info_ = create_subscription<String>(
        "forms", 10,
        std::bind(&Member::on_with_info, this, std::placeholders::_1, std::placeholders::_2));
  }

 private:
  void on(String::UniquePtr message) const { heard.push_back("member " + message->data); }
  void on_with_info(String::ConstSharedPtr message, const rclcpp::MessageInfo& info) const {
    heard.push_back("info " + message->data + " " +
                    std::to_string(info.get_rmw_message_info().publication_sequence_number));
  }
  rclcpp::Subscription<String>::SharedPtr plain_;
  rclcpp::Subscription<String>::SharedPtr with_info_;
};

bool has(const std::string& line) {
  return std::find(heard.begin(), heard.end(), line) != heard.end();
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("topics");
  auto node = std::make_shared<rclcpp::Node>("topics_node");
  auto member = std::make_shared<Member>();
  auto reference = node->create_subscription<String>("forms", 10, &free_function);
  auto shared = node->create_subscription<String>(
      "forms", 10, [](String::SharedPtr message) { heard.push_back("shared " + message->data); });
  auto constant = node->create_subscription<String>(
      "forms", 10,
      [](std::shared_ptr<const String> message) { heard.push_back("const " + message->data); });
  auto serialized = node->create_subscription<String>(
      "forms", 10, [](std::shared_ptr<const rclcpp::SerializedMessage> message) {
        String text;
        rclcpp::Serialization<String>().deserialize_message(message.get(), &text);
        heard.push_back("bytes " + text.data);
      });
  auto generic = node->create_generic_subscription(
      "forms", "std_msgs/msg/String", 10, [](std::shared_ptr<rclcpp::SerializedMessage> message) {
        heard.push_back("generic " + std::to_string(message->size()));
      });
  auto publisher = node->create_publisher<String>("forms", 10);
  CHECK(publisher->get_subscription_count() == 7);
  CHECK(node->count_subscribers("forms") == 7);
  CHECK(node->count_publishers("/forms") == 1);
  CHECK(node->get_topic_names_and_types().at("/forms").at(0) == "std_msgs/msg/String");
  CHECK(node->get_publishers_info_by_topic("/forms").at(0).node_name() == "topics_node");

  String message;
  message.data = "x";
  publisher->publish(message);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(member);
  executor.spin_all(2s);
  CHECK(heard.size() == 7);
  for (const char* line :
       {"function x", "member x", "info x 1", "shared x", "const x", "bytes x", "generic 10"}) {
    CHECK(has(line));
  }

  // By pointer: the listener gets the very object that was published.
  auto local =
      std::make_shared<rclcpp::Node>("local", rclcpp::NodeOptions().use_intra_process_comms(true));
  const void* received = nullptr;
  auto owner = local->create_subscription<String>(
      "local", 10, [&received](String::UniquePtr one) { received = one.get(); });
  auto sender = local->create_publisher<String>("local", 10);
  auto owned = std::make_unique<String>(message);
  const void* sent = owned.get();
  sender->publish(std::move(owned));
  executor.add_node(local);
  executor.spin_all(2s);
  CHECK(received == sent);
  CHECK(sender->get_intra_process_subscription_count() == 1);

  // A message of the user's own allocator goes back to it.
  using Allocator = std::allocator<String>;
  using Giver = rclcpp::allocator::AllocatorDeleter<Allocator>;
  static_assert(
      std::is_same_v<rclcpp::allocator::Deleter<Allocator, String>, std::default_delete<String>>);
  Allocator allocator;
  Giver giver;
  rclcpp::allocator::set_allocator_for_deleter(&giver, &allocator);
  CHECK_THROWS(std::invalid_argument,
               rclcpp::allocator::set_allocator_for_deleter<Allocator>(&giver, nullptr));
  using Traits = rclcpp::allocator::AllocRebind<String, Allocator>;
  String* place = Traits::allocate(allocator, 1);
  Traits::construct(allocator, place, message);
  publisher->publish(std::unique_ptr<String, Giver>(place, giver));
  heard.clear();
  executor.spin_all(2s);
  CHECK(heard.size() == 7);

  // Late joiners of a transient local topic.
  const auto latched = rclcpp::QoS(2).transient_local();
  auto early = node->create_publisher<String>("latched", latched);
  for (const char* text : {"1", "2", "3"}) {
    message.data = text;
    early->publish(message);
  }
  std::vector<std::string> late;
  auto late_subscription = node->create_subscription<String>(
      "latched", latched, [&late](const String& one) { late.push_back(one.data); });
  executor.spin_all(2s);
  CHECK((late == std::vector<std::string>{"2", "3"}));

  CHECK_THROWS(rclcpp::exceptions::InvalidTopicNameError, node->create_publisher<String>("a b", 1));
  CHECK_THROWS(std::runtime_error, executor.add_node(node));
  CHECK_THROWS(rclcpp::exceptions::RCLError, publisher->get_network_flow_endpoints());
  CHECK_THROWS(rclcpp::exceptions::InvalidNodeNameError, rclcpp::Node("bad name"));
  return checks.finish();
}
