// Names of the usual interfaces.
#pragma once

namespace hardware_interface {

constexpr char HW_IF_POSITION[] = "position";
constexpr char HW_IF_VELOCITY[] = "velocity";
constexpr char HW_IF_ACCELERATION[] = "acceleration";
constexpr char HW_IF_EFFORT[] = "effort";
constexpr char HW_IF_TORQUE[] = "torque";
constexpr char HW_IF_FORCE[] = "force";
constexpr char HW_IF_CURRENT[] = "current";
constexpr char HW_IF_TEMPERATURE[] = "temperature";
constexpr char HW_IF_PROPORTIONAL_GAIN[] = "proportional";
constexpr char HW_IF_INTEGRAL_GAIN[] = "integral";
constexpr char HW_IF_DERIVATIVE_GAIN[] = "derivative";
constexpr char HW_IF_INTEGRAL_CLAMP_MAX[] = "integral_clamp_max";
constexpr char HW_IF_INTEGRAL_CLAMP_MIN[] = "integral_clamp_min";
constexpr char HW_IF_FEEDFORWARD[] = "feedforward";

}  // namespace hardware_interface
