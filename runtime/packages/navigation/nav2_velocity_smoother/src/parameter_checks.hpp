// The values that parameters of the smoother may have, without ROS.
#pragma once

#include <string>
#include <vector>

namespace nav2_velocity_smoother {

/// Messages differ between the two in the names of velocities.
enum class Moment { kConfigure, kChange };

/// A message when a number cannot be used for a parameter, else an empty text.
std::string check_number(const std::string& name, double value);
/// The same for three numbers: along x, along y, about z.
std::string check_axes(const std::string& name, const std::vector<double>& values, Moment moment);
std::string check_feedback(const std::string& value);

}  // namespace nav2_velocity_smoother
