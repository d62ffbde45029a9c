// The engine of the simulation, behind one interface. Links and joints have handles that stay valid
// when models come and go; those of a removed model answer as if they rested at the origin.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

/// The engine cannot take the world, or its state is not finite any more; the text is for people.
class PhysicsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LinkHandle {
  int index = -1;
  bool valid() const { return index >= 0; }
};
struct JointHandle {
  int index = -1;
  bool valid() const { return index >= 0; }
};

/// Along the axes of the world, at the origin of the link.
struct Motion {
  Vector3 linear;   ///< m/s, or m/s^2
  Vector3 angular;  ///< rad/s, or rad/s^2
};

struct Wrench {
  Vector3 force;   ///< N
  Vector3 torque;  ///< N m
};

/// A point where two collisions touch, in the world, as in Gazebo: normals and wrenches are those
/// that push the first collision away from the second.
struct ContactPoint {
  Vector3 position;
  Vector3 normal;    ///< of length 1, into the first collision
  double depth = 0;  ///< metres
  Wrench wrench;     ///< on the first collision, about `position`
};
/// Names are `model::link::collision`; they are valid until the next step or world.
struct Contact {
  std::string_view first, second;
  std::vector<ContactPoint> points;
};

/// Which shapes a ray meets: those that collide, or those that are seen.
enum class RaySees { kCollisions, kVisuals };

struct Ray {
  Vector3 origin;
  Vector3 direction;  ///< of length 1
};

class Physics {
 public:
  virtual ~Physics() = default;

  /// Takes a world in place of the present one. What has the same names goes on where it was, the
  /// rest begins at its pose. Throws PhysicsError, and then goes on with the world that it had.
  virtual void set_world(const World& world) = 0;

  /// Shapes and joints that the engine does not have, each said once.
  virtual std::vector<std::string> take_warnings() = 0;

  virtual double step_size() const = 0;  ///< seconds
  /// Throws PhysicsError when the state is not finite; it names the model.
  virtual void step() = 0;
  /// All poses and velocities as the world describes them.
  virtual void reset() = 0;

  /// The handle is invalid if the world has no such link or joint.
  virtual LinkHandle link(const std::string& model, const std::string& link) = 0;
  virtual JointHandle joint(const std::string& model, const std::string& joint) = 0;

  virtual Pose pose(LinkHandle link) const = 0;  ///< in the world
  virtual Motion velocity(LinkHandle link) const = 0;
  /// The acceleration that an accelerometer at the link's origin feels: at rest, the opposite of
  /// gravity.
  virtual Motion proper_acceleration(LinkHandle link) = 0;

  virtual double position(JointHandle joint) const = 0;  ///< rad or m
  virtual double velocity(JointHandle joint) const = 0;
  virtual double effort(JointHandle joint) const = 0;  ///< N m or N, of the motor

  // Commands that are not finite are ignored.

  /// A motor that holds a velocity with at most this effort, until another command.
  virtual void set_motor(JointHandle joint, double velocity, double max_effort) = 0;
  /// The joint has no motor any more.
  virtual void release_motor(JointHandle joint) = 0;
  /// Puts the joint there at once, at rest.
  virtual void set_position(JointHandle joint, double position) = 0;
  /// The joint has this velocity at once. Forces change it from then on.
  virtual void set_velocity(JointHandle joint, double velocity) = 0;
  /// Acts in the next step only, and adds to the other efforts of that step. The joint's own limit
  /// bounds it.
  virtual void add_effort(JointHandle joint, double effort) = 0;
  /// As the world describes it; infinity when it gives no limit.
  virtual double effort_limit(JointHandle joint) const = 0;

  /// A force at a point of the world, and a torque. Both act along the axes of the world in the
  /// next step only, and add to others.
  virtual void add_wrench(LinkHandle link, const Vector3& force, const Vector3& torque,
                          const Vector3& point) = 0;
  virtual Vector3 centre_of_mass(LinkHandle link) const = 0;  ///< in the world

  /// Holds two links together as they are now, until detach(). False when too many are held
  /// already.
  virtual bool attach(LinkHandle parent, LinkHandle child) = 0;
  virtual void detach(LinkHandle parent, LinkHandle child) = 0;

  /// Moves a model at once; it rests then when `at_rest`.
  virtual bool set_model_pose(const std::string& model, const Pose& pose, bool at_rest) = 0;
  /// Sets the velocity of a model's root, along the axes of the world.
  virtual bool set_model_velocity(const std::string& model, const Motion& velocity) = 0;
  /// Metres to what each ray meets first, or infinity. Nothing of `exclude` is met.
  virtual void cast(const std::vector<Ray>& rays, RaySees sees, LinkHandle exclude,
                    std::vector<double>& distances) = 0;

  /// False: no shape is nearer to the point than this. Nothing of `exclude` counts. True may be
  /// wrong for meshes, whose bounding sphere counts.
  virtual bool is_near(const Vector3& point, double distance, RaySees sees,
                       LinkHandle exclude) const = 0;

  /// contacts() and wrench() are measured from the next step on.
  virtual void watch_contacts() = 0;
  virtual void watch_wrench(LinkHandle child) = 0;
  /// The collisions that touched in the last step, each pair once.
  virtual std::vector<Contact> contacts() const = 0;
  /// The wrench in the joint of a link in the last step: how its parent acts on it, along the axes
  /// of the link and about its origin.
  virtual Wrench wrench(LinkHandle child) const = 0;

  /// A digest of all positions and velocities.
  virtual std::uint64_t state_hash() const = 0;
};

std::unique_ptr<Physics> make_physics(MeshReader meshes);

}  // namespace ros2wasm_sim
