// A world as SDF and URDF describe it, with all defaults filled in and all poses resolved: values
// that the physics, the plugins and the view read. SI units.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ros2wasm_xml/xml_document.hpp"
#include "world/geometry.hpp"

namespace ros2wasm_sim {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Color {
  double r = 1;
  double g = 1;
  double b = 1;
  double a = 1;
};

/// An element that its plugin or sensor reads, with the document that owns it.
struct XmlView {
  std::shared_ptr<const ros2wasm_xml::XmlDocument> document;
  const ros2wasm_xml::XmlElement* element = nullptr;
};

struct Box {
  Vector3 size;
};
struct Cylinder {
  double radius = 0;
  double length = 0;
};
struct Sphere {
  double radius = 0;
};
/// `length` is that of the cylinder between the two half spheres.
struct Capsule {
  double radius = 0;
  double length = 0;
};
struct Ellipsoid {
  Vector3 radii;
};
/// Infinite for contacts; drawn as a rectangle of this size.
struct Plane {
  Vector3 normal{0, 0, 1};
  double width = 1;
  double height = 1;
};
struct Mesh {
  std::string uri;   ///< as written
  std::string path;  ///< the file that was found; empty when none was
  Vector3 scale{1, 1, 1};
  std::string submesh;  ///< empty: the whole file
  bool center_submesh = false;
};
struct Heightmap {
  std::string uri;
  std::string path;
  Vector3 size{1, 1, 1};
  Vector3 position;
};
struct NoGeometry {};
using Geometry =
    std::variant<NoGeometry, Box, Cylinder, Sphere, Capsule, Ellipsoid, Plane, Mesh, Heightmap>;

/// How a shape touches others: the smaller friction of a pair counts, as in Gazebo.
struct Surface {
  double mu = 1;
  double mu2 = 1;
  Vector3 fdir1;            ///< the direction of `mu`; zero: `mu` counts in all directions
  std::string fdir1_frame;  ///< the link whose axes `fdir1` has; empty: those of the collision
  double torsional = 1;
  double restitution = 0;
  std::uint32_t category_bitmask = 0xffff;
  std::uint32_t collide_bitmask = 0xffff;
  bool collide_without_contact = false;
};

struct Material {
  Color ambient{0.7, 0.7, 0.7, 1};
  Color diffuse{0.7, 0.7, 0.7, 1};
  Color specular{0, 0, 0, 1};
  Color emissive{0, 0, 0, 1};
  double roughness = 0.5;
  double metalness = 0;
  std::string texture;    ///< the file of the colours that was found, or empty
  bool is_given = false;  ///< it wins over the colours that a mesh file has
};

struct Collision {
  std::string name;
  Pose pose;  ///< in the link
  Geometry geometry;
  Surface surface;
};

struct Visual {
  std::string name;
  Pose pose;  ///< in the link
  Geometry geometry;
  Material material;
  double transparency = 0;
  bool cast_shadows = true;
};

/// Moments are about the centre of mass, along the axes of `pose`.
struct Inertial {
  double mass = 1;
  Pose pose;  ///< in the link
  double ixx = 1, iyy = 1, izz = 1;
  double ixy = 0, ixz = 0, iyz = 0;
};

struct Plugin {
  std::string name;
  std::string filename;
  XmlView xml;
  std::string model_scope;      ///< `inner::` of a nested model, whose names it writes without
  std::string robot_namespace;  ///< of the request that spawned it; it replaces <ros><namespace>
};

struct Sensor {
  std::string name;
  std::string type;        ///< as written, such as ray, gpu_lidar, imu
  Pose pose;               ///< in the link
  double update_rate = 0;  ///< Hz of simulated time; 0: each step
  bool always_on = false;
  bool visualize = false;
  std::string topic;
  std::string frame_id;  ///< <gz_frame_id> or <ignition_frame_id>; empty when not given
  XmlView xml;
  std::vector<Plugin> plugins;
};

struct Light {
  std::string name;
  std::string type = "point";  ///< point, directional or spot
  Pose pose;                   ///< in the world, or in its link
  Color diffuse;
  Color specular{0.1, 0.1, 0.1, 1};
  Vector3 direction{0, 0, -1};
  double range = 10;  ///< metres; nothing further away is lit
  /// It fades with the distance d as 1 / (constant + linear d + quadratic d^2); not a directional
  /// one.
  double constant = 1, linear = 1, quadratic = 0;
  double intensity = 1;
  double inner_angle = 0, outer_angle = 0;
  bool cast_shadows = false;
};

struct Link {
  std::string name;  ///< `inner::link` for one of a nested model
  Pose pose;         ///< in the model
  Inertial inertial;
  bool gravity = true;
  bool kinematic = false;
  bool self_collide = false;
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
  std::vector<Sensor> sensors;
  std::vector<Light> lights;
};

enum class JointType { kFixed, kRevolute, kPrismatic, kBall, kUniversal, kRevolute2, kScrew };

struct Mimic {
  std::string joint;
  double multiplier = 1;
  double offset = 0;
  double reference = 0;
};

struct JointAxis {
  Vector3 xyz{0, 0, 1};  ///< of length 1, in the frame of the joint
  double lower = -kInfinity;
  double upper = kInfinity;
  double effort = kInfinity;
  double velocity = kInfinity;
  double damping = 0;
  double friction = 0;
  double spring_stiffness = 0;
  double spring_reference = 0;
  std::optional<Mimic> mimic;
};

struct Joint {
  std::string name;
  JointType type = JointType::kFixed;
  std::string parent;  ///< a link of the model, or `world`
  std::string child;
  Pose pose;  ///< in the child link
  std::vector<JointAxis> axes;
  double thread_pitch = 1;  ///< of screws, in metres a turn
  std::vector<Sensor> sensors;
};

/// A name with a place: SDF's <frame>, and what fixed joints of a URDF leave when they are lumped.
struct Frame {
  std::string name;
  std::string link;  ///< that it moves with
  Pose pose;         ///< in that link
};

struct Model {
  std::string name;
  Pose pose;  ///< in the world
  bool is_static = false;
  bool self_collide = false;
  std::string canonical_link;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Plugin> plugins;
};

struct PhysicsSettings {
  double max_step_size = 0.001;  ///< seconds
  double real_time_factor = 1;   ///< as written, for Gazebo Sim; 0: as fast as possible
  /// Hz, for Gazebo Classic, whose factor is this times the step; 0: as fast as possible. Nothing
  /// when it is not given: 1000.
  std::optional<double> real_time_update_rate;
};

struct SphericalCoordinates {
  double latitude_deg = 0;
  double longitude_deg = 0;
  double elevation = 0;
  double heading_deg = 0;
};

struct Scene {
  Color ambient{0.4, 0.4, 0.4, 1};
  Color background{0.7, 0.7, 0.7, 1};
  bool shadows = true;
  bool grid = true;
};

struct World {
  std::string name = "default";
  Vector3 gravity{0, 0, -9.8};
  Vector3 magnetic_field{5.5645e-6, 22.8758e-6, -42.3884e-6};  ///< tesla
  PhysicsSettings physics;
  Scene scene;
  std::optional<SphericalCoordinates> spherical;
  std::vector<Model> models;
  std::vector<Light> lights;
  std::vector<Plugin> plugins;
};

}  // namespace ros2wasm_sim
