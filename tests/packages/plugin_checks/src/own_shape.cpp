// A plugin in the package of its base class.
#include "plugin_checks/shape.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace plugin_checks {

class Dot : public Shape {
 public:
  void initialize(double) override {}
  double area() override { return 0; }
};

}  // namespace plugin_checks

PLUGINLIB_EXPORT_CLASS(plugin_checks::Dot, plugin_checks::Shape)
