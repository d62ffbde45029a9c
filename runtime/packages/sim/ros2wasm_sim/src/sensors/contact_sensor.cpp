// See contact_sensor.hpp.
#include "sensors/contact_sensor.hpp"

#include <algorithm>
#include <utility>

#include "plugins/parameters.hpp"
#include "sdf/nearest_name.hpp"

namespace ros2wasm_sim {

ContactSensor::ContactSensor(const Sensor& sensor, Physics& physics, const std::string& model,
                             const Link& link)
    : physics_(physics) {
  physics.watch_contacts();
  std::vector<std::string> known;
  for (const Collision& collision : link.collisions) known.push_back(collision.name);
  const std::string who = "contact sensor [" + sensor.name + "]: ";
  for (const Parameters& contact : Parameters(sensor.xml).each("contact"))
    for (const std::string& name : contact.all("collision")) {
      if (std::find(known.begin(), known.end(), name) != known.end()) {
        collisions_.push_back(model + "::" + link.name + "::" + name);
        continue;
      }
      const std::string nearest = nearest_name(name, known);
      warnings_.push_back(who + "the link [" + link.name + "] has no collision [" + name + "]" +
                          (nearest.empty() ? "" : ": did you mean [" + nearest + "]?"));
    }
  if (collisions_.empty() && warnings_.empty())
    warnings_.push_back(who +
                        "it names no collision, so it never reports one: add "
                        "<contact><collision>NAME</collision></contact>");
}

bool ContactSensor::is_own(std::string_view collision) const {
  return std::find(collisions_.begin(), collisions_.end(), collision) != collisions_.end();
}

std::vector<Contact> ContactSensor::touching() const {
  std::vector<Contact> result;
  if (collisions_.empty()) return result;
  for (Contact& contact : physics_.contacts()) {
    if (is_own(contact.second)) result.push_back(from_other_side(contact));
    if (is_own(contact.first)) result.push_back(std::move(contact));
  }
  return result;
}

Contact from_other_side(const Contact& contact) {
  Contact result{contact.second, contact.first, contact.points};
  for (ContactPoint& point : result.points) {
    point.normal = -1.0 * point.normal;
    point.wrench = {-1.0 * point.wrench.force, -1.0 * point.wrench.torque};
  }
  return result;
}

}  // namespace ros2wasm_sim
