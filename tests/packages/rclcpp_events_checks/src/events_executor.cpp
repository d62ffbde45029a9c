// The executor of events with its own queue and one of ours, and the static one.

// Compatibility, works: `EventsExecutor` with its own queue or one of the user's,
// `StaticSingleThreadedExecutor`, `GenericClient`
//
// Compatibility, differs: `EventsExecutor` -> looks for what is ready as the other executors do and
// puts it into the queue one by one, so the order is theirs; timers have no thread of their own
//
// Compatibility, differs: `GenericClient` -> nothing is loaded at run time, so the program must
// have made a client or a service of the type before; another type throws InvalidServiceTypeError

#include <memory>
#include <vector>

#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/experimental/executors/events_executor/events_executor.hpp"
#include "std_msgs/msg/int32.hpp"

using example_interfaces::srv::AddTwoInts;
using rclcpp::experimental::executors::EventsExecutor;
using rclcpp::experimental::executors::ExecutorEvent;
using rclcpp::experimental::executors::SimpleEventsQueue;
using std_msgs::msg::Int32;
using namespace std::chrono_literals;

namespace {

// Notes what passes.
class NotingQueue : public SimpleEventsQueue {
 public:
  explicit NotingQueue(std::vector<int>& seen) : seen_(seen) {}
  void enqueue(const ExecutorEvent& event) override {
    seen_.push_back(event.type);
    SimpleEventsQueue::enqueue(event);
  }

 private:
  std::vector<int>& seen_;
};

// A node with a timer, a subscription, a service and a client of it, which counts.
class Busy : public rclcpp::Node {
 public:
  explicit Busy(const std::string& name) : Node(name) {
    publisher = create_publisher<Int32>("~/count", 10);
    subscription = create_subscription<Int32>("~/count", 10, [this](const Int32&) { ++heard; });
    service = create_service<AddTwoInts>("~/add", [](const AddTwoInts::Request::SharedPtr request,
                                                     AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
    client = create_client<AddTwoInts>("~/add");
    timer = create_wall_timer(1ms, [this] {
      ++ticks;
      publisher->publish(Int32());
    });
  }
  rclcpp::Publisher<Int32>::SharedPtr publisher;
  rclcpp::Subscription<Int32>::SharedPtr subscription;
  rclcpp::Service<AddTwoInts>::SharedPtr service;
  rclcpp::Client<AddTwoInts>::SharedPtr client;
  rclcpp::TimerBase::SharedPtr timer;
  int heard = 0;
  int ticks = 0;
};

void check_executor(Checks& checks, rclcpp::Executor& executor, const std::string& name) {
  auto node = std::make_shared<Busy>(name);
  executor.add_node(node);
  CHECK_THROWS(std::runtime_error, executor.add_node(node));
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 40;
  request->b = 2;
  auto future = node->client->async_send_request(request);
  CHECK(executor.spin_until_future_complete(future, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(future.get()->sum == 42);
  auto stop = node->create_wall_timer(1ms, [&] {
    if (node->heard >= 3) {
      executor.cancel();
    }
  });
  executor.spin();
  CHECK(node->heard >= 3);
  CHECK(node->ticks >= node->heard);
  CHECK(!executor.is_spinning());
  stop->cancel();
  node->timer->cancel();
  executor.spin_all(1s);
  const int before = node->heard;
  node->publisher->publish(Int32());
  node->publisher->publish(Int32());
  executor.spin_some();
  CHECK(node->heard > before);
  executor.spin_all(1s);
  CHECK(node->heard == before + 2);
  // An entity that comes later is seen.
  int late = 0;
  auto subscription =
      node->create_subscription<Int32>("~/count", 10, [&](const Int32&) { ++late; });
  node->publisher->publish(Int32());
  executor.spin_all(1s);
  CHECK(late == 1);
  executor.remove_node(node);
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("events_executor");
  {
    EventsExecutor executor;
    check_executor(checks, executor, "plain_events");
  }
  std::vector<int> seen;
  {
    EventsExecutor executor(std::make_unique<NotingQueue>(seen), false, rclcpp::ExecutorOptions());
    check_executor(checks, executor, "noted_events");
  }
  using namespace rclcpp::experimental::executors;
  for (const int type : {CLIENT_EVENT, SUBSCRIPTION_EVENT, SERVICE_EVENT, TIMER_EVENT}) {
    CHECK(std::count(seen.begin(), seen.end(), type) > 0);
  }
  CHECK_THROWS(std::invalid_argument, EventsExecutor(nullptr));
  SimpleEventsQueue queue;
  ExecutorEvent event{&queue, nullptr, -1, TIMER_EVENT, 2};
  queue.enqueue(event);
  CHECK(queue.size() == 2);
  CHECK(queue.dequeue(event) && event.num_events == 1 && event.entity_key == &queue);
  CHECK(queue.dequeue(event, 0ns) && queue.empty());
  CHECK(!queue.dequeue(event, 1ms));
  {
    rclcpp::executors::StaticSingleThreadedExecutor executor;
    check_executor(checks, executor, "static_executor");
  }

  // A client that knows the type by name.
  auto node = std::make_shared<Busy>("generic");
  node->timer->cancel();
  auto client = node->create_generic_client("~/add", "example_interfaces/srv/AddTwoInts");
  CHECK(client->wait_for_service(10s));
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  AddTwoInts::Request request;
  request.a = 1;
  request.b = 2;
  auto future = client->async_send_request(&request);
  CHECK(executor.spin_until_future_complete(future, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(std::static_pointer_cast<AddTwoInts::Response>(future.get())->sum == 3);
  int64_t sum = 0;
  auto shared = client->async_send_request(&request, [&](rclcpp::GenericClient::SharedFuture done) {
    sum = static_cast<AddTwoInts::Response*>(done.get().get())->sum;
  });
  CHECK(executor.spin_until_future_complete(shared.future, 10s) ==
        rclcpp::FutureReturnCode::SUCCESS);
  CHECK(sum == 3);
  auto lost = client->async_send_request(&request);
  CHECK(client->remove_pending_request(lost));
  CHECK(!client->remove_pending_request(lost.request_id));
  auto old = client->async_send_request(&request);
  std::vector<int64_t> pruned;
  CHECK(client->prune_requests_older_than(std::chrono::system_clock::now() + 1s, &pruned) == 1);
  CHECK((pruned == std::vector<int64_t>{old.request_id}));
  CHECK(client->prune_pending_requests() == 0);
  CHECK_THROWS(rclcpp::exceptions::InvalidServiceTypeError,
               node->create_generic_client("~/add", "example_interfaces/srv/NoSuch"));
  return checks.finish();
}
