// The pairs of types that are not the same message on both sides.
#pragma once

#include "type_pairs.hpp"

namespace ros_gz_bridge {

extern const Conversion kPointVector3;
extern const Conversion kPoseStampedPose;
extern const Conversion kTransformPose;
extern const Conversion kTransformStampedPose;
extern const Conversion kPoseArrayTransforms;
extern const Conversion kPoseCovarianceStamped;
extern const Conversion kTwistStampedTwist;
extern const Conversion kTwistCovarianceStamped;
extern const Conversion kWrenchWrenchStamped;
extern const Conversion kGpsFixNavSat;
extern const Conversion kRangeLaserScan;

}  // namespace ros_gz_bridge
