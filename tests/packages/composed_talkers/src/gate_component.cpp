// Two components of which one waits for the other within a callback: they come together only where
// callbacks of a container run at the same time.

// Compatibility, works: `component_container_mt` (with its parameter `thread_num`) and
// `component_container_isolated` (with `--use_multi_threaded_executor`), also in launch files

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace composed_talkers {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

std::mutex mutex;
std::condition_variable changed;
bool someone_waits = false;
bool is_open = false;

}  // namespace

/// Opens the gate, but only for someone who waits there already.
class Porter : public rclcpp::Node {
 public:
  explicit Porter(const rclcpp::NodeOptions& options)
      : Node("porter", options), timer_(create_wall_timer(10ms, [this] { open(); })) {}

 private:
  void open() {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!someone_waits || is_open) return;
    is_open = true;
    changed.notify_all();
    RCLCPP_INFO(get_logger(), "the gate is open");
  }

  rclcpp::TimerBase::SharedPtr timer_;
};

class Visitor : public rclcpp::Node {
 public:
  explicit Visitor(const rclcpp::NodeOptions& options)
      : Node("visitor", options), timer_(create_wall_timer(10ms, [this] { wait(); })) {}

 private:
  void wait() {
    timer_->cancel();
    std::unique_lock<std::mutex> lock(mutex);
    someone_waits = true;
    const bool opened =
        changed.wait_for(lock, declare_parameter("patience", 10) * 1s, [] { return is_open; });
    someone_waits = false;
    RCLCPP_INFO(get_logger(), opened ? "came in" : "waited in vain");
  }

  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace composed_talkers

RCLCPP_COMPONENTS_REGISTER_NODE(composed_talkers::Porter)
RCLCPP_COMPONENTS_REGISTER_NODE(composed_talkers::Visitor)
