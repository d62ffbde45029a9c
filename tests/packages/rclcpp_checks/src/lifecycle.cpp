// Managed nodes from inside: their graph of transitions, callbacks of every outcome, and publishers
// that are mute while inactive.

// Compatibility, works: managed nodes of rclcpp_lifecycle: the states, transitions, numbers and
// labels of ROS 2, callbacks that fail, throw or err, the five services and `~/transition_event`,
// publishers that are mute while inactive

#include "checks.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "lifecycle_msgs/msg/transition_event.hpp"
#include "rcl_interfaces/msg/log.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/type_traits/is_manageable_node.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using lifecycle_msgs::msg::State;
using lifecycle_msgs::msg::Transition;
using rclcpp_lifecycle::LifecycleNode;
using CallbackReturn = LifecycleNode::CallbackReturn;
using Labels = std::vector<std::string>;
using std_msgs::msg::String;

namespace {

// Its callbacks do what it is told, and it notes which were called.
class Obedient : public LifecycleNode {
 public:
  using LifecycleNode::LifecycleNode;
  CallbackReturn on_configure(const rclcpp_lifecycle::State& from) override {
    return note("configure", from);
  }
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State& from) override {
    return note("cleanup", from);
  }
  CallbackReturn on_shutdown(const rclcpp_lifecycle::State& from) override {
    return note("shutdown", from);
  }
  CallbackReturn on_error(const rclcpp_lifecycle::State& from) override {
    called.push_back("error from " + from.label());
    return when_error;
  }

  CallbackReturn next = CallbackReturn::SUCCESS;
  CallbackReturn when_error = CallbackReturn::SUCCESS;
  bool throws = false;
  Labels called;

 private:
  CallbackReturn note(const std::string& name, const rclcpp_lifecycle::State& from) {
    called.push_back(name + " from " + from.label());
    if (throws) {
      throw std::runtime_error("told to");
    }
    return next;
  }
};

template <typename ListT>
Labels labels_of(const ListT& list) {
  Labels labels;
  for (const auto& one : list) {
    labels.push_back(one.label());
  }
  return labels;
}

void check_values(Checks& checks) {
  const rclcpp_lifecycle::State state(7, "seventh");
  CHECK(state.id() == 7);
  CHECK(state.label() == "seventh");
  CHECK(rclcpp_lifecycle::State().id() == State::PRIMARY_STATE_UNKNOWN);
  CHECK(rclcpp_lifecycle::State().label() == "unknown");
  CHECK_THROWS(std::runtime_error, rclcpp_lifecycle::State(7, ""));
  const rclcpp_lifecycle::Transition bare(9);
  CHECK(bare.id() == 9);
  CHECK(bare.label().empty());
  CHECK_THROWS(std::runtime_error, bare.start_state());
  const rclcpp_lifecycle::Transition whole(9, "leap", rclcpp_lifecycle::State(1, "here"),
                                           rclcpp_lifecycle::State(2, "there"));
  CHECK(whole.start_state().label() == "here");
  CHECK(whole.goal_state().id() == 2);
  CHECK(is_manageable_node<rclcpp_lifecycle::SimpleManagedEntity>::value);
  CHECK(!is_manageable_node<rclcpp::Node>::value);
}

void check_graph(Checks& checks, Obedient& node) {
  CHECK((labels_of(node.get_available_states()) ==
         Labels{"unknown", "unconfigured", "inactive", "active", "finalized", "configuring",
                "cleaningup", "shuttingdown", "activating", "deactivating", "errorprocessing"}));
  CHECK((labels_of(node.get_available_transitions()) == Labels{"configure", "shutdown"}));
  const auto graph = node.get_transition_graph();
  CHECK(graph.size() == 25);
  CHECK(graph[0].id() == Transition::TRANSITION_CONFIGURE);
  CHECK(graph[0].start_state().label() == "unconfigured");
  CHECK(graph[0].goal_state().label() == "configuring");
  CHECK(graph[24].label() == "transition_error");
  CHECK(graph[24].goal_state().id() == State::PRIMARY_STATE_FINALIZED);
}

// Each outcome of a callback leads where ROS 2 says.
void check_outcomes(Checks& checks, Obedient& node) {
  CallbackReturn result = CallbackReturn::SUCCESS;
  CHECK(node.activate().id() == State::PRIMARY_STATE_UNCONFIGURED);
  CHECK(node.called.empty());
  CHECK(node.activate(result).id() == State::PRIMARY_STATE_UNCONFIGURED);
  CHECK(result == CallbackReturn::SUCCESS);

  node.next = CallbackReturn::FAILURE;
  CHECK(node.configure(result).label() == "unconfigured");
  CHECK(result == CallbackReturn::FAILURE);
  node.next = CallbackReturn::ERROR;
  CHECK(node.configure(result).label() == "unconfigured");
  CHECK(result == CallbackReturn::ERROR);
  node.next = CallbackReturn::SUCCESS;
  node.throws = true;
  CHECK(node.configure(result).label() == "unconfigured");
  CHECK(result == CallbackReturn::ERROR);
  node.throws = false;
  CHECK((node.called == Labels{"configure from unconfigured", "configure from unconfigured",
                               "error from unconfigured", "configure from unconfigured",
                               "error from unconfigured"}));

  CHECK(node.configure(result).label() == "inactive");
  CHECK(result == CallbackReturn::SUCCESS);
  CHECK((labels_of(node.get_available_transitions()) == Labels{"cleanup", "activate", "shutdown"}));
  node.next = CallbackReturn::FAILURE;
  CHECK(node.cleanup().label() == "inactive");
  node.next = CallbackReturn::SUCCESS;
  CHECK(node.trigger_transition(Transition::TRANSITION_CLEANUP).label() == "unconfigured");
  node.configure();
  CHECK(node.trigger_transition(rclcpp_lifecycle::Transition(Transition::TRANSITION_ACTIVATE))
            .label() == "active");
  CHECK((labels_of(node.get_available_transitions()) == Labels{"deactivate", "shutdown"}));

  // A failed shutdown ends all the same, an error that is not handled too.
  node.next = CallbackReturn::FAILURE;
  CHECK(node.shutdown(result).label() == "finalized");
  CHECK(result == CallbackReturn::FAILURE);
  CHECK(node.called.back() == "shutdown from active");
  CHECK(node.get_available_transitions().empty());
  CHECK(node.configure().label() == "finalized");
  Obedient broken("broken", rclcpp::NodeOptions(), false);
  broken.next = CallbackReturn::ERROR;
  broken.when_error = CallbackReturn::FAILURE;
  CHECK(broken.configure().label() == "finalized");

  int calls = 0;
  LifecycleNode plain("plain");
  CHECK(plain.register_on_configure([&calls](const rclcpp_lifecycle::State&) {
    ++calls;
    return CallbackReturn::SUCCESS;
  }));
  CHECK(plain.configure().label() == "inactive");
  CHECK(calls == 1);
}

void check_publisher(Checks& checks) {
  auto node = std::make_shared<LifecycleNode>("mute");
  auto listener = std::make_shared<rclcpp::Node>("mute_listener");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node->get_node_base_interface());
  executor.add_node(listener);
  Labels heard;
  Labels steps;
  auto data = listener->create_subscription<String>(
      "words", 10, [&](const String& message) { heard.push_back(message.data); });
  auto events = listener->create_subscription<lifecycle_msgs::msg::TransitionEvent>(
      "/mute/transition_event", 10, [&](const lifecycle_msgs::msg::TransitionEvent& event) {
        steps.push_back(event.start_state.label + " > " + event.goal_state.label);
      });
  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<String>> publisher =
      node->create_publisher<String>("words", 10);
  const auto say = [&](const std::string& text) {
    String message;
    message.data = text;
    publisher->publish(message);
    publisher->publish(std::make_unique<String>(message));
  };
  CHECK(!publisher->is_activated());
  say("before");
  node->configure();
  say("configured");
  node->activate();
  CHECK(publisher->is_activated());
  say("active");
  node->deactivate();
  CHECK(!publisher->is_activated());
  say("after");
  publisher->on_activate();
  say("by hand");
  while (heard.size() < 4 || steps.size() < 6) {
    executor.spin_once();
  }
  CHECK((heard == Labels{"active", "active", "by hand", "by hand"}));
  CHECK((steps == Labels{"unconfigured > configuring", "configuring > inactive",
                         "inactive > activating", "activating > active", "active > deactivating",
                         "deactivating > inactive"}));
}

// A publisher warns once between activations; each refusal is said in the words of ROS 2.
void check_words(Checks& checks) {
  Labels said;
  const auto handler = rcutils_logging_get_output_handler();
  static Labels* target = nullptr;
  target = &said;
  rcutils_logging_set_output_handler([](const rcutils_log_location_t*, int, const char* name,
                                        rcutils_time_point_value_t, const char* format,
                                        va_list* arguments) {
    char text[256];
    std::vsnprintf(text, sizeof(text), format, *arguments);
    target->push_back(std::string(name) + ": " + text);
  });
  LifecycleNode node("words_node");
  auto publisher = node.create_publisher<String>("unheard", 10);
  publisher->publish(String());
  publisher->publish(String());
  node.configure();
  node.activate();
  node.deactivate();
  publisher->publish(String());
  node.register_on_cleanup(
      [](const rclcpp_lifecycle::State&) -> CallbackReturn { throw std::runtime_error("no"); });
  node.cleanup();
  node.activate();
  rcutils_logging_set_output_handler(handler);
  const std::string mute =
      "LifecyclePublisher: Trying to publish message on the topic '/unheard', but the publisher is "
      "not activated";
  CHECK((said ==
         Labels{mute, mute, "words_node: Caught exception in callback for transition 11",
                "words_node: Original error: no",
                "words_node: Error occurred while doing error handling.",
                "rcl_lifecycle: No transition matching 3 found for current state unconfigured",
                "words_node: Unable to start transition 3 from current state unconfigured: "
                "Transition is not registered."}));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("lifecycle");
  check_values(checks);
  auto node = std::make_shared<Obedient>("obedient");
  CHECK(node->shared_from_this() == node);
  CHECK(node->declare_parameter("rate", 5) == 5);
  CHECK(node->get_parameter("rate").as_int() == 5);
  check_graph(checks, *node);
  check_outcomes(checks, *node);
  check_publisher(checks);
  check_words(checks);
  return checks.finish();
}
