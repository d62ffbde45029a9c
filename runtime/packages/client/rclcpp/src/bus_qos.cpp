// QoS between rclcpp and the bus.
#include "rclcpp/detail/bus_qos.hpp"

#include <algorithm>
#include <vector>

#include "ros2wasm/graph.hpp"

namespace rclcpp {
namespace detail {
namespace {

// On the bus 0 says "no limit", whatever word the profile had for it.
constexpr int64_t kBestAvailable = INT64_MAX - 1;

int64_t limit_ns(const rmw_time_t& time) {
  const int64_t ns = rmw_time_total_nsec(time);
  return ns >= kBestAvailable ? 0 : ns;
}

bool is_best_available(const rmw_time_t& time) {
  return rmw_time_total_nsec(time) == kBestAvailable;
}

bool has_best_available(const rmw_qos_profile_t& profile) {
  return profile.reliability == RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE ||
         profile.durability == RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE ||
         profile.liveliness == RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE ||
         is_best_available(profile.deadline) ||
         is_best_available(profile.liveliness_lease_duration);
}

std::vector<ros2wasm::EndpointQos> endpoints_of(const std::string& topic,
                                                ros2wasm::EndpointKind kind) {
  std::vector<ros2wasm::EndpointQos> found;
  for (const ros2wasm::GraphEndpoint& endpoint : ros2wasm::take_graph_snapshot().endpoints) {
    if (endpoint.kind == kind && endpoint.name == topic) {
      found.push_back(endpoint.qos);
    }
  }
  return found;
}

// The limits that are set, ordered; empty: none is.
std::vector<int64_t> limits(const std::vector<ros2wasm::EndpointQos>& endpoints,
                            int64_t ros2wasm::EndpointQos::*limit) {
  std::vector<int64_t> found;
  for (const ros2wasm::EndpointQos& qos : endpoints) {
    if (qos.*limit != 0) {
      found.push_back(qos.*limit);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Fills in `time` if it is open: the longest or shortest that the others have set.
void choose_limit(rmw_time_t& time, const std::vector<int64_t>& others, bool longest) {
  if (is_best_available(time)) {
    const int64_t none = 0;
    time = rmw_time_from_nsec(others.empty() ? none : longest ? others.back() : others.front());
  }
}

void choose_limits(rmw_qos_profile_t& profile, const std::vector<ros2wasm::EndpointQos>& others,
                   bool longest) {
  choose_limit(profile.deadline, limits(others, &ros2wasm::EndpointQos::deadline_ns), longest);
  choose_limit(profile.liveliness_lease_duration, limits(others, &ros2wasm::EndpointQos::lease_ns),
               longest);
}

}  // namespace

rclcpp::QoS resolve_qos(const rclcpp::QoS& qos) {
  rclcpp::QoS resolved = qos;
  rmw_qos_profile_t& profile = resolved.get_rmw_qos_profile();
  if (profile.history != RMW_QOS_POLICY_HISTORY_KEEP_ALL) {
    profile.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
    profile.depth = profile.depth == 0 ? 1 : profile.depth;
  }
  if (profile.reliability != RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT) {
    profile.reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  }
  if (profile.durability != RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL) {
    profile.durability = RMW_QOS_POLICY_DURABILITY_VOLATILE;
  }
  if (profile.liveliness != RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC) {
    profile.liveliness = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC;
  }
  return resolved;
}

rclcpp::QoS resolve_publisher_qos(const rclcpp::QoS& qos, const std::string& topic) {
  rclcpp::QoS chosen = qos;
  rmw_qos_profile_t& profile = chosen.get_rmw_qos_profile();
  if (!has_best_available(profile)) {
    return resolve_qos(qos);
  }
  const auto others = endpoints_of(topic, ros2wasm::EndpointKind::subscription);
  // Reliable and transient local fit every subscription.
  if (profile.durability == RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE) {
    profile.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  }
  if (profile.liveliness == RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE &&
      std::any_of(others.begin(), others.end(), [](const ros2wasm::EndpointQos& other) {
        return other.liveliness == RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC;
      })) {
    profile.liveliness = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC;
  }
  choose_limits(profile, others, false);
  return resolve_qos(chosen);
}

rclcpp::QoS resolve_subscription_qos(const rclcpp::QoS& qos, const std::string& topic) {
  rclcpp::QoS chosen = qos;
  rmw_qos_profile_t& profile = chosen.get_rmw_qos_profile();
  if (!has_best_available(profile)) {
    return resolve_qos(qos);
  }
  // The higher level only when all publishers offer it, also when there is none.
  const auto others = endpoints_of(topic, ros2wasm::EndpointKind::publisher);
  const auto all = [&others](uint32_t ros2wasm::EndpointQos::*policy, int value) {
    return std::all_of(others.begin(), others.end(), [&](const ros2wasm::EndpointQos& other) {
      return other.*policy == static_cast<uint32_t>(value);
    });
  };
  if (profile.reliability == RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE &&
      !all(&ros2wasm::EndpointQos::reliability, RMW_QOS_POLICY_RELIABILITY_RELIABLE)) {
    profile.reliability = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
  }
  if (profile.durability == RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE &&
      all(&ros2wasm::EndpointQos::durability, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)) {
    profile.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  }
  if (profile.liveliness == RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE &&
      all(&ros2wasm::EndpointQos::liveliness, RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC)) {
    profile.liveliness = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC;
  }
  choose_limits(profile, others, true);
  return resolve_qos(chosen);
}

ros2wasm::EndpointQos to_bus(const rclcpp::QoS& resolved) {
  const rmw_qos_profile_t& profile = resolved.get_rmw_qos_profile();
  ros2wasm::EndpointQos qos;
  qos.reliability = static_cast<uint32_t>(profile.reliability);
  qos.durability = static_cast<uint32_t>(profile.durability);
  qos.history = static_cast<uint32_t>(profile.history);
  qos.depth = static_cast<uint32_t>(profile.depth);
  qos.liveliness = static_cast<uint32_t>(profile.liveliness);
  qos.deadline_ns = limit_ns(profile.deadline);
  qos.lifespan_ns = limit_ns(profile.lifespan);
  qos.lease_ns = limit_ns(profile.liveliness_lease_duration);
  return qos;
}

rclcpp::QoS from_bus(const ros2wasm::EndpointQos& qos) {
  rclcpp::QoS result(qos.depth);
  rmw_qos_profile_t& profile = result.get_rmw_qos_profile();
  profile.history = static_cast<rmw_qos_history_policy_t>(qos.history);
  profile.reliability = static_cast<rmw_qos_reliability_policy_t>(qos.reliability);
  profile.durability = static_cast<rmw_qos_durability_policy_t>(qos.durability);
  profile.liveliness = static_cast<rmw_qos_liveliness_policy_t>(qos.liveliness);
  const auto limit = [](int64_t ns) { return rmw_time_from_nsec(ns == 0 ? -1 : ns); };
  profile.deadline = limit(qos.deadline_ns);
  profile.lifespan = limit(qos.lifespan_ns);
  profile.liveliness_lease_duration = limit(qos.lease_ns);
  return result;
}

}  // namespace detail
}  // namespace rclcpp
