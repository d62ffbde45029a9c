// See motion_model.hpp.
#include "filter/motion_model.hpp"

namespace robot_localization {
namespace {

/// Below it the rates of roll and yaw have no limit; they are cut off there.
constexpr double kLeastCosineOfPitch = 1e-6;

struct Attitude {
  double sin_roll, cos_roll, sin_pitch, cos_pitch, tan_pitch, sin_yaw, cos_yaw;

  explicit Attitude(const State& state)
      : sin_roll(std::sin(state(kRoll))),
        cos_roll(std::cos(state(kRoll))),
        sin_pitch(std::sin(state(kPitch))),
        cos_pitch(std::cos(state(kPitch))),
        sin_yaw(std::sin(state(kYaw))),
        cos_yaw(std::cos(state(kYaw))) {
    if (std::abs(cos_pitch) < kLeastCosineOfPitch) {
      cos_pitch = std::copysign(kLeastCosineOfPitch, cos_pitch);
    }
    tan_pitch = sin_pitch / cos_pitch;
  }

  Eigen::Matrix3d world_from_base() const {
    Eigen::Matrix3d result;
    result << cos_yaw * cos_pitch, cos_yaw * sin_pitch * sin_roll - sin_yaw * cos_roll,
        cos_yaw * sin_pitch * cos_roll + sin_yaw * sin_roll,  //
        sin_yaw * cos_pitch, sin_yaw * sin_pitch * sin_roll + cos_yaw * cos_roll,
        sin_yaw * sin_pitch * cos_roll - cos_yaw * sin_roll,  //
        -sin_pitch, cos_pitch * sin_roll, cos_pitch * cos_roll;
    return result;
  }

  /// Rates of roll, pitch and yaw from the angular velocity of the body.
  Eigen::Matrix3d rates_from_body() const {
    Eigen::Matrix3d result;
    result << 1.0, sin_roll * tan_pitch, cos_roll * tan_pitch,  //
        0.0, cos_roll, -sin_roll,                               //
        0.0, sin_roll / cos_pitch, cos_roll / cos_pitch;
    return result;
  }
};

}  // namespace

State advanced(const State& state, double dt) {
  const Attitude attitude(state);
  State result = state;
  const Eigen::Vector3d way = state.segment<3>(kVx) * dt + state.segment<3>(kAx) * (0.5 * dt * dt);
  result.segment<3>(kX) += attitude.world_from_base() * way;
  result.segment<3>(kRoll) += attitude.rates_from_body() * state.segment<3>(kVroll) * dt;
  result.segment<3>(kVx) += state.segment<3>(kAx) * dt;
  return result;
}

Covariance advance_jacobian(const State& state, double dt) {
  const Attitude at(state);
  const Eigen::Matrix3d rotation = at.world_from_base();
  const Eigen::Matrix3d rates = at.rates_from_body();
  Covariance result = Covariance::Identity();
  result.block<3, 3>(kX, kVx) = rotation * dt;
  result.block<3, 3>(kX, kAx) = rotation * (0.5 * dt * dt);
  result.block<3, 3>(kRoll, kVroll) = rates * dt;
  result.block<3, 3>(kVx, kAx) = Eigen::Matrix3d::Identity() * dt;

  // A rotation by a small angle moves a vector along the cross product with its axis.
  const Eigen::Vector3d way = state.segment<3>(kVx) * dt + state.segment<3>(kAx) * (0.5 * dt * dt);
  const Eigen::Vector3d moved = rotation * way;
  const Eigen::Vector3d pitch_axis(-at.sin_yaw, at.cos_yaw, 0.0);
  result.block<3, 1>(kX, kRoll) = rotation * Eigen::Vector3d::UnitX().cross(way);
  result.block<3, 1>(kX, kPitch) = pitch_axis.cross(moved);
  result.block<3, 1>(kX, kYaw) = Eigen::Vector3d::UnitZ().cross(moved);

  const double pitching = state(kVpitch);
  const double yawing = state(kVyaw);
  const double across = at.cos_roll * pitching - at.sin_roll * yawing;
  const double along = at.sin_roll * pitching + at.cos_roll * yawing;
  result.block<3, 1>(kRoll, kRoll) +=
      Eigen::Vector3d(across * at.tan_pitch, -along, across / at.cos_pitch) * dt;
  result.block<3, 1>(kRoll, kPitch) += Eigen::Vector3d(along / (at.cos_pitch * at.cos_pitch), 0.0,
                                                       along * at.tan_pitch / at.cos_pitch) *
                                       dt;
  return result;
}

}  // namespace robot_localization
