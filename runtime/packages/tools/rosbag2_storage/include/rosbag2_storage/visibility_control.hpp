// Everything is visible: a program is linked whole.
#pragma once

#define ROSBAG2_STORAGE_PUBLIC
#define ROSBAG2_STORAGE_LOCAL
