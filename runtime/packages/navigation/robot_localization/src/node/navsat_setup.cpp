// See navsat_transform.hpp: parameters, topics and services.
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "filter/state.hpp"
#include "node/navsat_transform.hpp"

namespace robot_localization {
namespace {

template <typename Message>
GeoPoint geo_of(const Message& message) {
  return {message.latitude, message.longitude, message.altitude};
}

void copy_to(const GeoPoint& from, geographic_msgs::msg::GeoPoint& to) {
  to.latitude = from.latitude;
  to.longitude = from.longitude;
  to.altitude = from.altitude;
}

void copy_to(const Eigen::Vector3d& from, geometry_msgs::msg::Point& to) {
  to.x = from.x();
  to.y = from.y();
  to.z = from.z();
}

}  // namespace

NavSatTransform::NavSatTransform()
    : rclcpp::Node("navsat_transform_node"), transforms_(*this), broadcaster_(*this) {
  read_parameters();
  create_services();
  subscribe();
  rclcpp::PublisherOptions options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  odometry_publisher_ = create_publisher<Odometry>("odometry/gps", rclcpp::QoS(10), options);
  if (publishes_gps_) {
    fix_publisher_ = create_publisher<Fix>("gps/filtered", rclcpp::QoS(10), options);
  }
  const auto delay = std::chrono::duration<double>(declare_parameter("delay", 0.0));
  rclcpp::sleep_for(std::chrono::duration_cast<std::chrono::seconds>(delay));
  timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / frequency_), [this] { update(); });
}

void NavSatTransform::read_parameters() {
  magnetic_declination_ = declare_parameter("magnetic_declination_radians", 0.0);
  yaw_offset_ = declare_parameter("yaw_offset", 0.0);
  is_flat_ = declare_parameter("zero_altitude", false);
  publishes_gps_ = declare_parameter("publish_filtered_gps", true);
  uses_odometry_yaw_ = declare_parameter("use_odometry_yaw", false);
  const bool waits_for_datum = declare_parameter("wait_for_datum", false);
  cartesian_ = std::make_unique<CartesianFrame>(declare_parameter("use_local_cartesian", false));
  frequency_ = declare_parameter("frequency", 10.0);
  if (!(frequency_ > 0.0 && frequency_ <= 1000.0)) {
    throw std::invalid_argument("frequency must be greater than 0 and at most 1000 Hz");
  }
  transform_timeout_ = declare_parameter("transform_timeout", 0.0);
  const auto renamed = [this](const std::string& old_name, const std::string& name) {
    if (!declare_parameter(old_name, false)) return declare_parameter(name, false);
    RCLCPP_WARN(get_logger(), "Parameter '%s' has been deprecated. Please use '%s' instead.",
                old_name.c_str(), name.c_str());
    return true;
  };
  broadcasts_ = renamed("broadcast_utm_transform", "broadcast_cartesian_transform");
  broadcasts_as_parent_ = renamed("broadcast_utm_transform_as_parent_frame",
                                  "broadcast_cartesian_transform_as_parent_frame");
  if (!waits_for_datum) return;
  auto values = declare_parameter("datum", std::vector<double>{});
  values.resize(values.size() == 3 ? 3 : 0);
  values.resize(3, 0.0);
  datum_ = Datum{{values[0], values[1], 0.0}, quaternion_of(0.0, 0.0, values[2])};
}

void NavSatTransform::create_services() {
  using srv::FromLL, srv::FromLLArray, srv::SetDatum, srv::SetUTMZone, srv::ToLL, srv::ToLLArray;
  services_.push_back(create_service<SetDatum>(
      "datum", [this](const SetDatum::Request::SharedPtr request, SetDatum::Response::SharedPtr) {
        // From now on, positions are never the datum.
        datum_ = Datum{
            geo_of(request->geo_pose.position),
            rotation_of(request->geo_pose.orientation).value_or(Eigen::Quaterniond::Identity())};
        world_from_cartesian_.reset();
      }));
  services_.push_back(create_service<ToLL>(
      "toLL", [this](const ToLL::Request::SharedPtr request, ToLL::Response::SharedPtr response) {
        answer_to_geo(request->map_point, response->ll_point);
      }));
  services_.push_back(create_service<FromLL>(
      "fromLL",
      [this](const FromLL::Request::SharedPtr request, FromLL::Response::SharedPtr response) {
        answer_from_geo(request->ll_point, response->map_point);
      }));
  services_.push_back(create_service<ToLLArray>(
      "toLLArray",
      [this](const ToLLArray::Request::SharedPtr request, ToLLArray::Response::SharedPtr response) {
        for (const auto& point : request->map_points) {
          answer_to_geo(point, response->ll_points.emplace_back());
        }
      }));
  services_.push_back(create_service<FromLLArray>(
      "fromLLArray", [this](const FromLLArray::Request::SharedPtr request,
                            FromLLArray::Response::SharedPtr response) {
        for (const auto& place : request->ll_points) {
          answer_from_geo(place, response->map_points.emplace_back());
        }
      }));
  services_.push_back(create_service<SetUTMZone>(
      "setUTMZone", [this](const SetUTMZone::Request::SharedPtr request,
                           SetUTMZone::Response::SharedPtr) { set_zone(request->utm_zone); }));
}

void NavSatTransform::subscribe() {
  const auto qos = rclcpp::SensorDataQoS(rclcpp::KeepLast(1));
  rclcpp::SubscriptionOptions options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  subscriptions_.push_back(create_subscription<Odometry>(
      "odometry/filtered", qos, [this](const Odometry& message) { on_odometry(message); },
      options));
  subscriptions_.push_back(create_subscription<Fix>(
      "gps/fix", qos, [this](const Fix& message) { on_fix(message); }, options));
  if (!datum_) subscribe_imu();
}

void NavSatTransform::subscribe_imu() {
  if (uses_odometry_yaw_) return;
  rclcpp::SubscriptionOptions options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  imu_subscription_ = create_subscription<Imu>(
      "imu", rclcpp::SensorDataQoS(rclcpp::KeepLast(1)),
      [this](const Imu& message) { on_imu(message); }, options);
}

void NavSatTransform::answer_to_geo(const geometry_msgs::msg::Point& point,
                                    geographic_msgs::msg::GeoPoint& place) const {
  if (const auto found = to_geo(vector_of(point))) {
    copy_to(*found, place);
  } else if (!world_from_cartesian_) {
    RCLCPP_ERROR(get_logger(), "No transform available (yet)");
  } else {
    RCLCPP_ERROR(get_logger(), "The point (%g, %g, %g) is not a place on the globe", point.x,
                 point.y, point.z);
  }
}

void NavSatTransform::answer_from_geo(const geographic_msgs::msg::GeoPoint& place,
                                      geometry_msgs::msg::Point& point) const {
  if (const auto found = from_geo(geo_of(place))) {
    copy_to(*found, point);
  } else if (!world_from_cartesian_) {
    RCLCPP_ERROR(get_logger(), "No transform available (yet)");
  } else if (const auto point_or_error = cartesian_->from_geo(geo_of(place));
             const auto* error = std::get_if<std::string>(&point_or_error)) {
    RCLCPP_ERROR(get_logger(), "%s", error->c_str());
  }
}

void NavSatTransform::set_zone(const std::string& name) {
  if (const auto error = cartesian_->set_zone(name)) {
    RCLCPP_ERROR(get_logger(), "%s", error->c_str());
    return;
  }
  datum_.reset();
  world_from_cartesian_.reset();
  first_position_.reset();
  position_.reset();
  // The robot may have moved and turned since the transform was computed.
  first_pose_.reset();
  orientation_.reset();
  subscribe_imu();
  RCLCPP_INFO(get_logger(), "UTM zone set to %d %s", cartesian_->zone(),
              cartesian_->is_north() ? "north" : "south");
}

}  // namespace robot_localization
