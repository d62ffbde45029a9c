// The list of background work.
#include "rclcpp/detail/background.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

#include "rclcpp/detail/listeners.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {
namespace {

struct Work {
  uint32_t endpoint_id;
  std::function<void()> run;
};

struct Works {
  std::mutex mutex;
  std::vector<std::weak_ptr<Work>> all;
};

Works& works() {
  static Works instance;
  return instance;
}

std::shared_ptr<Work> find_work(uint32_t endpoint_id) {
  const std::lock_guard<std::mutex> lock(works().mutex);
  for (const auto& weak : works().all) {
    auto work = weak.lock();
    if (work && work->endpoint_id == endpoint_id) {
      return work;
    }
  }
  return nullptr;
}

}  // namespace

std::shared_ptr<void> add_background(int32_t endpoint_id, std::function<void()> run) {
  auto work = std::make_shared<Work>(Work{static_cast<uint32_t>(endpoint_id), std::move(run)});
  const std::lock_guard<std::mutex> lock(works().mutex);
  auto& all = works().all;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const std::weak_ptr<Work>& weak) { return weak.expired(); }),
            all.end());
  all.push_back(work);
  // Wake the waits: data that arrived before this registration must also be handled.
  ros2wasm::wake();
  return work;
}

void run_background(uint32_t endpoint_id) {
  if (const auto work = find_work(endpoint_id)) {
    work->run();
  }
}

void run_background() {
  look_for_listeners();
  std::vector<uint32_t> ids;
  ros2wasm::ready_endpoints(ids);
  for (const uint32_t id : ids) {
    run_background(id);
  }
}

}  // namespace detail
}  // namespace rclcpp
