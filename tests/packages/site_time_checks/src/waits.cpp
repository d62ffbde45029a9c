// Every way in which a program without threads waits for a time.
#include <time.h>
#include <unistd.h>

#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "waiting.hpp"

using std_msgs::msg::String;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waits");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);

  wait_by("sleep_for", [] { std::this_thread::sleep_for(kWhile); });
  wait_by("sleep_until",
          [] { std::this_thread::sleep_until(std::chrono::system_clock::now() + kWhile); });
  wait_by("usleep", [] { usleep(100000); });
  wait_by("nanosleep", [] {
    const timespec duration{0, 100000000};
    nanosleep(&duration, nullptr);
  });
  wait_by("rclcpp::sleep_for", [] { rclcpp::sleep_for(kWhile); });
  wait_by("Clock::sleep_for", [&] { node->get_clock()->sleep_for(kWhile); });
  wait_by("Rate", [] {
    rclcpp::Rate rate(kWhile);
    rate.sleep();
  });
  wait_by("condition_variable", [] {
    std::mutex mutex;
    std::condition_variable condition;
    std::unique_lock<std::mutex> lock(mutex);
    condition.wait_for(lock, kWhile, [] { return false; });
  });
  wait_by("future", [] {
    std::promise<int> promise;
    promise.get_future().wait_for(kWhile);
  });
  wait_by("wall timer", [&] {
    bool fired = false;
    auto timer = node->create_wall_timer(kWhile, [&] { fired = true; });
    while (!fired) {
      executor.spin_once();
    }
  });
  wait_by("ROS timer", [&] {
    bool fired = false;
    auto timer = node->create_timer(kWhile, [&] { fired = true; });
    while (!fired) {
      executor.spin_once();
    }
  });
  wait_by("spin_until_future_complete", [&] {
    std::promise<int> promise;
    executor.spin_until_future_complete(promise.get_future(), kWhile);
  });
  wait_by("wait_for_service", [&] {
    auto client = node->create_client<rcl_interfaces::srv::ListParameters>("nobody");
    client->wait_for_service(kWhile);
  });
  wait_by("deadline", [&] {
    bool missed = false;
    rclcpp::PublisherOptions options;
    options.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineOfferedInfo&) {
      missed = true;
    };
    auto publisher =
        node->create_publisher<String>("deadline", rclcpp::QoS(1).deadline(kWhile), options);
    publisher->publish(String());
    while (!missed) {
      executor.spin_once();
    }
  });
  wait_by("lifespan", [&] {
    const auto qos = rclcpp::QoS(1).lifespan(std::chrono::milliseconds(60));
    auto publisher = node->create_publisher<String>("lifespan", qos);
    auto subscription = node->create_subscription<String>("lifespan", qos, [](const String&) {});
    String message;
    rclcpp::MessageInfo info;
    const auto begin = std::chrono::steady_clock::now();
    publisher->publish(message);
    std::this_thread::sleep_until(begin + kWhile / 5);
    if (!subscription->take(message, info)) {
      std::puts("lifespan is over before its time");
    }
    publisher->publish(message);
    std::this_thread::sleep_until(begin + kWhile);
    if (subscription->take(message, info)) {
      std::puts("lifespan is not over in time");
    }
  });

  rclcpp::shutdown();
  return 0;
}
