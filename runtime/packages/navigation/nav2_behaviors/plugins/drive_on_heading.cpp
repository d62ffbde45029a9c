// See drive_on_heading.hpp.
#include "nav2_behaviors/plugins/drive_on_heading.hpp"

#include "pluginlib/class_list_macros.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_behaviors::DriveOnHeading<>, nav2_core::Behavior)
