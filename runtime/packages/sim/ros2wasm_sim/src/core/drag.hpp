// A visitor's hand in the world: it holds a point of a link and draws it towards a place, or pushes
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/simulation.hpp"

namespace ros2wasm_sim {

class Drag {
 public:
  explicit Drag(Simulation& simulation) : simulation_(simulation) {}

  /// Holds this point of the link, given in the link, until release(). False when the world has no
  /// such link that moves.
  bool hold(const std::string& model, const std::string& link, const Vector3& point,
            const Vector3& target);
  /// Where the held point is to come, in the world. A hand that hears nothing for a second of
  /// simulated time lets go.
  void move(const Vector3& target);
  void release() { held_.reset(); }
  /// Changes the velocity of the link by this much at that point, as if the link were free, in m/s.
  bool push(const std::string& model, const std::string& link, const Vector3& point,
            const Vector3& velocity);

  /// Before each step.
  void act();

 private:
  struct Held {
    LinkHandle link;
    Vector3 point;   ///< in the link
    Vector3 target;  ///< in the world
    double mass = 0;
    std::int64_t until_ns = 0;
  };
  /// Nothing: it does not move.
  std::optional<Held> grip(const std::string& model, const std::string& link, const Vector3& point);

  Simulation& simulation_;
  std::optional<Held> held_;
};

/// The mass in kg of a link with all that fixed joints join to it.
double rigid_mass(const Model& model, const std::string& link);

}  // namespace ros2wasm_sim
