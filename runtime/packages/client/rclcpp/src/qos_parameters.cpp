// QoS policies as parameters.
#include "rclcpp/detail/qos_parameters.hpp"

#include <algorithm>
#include <stdexcept>

#include "rclcpp/exceptions.hpp"

namespace rclcpp {

const char* qos_policy_kind_to_cstr(const QosPolicyKind& qpk) {
  const char* name = rmw_qos_policy_kind_to_str(static_cast<rmw_qos_policy_kind_t>(qpk));
  if (name == nullptr) {
    throw std::invalid_argument("unknown QoS policy kind");
  }
  return name;
}

namespace detail {
namespace {

constexpr QosPolicyKind kOrder[] = {
    QosPolicyKind::AvoidRosNamespaceConventions,
    QosPolicyKind::Deadline,
    QosPolicyKind::Durability,
    QosPolicyKind::History,
    QosPolicyKind::Depth,
    QosPolicyKind::Lifespan,
    QosPolicyKind::Liveliness,
    QosPolicyKind::LivelinessLeaseDuration,
    QosPolicyKind::Reliability,
};

rclcpp::ParameterValue text_value(const char* text) {
  if (text == nullptr) {
    throw std::invalid_argument("unknown value for a QoS policy");
  }
  return rclcpp::ParameterValue(text);
}

rclcpp::ParameterValue value_of(QosPolicyKind policy, const rclcpp::QoS& qos) {
  const rmw_qos_profile_t& profile = qos.get_rmw_qos_profile();
  switch (policy) {
    case QosPolicyKind::AvoidRosNamespaceConventions:
      return rclcpp::ParameterValue(profile.avoid_ros_namespace_conventions);
    case QosPolicyKind::Deadline:
      return rclcpp::ParameterValue(rmw_time_total_nsec(profile.deadline));
    case QosPolicyKind::Depth:
      return rclcpp::ParameterValue(static_cast<int64_t>(profile.depth));
    case QosPolicyKind::Durability:
      return text_value(rmw_qos_durability_policy_to_str(profile.durability));
    case QosPolicyKind::History:
      return text_value(rmw_qos_history_policy_to_str(profile.history));
    case QosPolicyKind::Lifespan:
      return rclcpp::ParameterValue(rmw_time_total_nsec(profile.lifespan));
    case QosPolicyKind::Liveliness:
      return text_value(rmw_qos_liveliness_policy_to_str(profile.liveliness));
    case QosPolicyKind::LivelinessLeaseDuration:
      return rclcpp::ParameterValue(rmw_time_total_nsec(profile.liveliness_lease_duration));
    case QosPolicyKind::Reliability:
      return text_value(rmw_qos_reliability_policy_to_str(profile.reliability));
    case QosPolicyKind::Invalid:
      break;
  }
  throw std::invalid_argument("unknown QoS policy kind");
}

template <typename PolicyT>
PolicyT require_known(PolicyT policy, PolicyT unknown, QosPolicyKind kind,
                      const std::string& text) {
  if (policy == unknown) {
    throw std::invalid_argument(std::string("unknown QoS policy ") + qos_policy_kind_to_cstr(kind) +
                                " value: " + text);
  }
  return policy;
}

void apply(QosPolicyKind policy, const rclcpp::ParameterValue& value, rclcpp::QoS& qos) {
  const auto duration = [&value] {
    return rclcpp::Duration::from_nanoseconds(value.get<int64_t>());
  };
  switch (policy) {
    case QosPolicyKind::AvoidRosNamespaceConventions:
      qos.avoid_ros_namespace_conventions(value.get<bool>());
      return;
    case QosPolicyKind::Deadline:
      qos.deadline(duration());
      return;
    case QosPolicyKind::Depth:
      qos.get_rmw_qos_profile().depth = static_cast<size_t>(value.get<int64_t>());
      return;
    case QosPolicyKind::Durability: {
      const std::string& text = value.get<std::string>();
      qos.durability(require_known(rmw_qos_durability_policy_from_str(text.c_str()),
                                   RMW_QOS_POLICY_DURABILITY_UNKNOWN, policy, text));
      return;
    }
    case QosPolicyKind::History: {
      const std::string& text = value.get<std::string>();
      qos.history(require_known(rmw_qos_history_policy_from_str(text.c_str()),
                                RMW_QOS_POLICY_HISTORY_UNKNOWN, policy, text));
      return;
    }
    case QosPolicyKind::Lifespan:
      qos.lifespan(duration());
      return;
    case QosPolicyKind::Liveliness: {
      const std::string& text = value.get<std::string>();
      qos.liveliness(require_known(rmw_qos_liveliness_policy_from_str(text.c_str()),
                                   RMW_QOS_POLICY_LIVELINESS_UNKNOWN, policy, text));
      return;
    }
    case QosPolicyKind::LivelinessLeaseDuration:
      qos.liveliness_lease_duration(duration());
      return;
    case QosPolicyKind::Reliability: {
      const std::string& text = value.get<std::string>();
      qos.reliability(require_known(rmw_qos_reliability_policy_from_str(text.c_str()),
                                    RMW_QOS_POLICY_RELIABILITY_UNKNOWN, policy, text));
      return;
    }
    case QosPolicyKind::Invalid:
      break;
  }
  throw std::invalid_argument("unknown QosPolicyKind");
}

}  // namespace

rclcpp::QoS declare_qos_parameters(const rclcpp::QosOverridingOptions& options,
                                   node_interfaces::NodeParametersInterface& parameters,
                                   const std::string& topic_name, const rclcpp::QoS& default_qos,
                                   QosEntity entity) {
  const char* entity_name = entity == QosEntity::publisher ? "publisher" : "subscription";
  const std::string& id = options.get_id();
  const std::string prefix =
      "qos_overrides." + topic_name + "." + entity_name + (id.empty() ? "" : "_" + id) + ".";
  const std::string suffix = std::string("} for ") + entity_name + " {" + topic_name + "}" +
                             (id.empty() ? "" : " with id {" + id + "}");
  rclcpp::QoS qos = default_qos;
  const auto& kinds = options.get_policy_kinds();
  for (const QosPolicyKind policy : kOrder) {
    const bool wanted = std::find(kinds.begin(), kinds.end(), policy) != kinds.end();
    if (!wanted || (policy == QosPolicyKind::Lifespan && entity == QosEntity::subscription)) {
      continue;
    }
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = std::string("qos policy {") + qos_policy_kind_to_cstr(policy) + suffix;
    descriptor.read_only = true;
    const std::string name = prefix + qos_policy_kind_to_cstr(policy);
    apply(policy,
          parameters.has_parameter(name)
              ? parameters.get_parameter(name).get_parameter_value()
              : parameters.declare_parameter(name, value_of(policy, qos), descriptor),
          qos);
  }
  if (options.get_validation_callback()) {
    const auto result = options.get_validation_callback()(qos);
    if (!result.successful) {
      throw exceptions::InvalidQosOverridesException("validation callback failed: " +
                                                     result.reason);
    }
  }
  return qos;
}

}  // namespace detail
}  // namespace rclcpp
