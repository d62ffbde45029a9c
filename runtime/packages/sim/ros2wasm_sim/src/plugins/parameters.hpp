// The elements that a plugin or a sensor reads: `<name>value</name>` with a default.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace ros2wasm_sim {

class Parameters {
 public:
  explicit Parameters(XmlView xml) : xml_(std::move(xml)) {}

  bool has(const std::string& name) const { return find(name) != nullptr; }
  std::string text(const std::string& name, const std::string& otherwise) const;
  /// A text that is not a finite number counts as missing.
  double number(const std::string& name, double otherwise) const;
  /// The number that this element itself holds.
  double own_number(double otherwise) const;
  /// `true`, `1` and `yes`, in any case.
  bool flag(const std::string& name, bool otherwise) const;
  std::vector<std::string> all(const std::string& name) const;
  /// Three numbers; missing ones are 0.
  Vector3 vector(const std::string& name) const;
  /// The elements inside of another one, which may be a path such as `scan/horizontal`. Those of a
  /// missing element are all missing.
  Parameters inside(const std::string& path) const;
  /// All elements of this name.
  std::vector<Parameters> each(const std::string& name) const;
  const XmlView& xml() const { return xml_; }
  const ros2wasm_xml::XmlElement* find(const std::string& name) const;

 private:
  XmlView xml_;
};

}  // namespace ros2wasm_sim
