// See force_torque.hpp.
#include "sensors/force_torque.hpp"

#include <algorithm>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {

ForceTorque::ForceTorque(const Sensor& sensor, Physics& physics, const std::string& model,
                         const Joint& joint, std::uint64_t seed)
    : physics_(physics),
      child_(physics.link(model, joint.child)),
      parent_(physics.link(model, joint.parent)),
      pose_(joint.pose * sensor.pose),
      random_(seed, model + "::" + joint.name + "::" + sensor.name),
      name_(sensor.name) {
  physics.watch_wrench(child_);
  const Parameters given = Parameters(sensor.xml).inside("force_torque");
  const std::string frame = one_of(given, "frame", {"child", "parent", "sensor"});
  if (frame == "parent") frame_ = Frame::kParent;
  if (frame == "sensor") frame_ = Frame::kSensor;
  is_on_child_ = one_of(given, "measure_direction", {"child_to_parent", "parent_to_child"}) ==
                 "parent_to_child";
  force_noise_ = AxesNoise::read(given.inside("force"), random_);
  torque_noise_ = AxesNoise::read(given.inside("torque"), random_);
}

std::string ForceTorque::one_of(const Parameters& given, const char* element,
                                const std::vector<std::string>& values) {
  const std::string text = given.text(element, values.front());
  if (std::find(values.begin(), values.end(), text) != values.end()) return text;
  std::string known;
  for (const std::string& value : values) known += (known.empty() ? "" : ", ") + value;
  warnings_.push_back("force_torque sensor [" + name_ + "]: <" + element + "> [" + text +
                      "] does not exist, so " + values.front() + " counts; values are " + known);
  return values.front();
}

Wrench ForceTorque::measure() {
  const Wrench on_child = about(pose_.position, physics_.wrench(child_));
  Quaternion turn;
  switch (frame_) {
    case Frame::kChild:
      break;
    case Frame::kParent:
      turn = inverse(physics_.pose(parent_).orientation) * physics_.pose(child_).orientation;
      break;
    case Frame::kSensor:
      turn = inverse(pose_.orientation);
      break;
  }
  const double sign = is_on_child_ ? 1 : -1;
  return {force_noise_.apply(sign * rotate(turn, on_child.force), random_),
          torque_noise_.apply(sign * rotate(turn, on_child.torque), random_)};
}

}  // namespace ros2wasm_sim
