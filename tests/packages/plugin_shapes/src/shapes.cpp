// Two plugins in one library.
#include "plugin_checks/shape.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace plugin_shapes {

double root_of_three();

class Square : public plugin_checks::Shape {
 public:
  void initialize(double side) override { side_ = side; }
  double area() override { return side_ * side_; }

 private:
  double side_ = 0;
};

class Triangle : public plugin_checks::Shape {
 public:
  void initialize(double side) override { side_ = side; }
  double area() override { return root_of_three() / 4 * side_ * side_; }

 private:
  double side_ = 0;
};

}  // namespace plugin_shapes

PLUGINLIB_EXPORT_CLASS(plugin_shapes::Square, plugin_checks::Shape)
PLUGINLIB_EXPORT_CLASS(plugin_shapes::Triangle, plugin_checks::Shape)
