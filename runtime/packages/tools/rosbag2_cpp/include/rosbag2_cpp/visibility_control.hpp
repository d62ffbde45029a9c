// Everything is visible: a program is linked whole.
#pragma once

#define ROSBAG2_CPP_PUBLIC
#define ROSBAG2_CPP_PUBLIC_TYPE
#define ROSBAG2_CPP_LOCAL
