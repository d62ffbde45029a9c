// QoS setters, profiles, and what fits what.
#include "rclcpp/qos.hpp"

#include "rclcpp/logging.hpp"
#include "rmw/qos_string_conversions.h"

namespace rclcpp {

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t policy_kind) {
  switch (policy_kind) {
    case RMW_QOS_POLICY_DURABILITY:
      return "DURABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_DEADLINE:
      return "DEADLINE_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS:
      return "LIVELINESS_QOS_POLICY";
    case RMW_QOS_POLICY_RELIABILITY:
      return "RELIABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_HISTORY:
      return "HISTORY_QOS_POLICY";
    case RMW_QOS_POLICY_LIFESPAN:
      return "LIFESPAN_QOS_POLICY";
    case RMW_QOS_POLICY_DEPTH:
      return "DEPTH_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION:
      return "LIVELINESS_LEASE_DURATION_QOS_POLICY";
    default:
      return "INVALID_QOS_POLICY";
  }
}

QoSInitialization::QoSInitialization(rmw_qos_history_policy_t history_policy_arg, size_t depth_arg,
                                     bool print_depth_warning)
    : history_policy(history_policy_arg), depth(depth_arg) {
  if (history_policy == RMW_QOS_POLICY_HISTORY_KEEP_LAST && depth == 0 && print_depth_warning) {
    RCLCPP_WARN_ONCE(rclcpp::get_logger("rclcpp"),
                     "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                     "This will be interpreted as SYSTEM_DEFAULT");
  }
}

QoSInitialization QoSInitialization::from_rmw(const rmw_qos_profile_t& rmw_qos) {
  switch (rmw_qos.history) {
    case RMW_QOS_POLICY_HISTORY_KEEP_ALL:
      return KeepAll();
    case RMW_QOS_POLICY_HISTORY_KEEP_LAST:
    case RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT:
    case RMW_QOS_POLICY_HISTORY_UNKNOWN:
      return KeepLast(rmw_qos.depth, false);
  }
  return KeepLast(rmw_qos.depth, false);
}

KeepAll::KeepAll() : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
KeepLast::KeepLast(size_t depth, bool print_depth_warning)
    : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth, print_depth_warning) {}

QoS::QoS(const QoSInitialization& qos_initialization, const rmw_qos_profile_t& initial_profile)
    : rmw_qos_profile_(initial_profile) {
  rmw_qos_profile_.history = qos_initialization.history_policy;
  rmw_qos_profile_.depth = qos_initialization.depth;
}

QoS::QoS(size_t history_depth) : QoS(KeepLast(history_depth)) {}

QoS& QoS::history(rmw_qos_history_policy_t history) {
  rmw_qos_profile_.history = history;
  return *this;
}
QoS& QoS::history(HistoryPolicy policy) {
  return history(static_cast<rmw_qos_history_policy_t>(policy));
}
QoS& QoS::keep_last(size_t depth) {
  if (depth == 0) {
    RCLCPP_WARN_ONCE(rclcpp::get_logger("rclcpp"),
                     "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                     "This will be interpreted as SYSTEM_DEFAULT");
  }
  rmw_qos_profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  rmw_qos_profile_.depth = depth;
  return *this;
}
QoS& QoS::keep_all() {
  rmw_qos_profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_ALL;
  rmw_qos_profile_.depth = 0;
  return *this;
}
QoS& QoS::reliability(rmw_qos_reliability_policy_t reliability) {
  rmw_qos_profile_.reliability = reliability;
  return *this;
}
QoS& QoS::reliability(ReliabilityPolicy policy) {
  return reliability(static_cast<rmw_qos_reliability_policy_t>(policy));
}
QoS& QoS::reliable() {
  return reliability(RMW_QOS_POLICY_RELIABILITY_RELIABLE);
}
QoS& QoS::best_effort() {
  return reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT);
}
QoS& QoS::reliability_best_available() {
  return reliability(RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE);
}
QoS& QoS::durability(rmw_qos_durability_policy_t durability) {
  rmw_qos_profile_.durability = durability;
  return *this;
}
QoS& QoS::durability(DurabilityPolicy policy) {
  return durability(static_cast<rmw_qos_durability_policy_t>(policy));
}
QoS& QoS::durability_volatile() {
  return durability(RMW_QOS_POLICY_DURABILITY_VOLATILE);
}
QoS& QoS::transient_local() {
  return durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL);
}
QoS& QoS::durability_best_available() {
  return durability(RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE);
}
QoS& QoS::deadline(rmw_time_t deadline) {
  rmw_qos_profile_.deadline = deadline;
  return *this;
}
QoS& QoS::deadline(const rclcpp::Duration& duration) {
  return deadline(duration.to_rmw_time());
}
QoS& QoS::lifespan(rmw_time_t lifespan) {
  rmw_qos_profile_.lifespan = lifespan;
  return *this;
}
QoS& QoS::lifespan(const rclcpp::Duration& duration) {
  return lifespan(duration.to_rmw_time());
}
QoS& QoS::liveliness(rmw_qos_liveliness_policy_t liveliness) {
  rmw_qos_profile_.liveliness = liveliness;
  return *this;
}
QoS& QoS::liveliness(LivelinessPolicy policy) {
  return liveliness(static_cast<rmw_qos_liveliness_policy_t>(policy));
}
QoS& QoS::liveliness_lease_duration(rmw_time_t liveliness_lease_duration) {
  rmw_qos_profile_.liveliness_lease_duration = liveliness_lease_duration;
  return *this;
}
QoS& QoS::liveliness_lease_duration(const rclcpp::Duration& duration) {
  return liveliness_lease_duration(duration.to_rmw_time());
}
QoS& QoS::avoid_ros_namespace_conventions(bool avoid) {
  rmw_qos_profile_.avoid_ros_namespace_conventions = avoid;
  return *this;
}

HistoryPolicy QoS::history() const {
  return static_cast<HistoryPolicy>(rmw_qos_profile_.history);
}
size_t QoS::depth() const {
  return rmw_qos_profile_.depth;
}
ReliabilityPolicy QoS::reliability() const {
  return static_cast<ReliabilityPolicy>(rmw_qos_profile_.reliability);
}
DurabilityPolicy QoS::durability() const {
  return static_cast<DurabilityPolicy>(rmw_qos_profile_.durability);
}
Duration QoS::deadline() const {
  return Duration::from_rmw_time(rmw_qos_profile_.deadline);
}
Duration QoS::lifespan() const {
  return Duration::from_rmw_time(rmw_qos_profile_.lifespan);
}
LivelinessPolicy QoS::liveliness() const {
  return static_cast<LivelinessPolicy>(rmw_qos_profile_.liveliness);
}
Duration QoS::liveliness_lease_duration() const {
  return Duration::from_rmw_time(rmw_qos_profile_.liveliness_lease_duration);
}
bool QoS::avoid_ros_namespace_conventions() const {
  return rmw_qos_profile_.avoid_ros_namespace_conventions;
}

bool operator==(const QoS& left, const QoS& right) {
  const rmw_qos_profile_t& a = left.get_rmw_qos_profile();
  const rmw_qos_profile_t& b = right.get_rmw_qos_profile();
  const auto same = [](const rmw_time_t& x, const rmw_time_t& y) {
    return x.sec == y.sec && x.nsec == y.nsec;
  };
  return a.history == b.history && a.depth == b.depth && a.reliability == b.reliability &&
         a.durability == b.durability && same(a.deadline, b.deadline) &&
         same(a.lifespan, b.lifespan) && a.liveliness == b.liveliness &&
         same(a.liveliness_lease_duration, b.liveliness_lease_duration) &&
         a.avoid_ros_namespace_conventions == b.avoid_ros_namespace_conventions;
}

bool operator!=(const QoS& left, const QoS& right) {
  return !(left == right);
}

namespace {

bool is_unset(const rmw_time_t& time) {
  return time.sec == 0 && time.nsec == 0;
}

// The publisher's period must be known and not longer than the subscription's.
bool period_fits(const rmw_time_t& publisher, const rmw_time_t& subscription) {
  return is_unset(subscription) || rmw_time_total_nsec(subscription) == INT64_MAX ||
         (!is_unset(publisher) &&
          rmw_time_total_nsec(publisher) <= rmw_time_total_nsec(subscription));
}

// A policy that an endpoint leaves to the middleware, in the words of ROS 2's warnings.
struct OpenPolicy {
  std::string publisher_value;
  std::string subscription_value;
  bool publisher_open;
  bool subscription_open;
  bool publisher_offers_least;
  bool subscription_asks_most;
  const char* publisher_is;
  const char* subscription_is;
  const char* demanding;
  const char* modest;
};

std::string word(const char* text) {
  return text == nullptr ? "unknown" : text;
}

template <typename NoteT>
void note_open_policies(const rmw_qos_profile_t& pub, const rmw_qos_profile_t& sub,
                        const NoteT& note) {
  const auto open = [](auto value, auto system_default, auto unknown) {
    return value == system_default || value == unknown;
  };
  const auto reliability_open = [&open](const rmw_qos_profile_t& profile) {
    return open(profile.reliability, RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
                RMW_QOS_POLICY_RELIABILITY_UNKNOWN);
  };
  const auto durability_open = [&open](const rmw_qos_profile_t& profile) {
    return open(profile.durability, RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
                RMW_QOS_POLICY_DURABILITY_UNKNOWN);
  };
  const auto liveliness_open = [&open](const rmw_qos_profile_t& profile) {
    return open(profile.liveliness, RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
                RMW_QOS_POLICY_LIVELINESS_UNKNOWN);
  };
  const OpenPolicy policies[] = {
      {word(rmw_qos_reliability_policy_to_str(pub.reliability)),
       word(rmw_qos_reliability_policy_to_str(sub.reliability)), reliability_open(pub),
       reliability_open(sub), pub.reliability == RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT,
       sub.reliability == RMW_QOS_POLICY_RELIABILITY_RELIABLE, "Publisher reliability is ",
       " and subscription reliability is ", "Reliable subscription, but publisher is ",
       "Best effort publisher, but subscription is "},
      {word(rmw_qos_durability_policy_to_str(pub.durability)),
       word(rmw_qos_durability_policy_to_str(sub.durability)), durability_open(pub),
       durability_open(sub), pub.durability == RMW_QOS_POLICY_DURABILITY_VOLATILE,
       sub.durability == RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL, "Publisher durabilty is ",
       " and subscription durability is ", "Transient local subscription, but publisher is ",
       "Volatile publisher, but subscription is "},
      {word(rmw_qos_liveliness_policy_to_str(pub.liveliness)),
       word(rmw_qos_liveliness_policy_to_str(sub.liveliness)), liveliness_open(pub),
       liveliness_open(sub), pub.liveliness == RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
       sub.liveliness == RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC, "Publisher liveliness is ",
       " and subscription liveliness is ",
       "Subscription's liveliness is manual by topic, but publisher's is ",
       "Publisher's liveliness is automatic, but subscription's is "},
  };
  for (const OpenPolicy& policy : policies) {
    if (policy.publisher_open && policy.subscription_open) {
      note(policy.publisher_is + policy.publisher_value + policy.subscription_is +
           policy.subscription_value);
    } else if (policy.publisher_open && policy.subscription_asks_most) {
      note(policy.demanding + policy.publisher_value);
    } else if (policy.publisher_offers_least && policy.subscription_open) {
      note(policy.modest + policy.subscription_value);
    }
  }
}

}  // namespace

QoSCheckCompatibleResult qos_check_compatible(const QoS& publisher_qos,
                                              const QoS& subscription_qos) {
  const rmw_qos_profile_t& pub = publisher_qos.get_rmw_qos_profile();
  const rmw_qos_profile_t& sub = subscription_qos.get_rmw_qos_profile();
  QoSCheckCompatibleResult result{QoSCompatibility::Ok, {}};
  const auto note = [&result](QoSCompatibility level, const std::string& text) {
    if (static_cast<int>(level) > static_cast<int>(result.compatibility)) {
      result.compatibility = level;
    }
    result.reason +=
        std::string(level == QoSCompatibility::Error ? "ERROR: " : "WARNING: ") + text + ";";
  };
  if (pub.reliability == RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT &&
      sub.reliability == RMW_QOS_POLICY_RELIABILITY_RELIABLE) {
    note(QoSCompatibility::Error, "Best effort publisher and reliable subscription");
  }
  if (pub.durability == RMW_QOS_POLICY_DURABILITY_VOLATILE &&
      sub.durability == RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL) {
    note(QoSCompatibility::Error, "Volatile publisher and transient local subscription");
  }
  if (!period_fits(pub.deadline, sub.deadline)) {
    note(QoSCompatibility::Error, is_unset(pub.deadline)
                                      ? "Subscription has a deadline, but publisher does not"
                                      : "Subscription deadline is less than publisher deadline");
  }
  if (pub.liveliness == RMW_QOS_POLICY_LIVELINESS_AUTOMATIC &&
      sub.liveliness == RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC) {
    note(QoSCompatibility::Error,
         "Publisher's liveliness is automatic and subscription's is manual by topic");
  }
  if (!period_fits(pub.liveliness_lease_duration, sub.liveliness_lease_duration)) {
    note(QoSCompatibility::Error,
         is_unset(pub.liveliness_lease_duration)
             ? "Subscription has a liveliness lease duration, but publisher does not"
             : "Subscription liveliness lease duration is less than publisher");
  }
  if (result.compatibility == QoSCompatibility::Ok) {
    note_open_policies(pub, sub,
                       [&note](const std::string& text) { note(QoSCompatibility::Warning, text); });
  }
  return result;
}

ClockQoS::ClockQoS(const QoSInitialization& init) : QoS(init, rmw_qos_profile_default) {
  best_effort();
}
SensorDataQoS::SensorDataQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_sensor_data) {}
ParametersQoS::ParametersQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_parameters) {}
ServicesQoS::ServicesQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_services_default) {}
ParameterEventsQoS::ParameterEventsQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_parameter_events) {}
RosoutQoS::RosoutQoS(const QoSInitialization& init) : QoS(init, rcl_qos_profile_rosout_default) {}
SystemDefaultsQoS::SystemDefaultsQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_system_default) {}
BestAvailableQoS::BestAvailableQoS(const QoSInitialization& init)
    : QoS(init, rmw_qos_profile_best_available) {}

}  // namespace rclcpp
