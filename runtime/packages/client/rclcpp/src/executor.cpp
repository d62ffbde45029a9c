// How executors wait and choose. One turn: read the wake token, look what is ready (timers,
// subscriptions, services, clients, waitables, in this order), else sleep until the token changes
// or a timer is due. No turn polls.
#include "rclcpp/executor.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "rclcpp/client.hpp"
#include "rclcpp/detail/background.hpp"
#include "rclcpp/detail/listeners.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace {

// A busy executor looks for statuses that time changes once in so many rounds.
constexpr unsigned kSparedRounds = 8;

using std::chrono::nanoseconds;

// Sets a flag for as long as it lives; throws when it is set already.
class SpinningFlag {
 public:
  SpinningFlag(std::atomic_bool& flag, const char* what) : flag_(flag) {
    if (flag_.exchange(true)) {
      throw std::runtime_error(std::string(what) + " called while already spinning");
    }
  }
  ~SpinningFlag() { flag_ = false; }

 private:
  std::atomic_bool& flag_;
};

// Counts this thread among those that look for work.
class Seeking {
 public:
  explicit Seeking(std::atomic<int>& seekers) : seekers_(seekers) { ++seekers_; }
  ~Seeking() { --seekers_; }

 private:
  std::atomic<int>& seekers_;
};

nanoseconds steady_now() {
  return nanoseconds(ros2wasm::steady_now_ns());
}

template <typename WeakT, typename SharedT>
bool is_same(const WeakT& weak, const SharedT& shared) {
  return !weak.owner_before(shared) && !shared.owner_before(weak);
}

}  // namespace

AnyExecutable::~AnyExecutable() {
  if (callback_group) {
    callback_group->can_be_taken_from() = true;
    if (seekers != nullptr && *seekers > 0) {
      ros2wasm::wake();
    }
  }
}

Executor::Executor(const rclcpp::ExecutorOptions& options) : context_(options.context) {
  shutdown_callback_ = context_->add_on_shutdown_callback([] { ros2wasm::wake(); });
}

Executor::~Executor() {
  for (NodeRecord& record : nodes_) {
    for (const auto& group : record.groups) {
      release_group(group);
    }
    if (const auto node = record.node.lock()) {
      node->get_associated_with_executor_atomic() = false;
    }
  }
  for (const auto& group : manual_groups_) {
    release_group(group);
  }
  context_->remove_on_shutdown_callback(shutdown_callback_);
}

void Executor::release_group(const rclcpp::CallbackGroup::WeakPtr& weak) {
  if (const auto group = weak.lock()) {
    group->get_associated_with_executor_atomic() = false;
  }
}

void Executor::add_callback_group(rclcpp::CallbackGroup::SharedPtr group_ptr,
                                  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr, bool) {
  if (group_ptr->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error("Callback group has already been added to an executor.");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  manual_groups_.push_back(group_ptr);
  detail::bump_entities_version();
}

void Executor::remove_callback_group(rclcpp::CallbackGroup::SharedPtr group_ptr, bool) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(manual_groups_.begin(), manual_groups_.end(),
                                  [&](const auto& weak) { return is_same(weak, group_ptr); });
  if (found == manual_groups_.end()) {
    throw std::runtime_error("Callback group needs to be associated with executor.");
  }
  manual_groups_.erase(found);
  group_ptr->get_associated_with_executor_atomic() = false;
  detail::bump_entities_version();
}

std::vector<rclcpp::CallbackGroup::WeakPtr> Executor::get_all_callback_groups() {
  auto groups = get_manually_added_callback_groups();
  for (auto& group : get_automatically_added_callback_groups_from_nodes()) {
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<rclcpp::CallbackGroup::WeakPtr> Executor::get_manually_added_callback_groups() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return manual_groups_;
}

std::vector<rclcpp::CallbackGroup::WeakPtr>
Executor::get_automatically_added_callback_groups_from_nodes() {
  const std::lock_guard<std::mutex> lock(mutex_);
  refresh_entries();
  std::vector<rclcpp::CallbackGroup::WeakPtr> groups;
  for (const NodeRecord& record : nodes_) {
    groups.insert(groups.end(), record.groups.begin(), record.groups.end());
  }
  return groups;
}

void Executor::add_node(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool) {
  if (node_ptr->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error(std::string("Node '") + node_ptr->get_fully_qualified_name() +
                             "' has already been added to an executor.");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  nodes_.push_back({node_ptr, {}});
  detail::bump_entities_version();
}

void Executor::add_node(std::shared_ptr<rclcpp::Node> node_ptr, bool notify) {
  add_node(node_ptr->get_node_base_interface(), notify);
}

void Executor::remove_node(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr, bool) {
  if (!node_ptr->get_associated_with_executor_atomic()) {
    throw std::runtime_error("Node '" + std::string(node_ptr->get_fully_qualified_name()) +
                             "' needs to be associated with an executor.");
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(nodes_.begin(), nodes_.end(), [&](const NodeRecord& record) {
    return is_same(record.node, node_ptr);
  });
  if (found == nodes_.end()) {
    throw std::runtime_error("Node '" + std::string(node_ptr->get_fully_qualified_name()) +
                             "' needs to be associated with this executor.");
  }
  for (const auto& group : found->groups) {
    release_group(group);
  }
  nodes_.erase(found);
  node_ptr->get_associated_with_executor_atomic() = false;
  detail::bump_entities_version();
}

void Executor::remove_node(std::shared_ptr<rclcpp::Node> node_ptr, bool notify) {
  remove_node(node_ptr->get_node_base_interface(), notify);
}

void Executor::add_entries_of(const rclcpp::CallbackGroup::SharedPtr& group) {
  const auto add = [&](bool is_timer) {
    return [this, &group, is_timer](const auto& entity) {
      const std::shared_ptr<detail::Executable> executable = entity;
      entries_.push_back({executable, group, executable->ready_endpoint(), executable->polls(),
                          executable->follows_status(), is_timer});
    };
  };
  group->collect_all_ptrs(add(false), add(false), add(false), add(true), add(false));
}

void Executor::refresh_entries() {
  const uint32_t version = detail::entities_version();
  if (version == seen_version_) {
    return;
  }
  seen_version_ = version;
  entries_.clear();
  ready_.clear();
  next_ready_ = 0;
  asked_at_.reset();
  nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(),
                              [](const NodeRecord& record) { return record.node.expired(); }),
               nodes_.end());
  for (NodeRecord& record : nodes_) {
    const auto node = record.node.lock();
    if (!node) {
      continue;
    }
    node->for_each_callback_group([&](rclcpp::CallbackGroup::SharedPtr group) {
      if (group->automatically_add_to_executor_with_node() &&
          !group->get_associated_with_executor_atomic().exchange(true)) {
        record.groups.push_back(group);
      }
    });
    for (const auto& weak : record.groups) {
      if (const auto group = weak.lock()) {
        add_entries_of(group);
      }
    }
  }
  for (const auto& weak : manual_groups_) {
    if (const auto group = weak.lock()) {
      add_entries_of(group);
    }
  }
  // Timers come first, otherwise the order stays. By hand: a stable sort is 3 kB of every program.
  std::vector<Entry> ordered;
  ordered.reserve(entries_.size());
  for (const bool timers : {true, false}) {
    for (Entry& entry : entries_) {
      if (entry.is_timer == timers) {
        ordered.push_back(std::move(entry));
      }
    }
  }
  entries_.swap(ordered);
  entry_of_endpoint_.clear();
  polling_.clear();
  for (size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].endpoint_id >= 0) {
      entry_of_endpoint_[entries_[i].endpoint_id] = i;
    }
    if (entries_[i].polls) {
      polling_.push_back(i);
    }
  }
}

void Executor::ask_bus(std::optional<int32_t> token) {
  ros2wasm::ready_endpoints(ready_endpoints_);
  ready_entries_.clear();
  asked_at_ = token;
  for (const uint32_t id : ready_endpoints_) {
    const auto found = entry_of_endpoint_.find(static_cast<int32_t>(id));
    if (found != entry_of_endpoint_.end()) {
      ready_entries_.push_back(found->second);
    } else {
      detail::run_background(id);
      asked_at_.reset();
    }
  }
}

nanoseconds Executor::collect_ready(std::optional<int32_t> token) {
  ready_.clear();
  next_ready_ = 0;
  bool status_changed = false;
  spared_ = token && asked_at_ == token && !ready_entries_.empty();
  if (!spared_) {
    ask_bus(token);
  }
  // Statuses that time alone changes tell nobody: they are looked for however busy it is.
  spared_rounds_ = spared_ ? spared_rounds_ + 1 : 0;
  if (spared_rounds_ % kSparedRounds == 0) {
    const int32_t status = ros2wasm::status_version();
    status_changed = status != seen_status_;
    seen_status_ = status;
  }
  for (const size_t i : ready_entries_) {
    add_ready(i);
  }
  nanoseconds next_timer = nanoseconds::max();
  for (const size_t i : polling_) {
    Entry& entry = entries_[i];
    if (entry.follows_status && !status_changed && !entry.was_ready) {
      continue;
    }
    const auto entity = entry.entity.lock();
    if (!entity) {
      continue;
    }
    if (!entry.is_timer) {
      entry.was_ready = entity->is_ready_now();
      if (entry.was_ready) {
        add_ready(i);
      }
      continue;
    }
    auto& timer = static_cast<TimerBase&>(*entity);
    const nanoseconds left = timer.time_until_trigger();
    if (left.count() <= 0) {
      add_ready(i);
    } else if (!timer.get_clock()->ros_time_is_active()) {
      next_timer = std::min(next_timer, left);
    }
  }
  return next_timer;
}

void Executor::add_ready(size_t entry) {
  // Entries come almost in order. A sort of the library is 3 kB of every program.
  size_t at = ready_.size();
  while (at > 0 && ready_[at - 1] > entry) {
    --at;
  }
  if (at == 0 || ready_[at - 1] != entry) {
    ready_.insert(ready_.begin() + static_cast<std::ptrdiff_t>(at), entry);
  }
}

bool Executor::take_ready(AnyExecutable& any_executable) {
  while (next_ready_ < ready_.size()) {
    const Entry& entry = entries_[ready_[next_ready_++]];
    auto group = entry.group.lock();
    auto entity = entry.entity.lock();
    if (!group || !entity) {
      continue;
    }
    const bool exclusive = group->type() == CallbackGroupType::MutuallyExclusive;
    if (exclusive && !group->can_be_taken_from().exchange(false)) {
      continue;
    }
    std::shared_ptr<void> data;
    if (!entity->claim(data)) {
      if (exclusive) {
        group->can_be_taken_from() = true;
      }
      continue;
    }
    any_executable.entity = std::move(entity);
    any_executable.data = std::move(data);
    any_executable.callback_group = exclusive ? std::move(group) : nullptr;
    any_executable.seekers = &seekers_;
    return true;
  }
  return false;
}

bool Executor::get_next_executable(AnyExecutable& any_executable, nanoseconds timeout) {
  const Seeking seeking(seekers_);
  const bool limited = timeout.count() >= 0;
  const nanoseconds until = limited ? steady_now() + timeout : nanoseconds::max();
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    if (!spinning || !context_->is_valid()) {
      return false;
    }
    detail::look_for_listeners();
    nanoseconds limit = nanoseconds::max();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      refresh_entries();
      if (take_ready(any_executable)) {
        return true;
      }
      limit = collect_ready(token);
      bool found = take_ready(any_executable);
      if (!found && spared_) {
        limit = collect_ready(std::nullopt);
        found = take_ready(any_executable);
      }
      if (found) {
        return true;
      }
    }
    if (limited) {
      const nanoseconds left = until - steady_now();
      if (left.count() <= 0) {
        return false;
      }
      limit = std::min(limit, left);
    }
    ros2wasm::wait(token, limit == nanoseconds::max() ? -1 : limit.count());
  }
}

bool Executor::execute_any_executable(AnyExecutable& any_executable) {
  if (any_executable.entity && run_executable(any_executable)) {
    return true;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  asked_at_.reset();
  return false;
}

bool Executor::run_executable(AnyExecutable& any_executable) {
  return any_executable.entity->run(any_executable.data);
}

void Executor::spin_once_impl(nanoseconds timeout) {
  const bool limited = timeout.count() > 0;
  const nanoseconds until = limited ? steady_now() + timeout : nanoseconds(0);
  while (true) {
    AnyExecutable any_executable;
    if (!get_next_executable(any_executable, timeout) || execute_any_executable(any_executable)) {
      return;
    }
    if (limited) {
      timeout = std::max(until - steady_now(), nanoseconds(0));
    }
  }
}

void Executor::spin_once(nanoseconds timeout) {
  const SpinningFlag flag(spinning, "spin_once()");
  spin_once_impl(timeout);
}

void Executor::spin_some(nanoseconds max_duration) {
  spin_some_impl(max_duration, false);
}

void Executor::spin_all(nanoseconds max_duration) {
  if (max_duration.count() < 0) {
    throw std::invalid_argument("max_duration must be greater than or equal to 0");
  }
  spin_some_impl(max_duration, true);
}

void Executor::spin_some_impl(nanoseconds max_duration, bool exhaustive) {
  const SpinningFlag flag(spinning, "spin_some()");
  const nanoseconds start = steady_now();
  const auto in_time = [&] {
    return max_duration.count() == 0 || steady_now() - start < max_duration;
  };
  // Lets the rest of the page run where waiting is what yields.
  ros2wasm::wait(ros2wasm::wake_token(), 0);
  bool collected = false;
  while (spinning && context_->is_valid() && in_time()) {
    AnyExecutable any_executable;
    bool found = false;
    detail::look_for_listeners();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      refresh_entries();
      found = collected && take_ready(any_executable);
      if (!found && (!collected || exhaustive)) {
        collect_ready(std::nullopt);
        collected = true;
        found = take_ready(any_executable);
      }
    }
    if (!found) {
      return;
    }
    execute_any_executable(any_executable);
  }
}

void Executor::spin_node_once_nanoseconds(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, nanoseconds timeout) {
  add_node(node, false);
  spin_once(timeout);
  remove_node(node, false);
}

void Executor::spin_node_some(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node) {
  add_node(node, false);
  spin_some();
  remove_node(node, false);
}

void Executor::spin_node_some(std::shared_ptr<rclcpp::Node> node) {
  spin_node_some(node->get_node_base_interface());
}

void Executor::spin_node_all(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node,
                             nanoseconds max_duration) {
  add_node(node, false);
  spin_all(max_duration);
  remove_node(node, false);
}

void Executor::spin_node_all(std::shared_ptr<rclcpp::Node> node, nanoseconds max_duration) {
  spin_node_all(node->get_node_base_interface(), max_duration);
}

FutureReturnCode Executor::spin_until_future_complete_impl(
    nanoseconds timeout, const std::function<std::future_status(nanoseconds)>& wait_for_future) {
  if (wait_for_future(nanoseconds(0)) == std::future_status::ready) {
    return FutureReturnCode::SUCCESS;
  }
  const bool limited = timeout.count() >= 0;
  const nanoseconds until = limited ? steady_now() + timeout : nanoseconds::max();
  const SpinningFlag flag(spinning, "spin_until_future_complete()");
  while (context_->is_valid() && spinning) {
    const nanoseconds left =
        limited ? std::max(until - steady_now(), nanoseconds(0)) : nanoseconds(-1);
    spin_once_impl(left);
    if (wait_for_future(nanoseconds(0)) == std::future_status::ready) {
      return FutureReturnCode::SUCCESS;
    }
    if (limited && steady_now() >= until) {
      return FutureReturnCode::TIMEOUT;
    }
  }
  return FutureReturnCode::INTERRUPTED;
}

void Executor::cancel() {
  spinning = false;
  ros2wasm::wake();
}

bool Executor::is_spinning() {
  return spinning;
}

std::string to_string(const FutureReturnCode& future_return_code) {
  const std::string number = " (" + std::to_string(static_cast<int>(future_return_code)) + ")";
  switch (future_return_code) {
    case FutureReturnCode::SUCCESS:
      return "SUCCESS" + number;
    case FutureReturnCode::INTERRUPTED:
      return "INTERRUPTED" + number;
    case FutureReturnCode::TIMEOUT:
      return "TIMEOUT" + number;
  }
  return "Unknown enum value" + number;
}

std::ostream& operator<<(std::ostream& os, const FutureReturnCode& future_return_code) {
  return os << to_string(future_return_code);
}

}  // namespace rclcpp
