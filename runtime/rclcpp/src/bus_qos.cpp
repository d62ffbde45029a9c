// QoS between rclcpp and the bus.
#include "rclcpp/detail/bus_qos.hpp"

namespace rclcpp {
namespace detail {
namespace {

// On the bus 0 says "no limit", whatever word the profile had for it.
int64_t limit_ns(const rmw_time_t& time) {
  const int64_t ns = rmw_time_total_nsec(time);
  constexpr int64_t kBestAvailable = INT64_MAX - 1;
  return ns >= kBestAvailable ? 0 : ns;
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
