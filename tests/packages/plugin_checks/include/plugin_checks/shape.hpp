// What plugins are.
#pragma once

namespace plugin_checks {

class Shape {
 public:
  virtual ~Shape() { ++ended(); }
  virtual void initialize(double side) = 0;
  virtual double area() = 0;

  /// How many were destroyed.
  static int& ended();

 protected:
  Shape() = default;
};

}  // namespace plugin_checks
