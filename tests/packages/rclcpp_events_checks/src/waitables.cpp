// Waitables as users write them: around a guard condition, in the newer and in the older form.

// Compatibility, works: waitables of users around guard conditions, in executors and wait sets,
// with references or pointers; guard conditions and wait sets of the C library
// (`rcl_guard_condition_init`, `rcl_wait_set_add_guard_condition`)
//
// Compatibility, differs: what a waitable adds to a wait set -> guard conditions only are waited
// for; `rcl_wait`, subscriptions, timers and services of the C library are not there

#include <deque>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "checks.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/waitable.hpp"

using namespace std::chrono_literals;

namespace {

// Runs what other code hands it.
class WorkQueue : public rclcpp::Waitable {
 public:
  void add(int work) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      work_.push_back(work);
    }
    guard_.trigger();
  }
  size_t get_number_of_ready_guard_conditions() override { return 1; }
  void add_to_wait_set(rcl_wait_set_t& wait_set) override { guard_.add_to_wait_set(wait_set); }
  bool is_ready(const rcl_wait_set_t& wait_set) override {
    for (size_t i = 0; i < wait_set.size_of_guard_conditions; ++i) {
      const rcl_guard_condition_t* const one = wait_set.guard_conditions[i];
      if (one == &guard_.get_rcl_guard_condition()) {
        return true;
      }
    }
    return false;
  }
  std::shared_ptr<void> take_data() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto data = std::make_shared<int>(work_.front());
    work_.pop_front();
    if (!work_.empty()) {
      guard_.trigger();
    }
    return data;
  }
  std::shared_ptr<void> take_data_by_entity_id(size_t) override { return take_data(); }
  void execute(const std::shared_ptr<void>& data) override {
    sum += *std::static_pointer_cast<int>(data);
  }
  void set_on_ready_callback(std::function<void(size_t, int)> callback) override {
    guard_.set_on_trigger_callback([callback](size_t count) { callback(count, 7); });
  }
  void clear_on_ready_callback() override { guard_.set_on_trigger_callback(nullptr); }

  int sum = 0;

 private:
  rclcpp::GuardCondition guard_;
  std::mutex mutex_;
  std::deque<int> work_;
};

// With pointers, as waitables were, and a guard condition of the C library.
class Older : public rclcpp::Waitable {
 public:
  Older() {
    rcl_guard_condition_options_t options = rcl_guard_condition_get_default_options();
    if (rcl_guard_condition_init(
            &guard_, rclcpp::contexts::get_global_default_context()->get_rcl_context().get(),
            options) != RCL_RET_OK) {
      throw std::runtime_error("no guard condition");
    }
  }
  ~Older() override { static_cast<void>(rcl_guard_condition_fini(&guard_)); }
  bool trigger() { return rcl_trigger_guard_condition(&guard_) == RCL_RET_OK; }
  size_t get_number_of_ready_guard_conditions() override { return 1; }
  void add_to_wait_set(rcl_wait_set_t* wait_set) override {
    if (rcl_wait_set_add_guard_condition(wait_set, &guard_, &index_) != RCL_RET_OK) {
      throw std::runtime_error("no room");
    }
  }
  bool is_ready(rcl_wait_set_t* wait_set) override {
    return wait_set->guard_conditions[index_] == &guard_;
  }
  std::shared_ptr<void> take_data() override { return nullptr; }
  void execute(const std::shared_ptr<void>&) override { ++runs; }

  int runs = 0;

 private:
  rcl_guard_condition_t guard_ = rcl_get_zero_initialized_guard_condition();
  size_t index_ = 0;
};

// Asks for less room than it takes.
class Greedy : public WorkQueue {
 public:
  size_t get_number_of_ready_guard_conditions() override { return 0; }
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("waitables");
  auto node = std::make_shared<rclcpp::Node>("waitables_node");
  auto queue = std::make_shared<WorkQueue>();
  auto older = std::make_shared<Older>();
  node->get_node_waitables_interface()->add_waitable(queue, nullptr);
  node->get_node_waitables_interface()->add_waitable(older, nullptr);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_some();
  CHECK(queue->sum == 0);
  CHECK(older->runs == 0);
  queue->add(1);
  queue->add(20);
  queue->add(300);
  CHECK(older->trigger());
  executor.spin_all(1s);
  CHECK(queue->sum == 321);
  CHECK(older->runs == 1);
  executor.spin_all(100ms);
  CHECK(older->runs == 1);
  // It ends a rest.
  auto timer = node->create_wall_timer(2ms, [&] { queue->add(4000); });
  while (queue->sum < 4000) {
    executor.spin_once(1s);
  }
  timer->cancel();
  executor.spin_all(1s);

  size_t told = 0;
  int entity = 0;
  queue->set_on_ready_callback([&](size_t count, int id) {
    told += count;
    entity = id;
  });
  told = 0;
  queue->add(0);
  CHECK(told == 1);
  CHECK(entity == 7);
  queue->clear_on_ready_callback();
  executor.spin_all(1s);
  CHECK_THROWS(std::runtime_error, older->set_on_ready_callback([](size_t, int) {}));

  // In a wait set: ready once, and the wait set has its guard condition.
  auto alone = std::make_shared<WorkQueue>();
  rclcpp::WaitSet wait_set;
  wait_set.add_waitable(alone);
  CHECK(wait_set.wait(2ms).kind() == rclcpp::WaitResultKind::Timeout);
  alone->add(5);
  {
    auto result = wait_set.wait(10s);
    CHECK(result.kind() == rclcpp::WaitResultKind::Ready);
    CHECK(alone->is_ready(result.get_wait_set().get_rcl_wait_set()));
    auto ready = result.next_ready_waitable();
    CHECK(ready == alone);
    auto data = ready->take_data();
    ready->execute(data);
    CHECK(result.next_ready_waitable() == nullptr);
  }
  CHECK(alone->sum == 5);
  CHECK(wait_set.wait(2ms).kind() == rclcpp::WaitResultKind::Timeout);
  CHECK_THROWS(std::runtime_error, wait_set.add_waitable(alone));
  auto greedy = std::make_shared<Greedy>();
  rclcpp::WaitSet narrow;
  narrow.add_waitable(greedy);
  CHECK_THROWS(rclcpp::exceptions::RCLError, (void)narrow.wait(1ms));
  node->get_node_waitables_interface()->remove_waitable(queue, nullptr);
  queue->add(1);
  const int before = queue->sum;
  executor.spin_all(100ms);
  CHECK(queue->sum == before);
  return checks.finish();
}
