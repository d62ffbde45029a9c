// A visitor's hand in the world: it holds a point of a link and draws it towards a place, or pushes
// it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/simulation.hpp"

namespace ros2wasm_sim {

class Drag {
 public:
  /// `now_ns`: the time that passes for the visitor, in nanoseconds. A world may run many times
  /// faster than that.
  Drag(Simulation& simulation, std::function<std::int64_t()> now_ns)
      : simulation_(simulation), now_ns_(std::move(now_ns)) {}

  /// Draws this point of the link, given in the link, to a place in the world, until release(). The
  /// hand says so again and again, also while it does not move: it lets go when nothing was heard
  /// of it for a second. False when the world has no such link that moves.
  bool hold(const std::string& model, const std::string& link, const Vector3& point,
            const Vector3& target);
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
    std::int64_t until_ns = 0;  ///< of the visitor's time
  };
  /// Nothing: it does not move.
  std::optional<Held> grip(const std::string& model, const std::string& link, const Vector3& point);

  Simulation& simulation_;
  std::function<std::int64_t()> now_ns_;
  std::optional<Held> held_;
};

/// The mass in kg of a link with all that fixed joints join to it.
double rigid_mass(const Model& model, const std::string& link);

}  // namespace ros2wasm_sim
