// The QoS of publishers in bags, and the QoS for recording and replaying that follows from it.
#include "rosbag2_storage/qos.hpp"

#include <algorithm>

#include "metadata_yaml.hpp"
#include "rcutils/logging_macros.h"

namespace rosbag2_storage {
namespace {

constexpr char kLog[] = "rosbag2_storage";

bool equal(const rmw_time_t& a, const rmw_time_t& b) {
  return a.sec == b.sec && a.nsec == b.nsec;
}

/// In what decides whether they are heard.
bool offer_the_same(const rclcpp::QoS& one, const rclcpp::QoS& other) {
  const rmw_qos_profile_t& a = one.get_rmw_qos_profile();
  const rmw_qos_profile_t& b = other.get_rmw_qos_profile();
  return a.reliability == b.reliability && a.durability == b.durability &&
         equal(a.deadline, b.deadline) && a.liveliness == b.liveliness &&
         equal(a.liveliness_lease_duration, b.liveliness_lease_duration);
}

void warn_of_mixture(const std::string& topic, const char* offered, const char* asked,
                     const char* lost) {
  RCUTILS_LOG_WARN_NAMED(kLog,
                         "Some, but not all, publishers on topic \"%s\" are offering %s. "
                         "Falling back to %s as it will connect to all publishers. %s",
                         topic.c_str(), offered, asked, lost);
}

}  // namespace

Rosbag2QoS Rosbag2QoS::adapt_request_to_offers(
    const std::string& topic_name, const std::vector<rclcpp::TopicEndpointInfo>& endpoints) {
  Rosbag2QoS request;
  if (endpoints.empty()) {
    return request;
  }
  const auto count = [&](auto holds) {
    return static_cast<size_t>(std::count_if(
        endpoints.begin(), endpoints.end(),
        [&](const auto& endpoint) { return holds(endpoint.qos_profile().get_rmw_qos_profile()); }));
  };
  const size_t reliable = count([](const rmw_qos_profile_t& qos) {
    return qos.reliability == RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  });
  const size_t latched = count([](const rmw_qos_profile_t& qos) {
    return qos.durability == RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  });
  if (reliable == endpoints.size()) {
    request.reliable();
  } else {
    if (reliable > 0) {
      warn_of_mixture(topic_name, "RMW_QOS_POLICY_RELIABILITY_RELIABLE",
                      "RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT",
                      "Some messages from Reliable publishers could be dropped.");
    }
    request.best_effort();
  }
  if (latched == endpoints.size()) {
    request.transient_local();
  } else {
    if (latched > 0) {
      warn_of_mixture(topic_name, "RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL",
                      "RMW_QOS_POLICY_DURABILITY_VOLATILE",
                      "Previously-published latched messages will not be retrieved.");
    }
    request.durability_volatile();
  }
  return request;
}

Rosbag2QoS Rosbag2QoS::adapt_offer_to_recorded_offers(const std::string& topic_name,
                                                      const std::vector<Rosbag2QoS>& profiles) {
  if (profiles.empty()) {
    return Rosbag2QoS();
  }
  if (std::all_of(profiles.begin(), profiles.end(),
                  [&](const Rosbag2QoS& one) { return offer_the_same(one, profiles.front()); })) {
    Rosbag2QoS offer = profiles.front();
    return offer.default_history();
  }
  RCUTILS_LOG_WARN_NAMED(
      kLog,
      "Not all original publishers on topic %s offered the same QoS profiles. Rosbag2 cannot yet "
      "choose an adapted profile to offer for this mixed case. Falling back to the rosbag2_storage "
      "default publisher offer.",
      topic_name.c_str());
  return Rosbag2QoS();
}

std::vector<Rosbag2QoS> from_rclcpp_qos_vector(const std::vector<rclcpp::QoS>& in) {
  return {in.begin(), in.end()};
}

std::string serialize_rclcpp_qos_vector(const std::vector<rclcpp::QoS>& in, int version) {
  return profiles_yaml(in, "", version);
}

std::vector<rclcpp::QoS> to_rclcpp_qos_vector(const std::string& serialized, int) {
  if (serialized.empty()) {
    return {};
  }
  return parse_profiles(ros2wasm::parse_yaml(serialized));
}

}  // namespace rosbag2_storage
