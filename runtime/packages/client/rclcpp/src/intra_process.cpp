// Delivery by pointer. The rule of ROS: listeners that only read share one object; of those that
// want to own it, the last gets the publisher's own object and the others get copies.
#include "rclcpp/detail/intra_process.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <vector>

#include "rclcpp/subscription_base.hpp"

namespace rclcpp {
namespace detail {
namespace {

using GidBytes = std::array<uint8_t, 16>;

struct Locals {
  std::mutex mutex;
  std::vector<std::weak_ptr<SubscriptionBase>> subscriptions;
  std::vector<GidBytes> publishers;
};

Locals& locals() {
  static Locals instance;
  return instance;
}

GidBytes bytes_of(const uint8_t gid[16]) {
  GidBytes bytes;
  std::memcpy(bytes.data(), gid, bytes.size());
  return bytes;
}

std::vector<std::shared_ptr<SubscriptionBase>> listeners(const std::string& topic,
                                                         const char* type) {
  const std::lock_guard<std::mutex> lock(locals().mutex);
  std::vector<std::shared_ptr<SubscriptionBase>> found;
  for (const auto& weak : locals().subscriptions) {
    auto subscription = weak.lock();
    if (subscription && topic == subscription->get_topic_name() &&
        std::strcmp(type, subscription->type_name()) == 0) {
      found.push_back(std::move(subscription));
    }
  }
  return found;
}

}  // namespace

void add_local_subscription(const std::shared_ptr<SubscriptionBase>& subscription) {
  const std::lock_guard<std::mutex> lock(locals().mutex);
  auto& all = locals().subscriptions;
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& w) { return w.expired(); }),
            all.end());
  all.push_back(subscription);
}

size_t count_local_subscriptions(const std::string& topic, const char* type) {
  return listeners(topic, type).size();
}

void deliver_locally(const std::string& topic, const char* type, void* object,
                     const ObjectFunctions& functions) {
  std::unique_ptr<void, void (*)(void*)> owned(object, functions.destroy);
  std::vector<std::shared_ptr<SubscriptionBase>> sharing;
  std::vector<std::shared_ptr<SubscriptionBase>> owning;
  for (auto& subscription : listeners(topic, type)) {
    (subscription->takes_ownership() ? owning : sharing).push_back(std::move(subscription));
  }
  if (!sharing.empty()) {
    std::shared_ptr<const void> shared;
    if (owning.empty()) {
      shared = std::shared_ptr<void>(owned.release(), functions.destroy);
    } else {
      shared = std::shared_ptr<void>(functions.copy(owned.get()), functions.destroy);
    }
    for (const auto& subscription : sharing) {
      LocalMessage message;
      message.shared = shared;
      subscription->push_local(std::move(message));
    }
  }
  for (size_t i = 0; i < owning.size(); ++i) {
    LocalMessage message;
    void* mine = i + 1 == owning.size() ? owned.release() : functions.copy(owned.get());
    message.owned = {mine, functions.destroy};
    owning[i]->push_local(std::move(message));
  }
}

void add_local_publisher(const uint8_t gid[16]) {
  const std::lock_guard<std::mutex> lock(locals().mutex);
  locals().publishers.push_back(bytes_of(gid));
}

void remove_local_publisher(const uint8_t gid[16]) {
  const std::lock_guard<std::mutex> lock(locals().mutex);
  auto& all = locals().publishers;
  all.erase(std::remove(all.begin(), all.end(), bytes_of(gid)), all.end());
}

bool is_local_publisher(const uint8_t gid[16]) {
  const std::lock_guard<std::mutex> lock(locals().mutex);
  const auto& all = locals().publishers;
  return std::find(all.begin(), all.end(), bytes_of(gid)) != all.end();
}

}  // namespace detail
}  // namespace rclcpp
