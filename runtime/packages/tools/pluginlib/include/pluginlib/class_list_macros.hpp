// PLUGINLIB_EXPORT_CLASS(Derived, Base), once per class, in a source file of its library.
#pragma once

#include "class_loader/class_loader.hpp"

#define PLUGINLIB_EXPORT_CLASS(class_type, base_class_type) \
  CLASS_LOADER_REGISTER_CLASS(class_type, base_class_type)
