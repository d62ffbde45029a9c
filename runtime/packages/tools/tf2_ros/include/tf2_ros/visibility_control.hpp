// Upstream's macro for exported symbols. Here everything is linked statically.
#pragma once

#define TF2_ROS_EXPORT
#define TF2_ROS_IMPORT
#define TF2_ROS_PUBLIC
#define TF2_ROS_LOCAL
#define TF2_ROS_PUBLIC_TYPE
