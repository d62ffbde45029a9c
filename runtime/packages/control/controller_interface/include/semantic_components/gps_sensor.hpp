// A position on the earth, with or without covariances.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <type_traits>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/nav_sat_fix.hpp"

namespace semantic_components {

enum class GPSSensorOption { WithCovariance, WithoutCovariance };

template <GPSSensorOption sensor_option>
class GPSSensor : public SemanticComponentInterface<sensor_msgs::msg::NavSatFix> {
 public:
  explicit GPSSensor(const std::string& name)
      : SemanticComponentInterface(name, {{name + "/status"},
                                          {name + "/service"},
                                          {name + "/latitude"},
                                          {name + "/longitude"},
                                          {name + "/altitude"}}) {
    if constexpr (sensor_option == GPSSensorOption::WithCovariance) {
      interface_names_.emplace_back(name + "/latitude_covariance");
      interface_names_.emplace_back(name + "/longitude_covariance");
      interface_names_.emplace_back(name + "/altitude_covariance");
    }
  }

  int8_t get_status() const { return value_at<int8_t>(0, std::numeric_limits<int8_t>::max()); }
  uint16_t get_service() const {
    return value_at<uint16_t>(1, std::numeric_limits<uint16_t>::max());
  }
  double get_latitude() const { return value_at<double>(2, kNotANumber); }
  double get_longitude() const { return value_at<double>(3, kNotANumber); }
  double get_altitude() const { return value_at<double>(4, kNotANumber); }

  template <typename U = void,
            typename = std::enable_if_t<sensor_option == GPSSensorOption::WithCovariance, U>>
  const std::array<double, 9>& get_covariance() {
    covariance_[0] = value_at<double>(5, covariance_[0]);
    covariance_[4] = value_at<double>(6, covariance_[4]);
    covariance_[8] = value_at<double>(7, covariance_[8]);
    return covariance_;
  }
  bool get_values_as_message(sensor_msgs::msg::NavSatFix& message) {
    message.status.status = get_status();
    message.status.service = get_service();
    message.latitude = get_latitude();
    message.longitude = get_longitude();
    message.altitude = get_altitude();
    if constexpr (sensor_option == GPSSensorOption::WithCovariance) {
      message.position_covariance = get_covariance();
    }
    return true;
  }

 private:
  static constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

  template <typename T>
  T value_at(std::size_t index, T otherwise) const {
    const auto value = state_interfaces_[index].get().get_optional();
    return value ? static_cast<T>(*value) : otherwise;
  }

  std::array<double, 9> covariance_{};
};

}  // namespace semantic_components
