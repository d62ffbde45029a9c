// Chains and trees of KDL in a node, from a robot's description, and their types in messages.

// Compatibility, works: KDL (`orocos_kdl`, `orocos_kdl_vendor`): frames, chains, trees, solvers of
// position, velocity, inverse kinematics and dynamics; kdl_parser; tf2_kdl; tf2_eigen_kdl

// Compatibility, differs: `tf2::gmTransformToKDL` of tf2_geometry_msgs -> there when the package asks
// for KDL too (`orocos_kdl_vendor`, tf2_kdl), so that the others carry nothing of it; KDL is version
// 1.5.1, and has no module for Python

#include <Eigen/Geometry>
#include <cmath>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/frames_io.hpp>
#include <kdl/tree.hpp>
#include <sstream>

#include "checks.hpp"
#include "kdl_parser/kdl_parser.hpp"
#include "tf2_eigen_kdl/tf2_eigen_kdl.hpp"
#include "tf2_kdl/tf2_kdl.hpp"
#include "tf2_ros/buffer.h"

namespace {

constexpr double kNear = 1e-9;

/// Two bars of one metre that turn about z, a hand that slides along z, and a tool beside it.
constexpr const char* kRobot = R"(<robot name="scara">
  <link name="base"/> <link name="hand"/> <link name="tool"/>
  <link name="upper"><inertial><origin xyz="0.5 0 0" rpy="0 0 1.5707963267948966"/><mass value="2"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/></inertial></link>
  <link name="fore"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="fore"/>
    <origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="lift" type="prismatic"><parent link="fore"/><child link="hand"/>
    <origin xyz="1 0 0"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="grip" type="fixed"><parent link="hand"/><child link="tool"/><origin xyz="0 0 0.5"/></joint>
</robot>)";

void check_chain(Checks& checks) {
  KDL::Tree tree;
  CHECK(!kdl_parser::treeFromString("<robot", tree));
  CHECK(!kdl_parser::treeFromFile("/nowhere.urdf", tree));
  CHECK(kdl_parser::treeFromString(kRobot, tree));
  CHECK(tree.getNrOfSegments() == 4 && tree.getNrOfJoints() == 3);
  KDL::Chain chain;
  CHECK(!tree.getChain("base", "nobody", chain));
  CHECK(tree.getChain("base", "tool", chain) && chain.getNrOfJoints() == 3);
  CHECK(chain.getSegment(3).getName() == "tool" &&
        chain.getSegment(3).getJoint().getType() == KDL::Joint::None);

  KDL::JntArray joints(3);
  joints(0) = 0.3;
  joints(1) = M_PI_2;
  joints(2) = 0.25;
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::Frame place;
  CHECK(forward.JntToCart(joints, place) == 0);
  const KDL::Vector expected(std::cos(0.3) - std::sin(0.3), std::sin(0.3) + std::cos(0.3), 0.75);
  CHECK(KDL::Equal(place.p, expected, kNear));
  CHECK(KDL::Equal(place.M, KDL::Rotation::RotZ(0.3 + M_PI_2), kNear));

  KDL::ChainJntToJacSolver jacobians(chain);
  KDL::Jacobian jacobian(3);
  CHECK(jacobians.JntToJac(joints, jacobian) == 0);
  CHECK(std::abs(jacobian(0, 0) + place.p.y()) < kNear && std::abs(jacobian(2, 2) - 1) < kNear);

  KDL::ChainIkSolverVel_pinv velocities(chain);
  KDL::ChainIkSolverPos_NR newton(chain, forward, velocities, 200, 1e-10);
  KDL::JntArray near = joints;
  near(0) += 0.2;
  near(1) -= 0.3;
  KDL::JntArray found(3);
  CHECK(newton.CartToJnt(near, place, found) >= 0);
  CHECK(KDL::Equal(found, joints, 1e-6));
  KDL::ChainIkSolverPos_LMA levenberg(chain);
  CHECK(levenberg.CartToJnt(near, place, found) == 0);
  CHECK(KDL::Equal(found, joints, 1e-3));

  // The upper bar about the shoulder: 3 about its centre of mass, and 2 kg at half a metre.
  KDL::ChainDynParam dynamics(chain, KDL::Vector(0, 0, -9.81));
  KDL::JntSpaceInertiaMatrix mass(3);
  CHECK(dynamics.JntToMass(joints, mass) == 0 && std::abs(mass(0, 0) - 3.5) < kNear);
  const auto inertia = chain.getSegment(0).getInertia();
  CHECK(inertia.getMass() == 2 && KDL::Equal(inertia.getCOG(), KDL::Vector(0.5, 0, 0), kNear));
  CHECK(std::abs(inertia.getRotationalInertia().data[0] - 2) < kNear);  // turned by a quarter
}

void check_messages(Checks& checks) {
  const KDL::Frame frame(KDL::Rotation::RotZ(M_PI_2), KDL::Vector(1, 2, 3));
  auto transform = tf2::kdlToTransform(frame);
  transform.header.frame_id = "world";
  transform.child_frame_id = "robot";
  transform.header.stamp.sec = 7;
  CHECK(KDL::Equal(tf2::transformToKDL(transform), frame, kNear));
  CHECK(KDL::Equal(tf2::gmTransformToKDL(transform), frame, kNear));
  geometry_msgs::msg::Pose pose = tf2::toMsg(frame);
  KDL::Frame back;
  tf2::fromMsg(pose, back);
  CHECK(pose.position.z == 3 && KDL::Equal(back, frame, kNear));

  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>());
  buffer.setTransform(transform, "checks", true);
  const tf2::Stamped<KDL::Vector> point(KDL::Vector(1, 0, 0), tf2::TimePoint(), "robot");
  const auto seen = buffer.transform(point, "world");
  CHECK(seen.frame_id_ == "world" && KDL::Equal(seen, KDL::Vector(1, 3, 3), kNear));
  const tf2::Stamped<KDL::Frame> place(frame, tf2::TimePoint(), "robot");
  CHECK(KDL::Equal(buffer.transform(place, "world"), frame * frame, kNear));
  const tf2::Stamped<KDL::Twist> twist(KDL::Twist(KDL::Vector(1, 0, 0), KDL::Vector(0, 0, 1)),
                                       tf2::TimePoint(), "robot");
  const auto moved = buffer.transform(twist, "world");
  CHECK(KDL::Equal(moved, frame * static_cast<const KDL::Twist&>(twist), kNear));
  CHECK(tf2::toMsg(moved).twist.angular.z == 1 && tf2::toMsg(moved).header.frame_id == "world");
  const tf2::Stamped<KDL::Wrench> wrench(KDL::Wrench(KDL::Vector(1, 0, 0), KDL::Vector(0, 0, 1)),
                                         tf2::TimePoint(), "robot");
  CHECK(std::abs(tf2::toMsg(buffer.transform(wrench, "world")).wrench.force.y - 1) < kNear);
  tf2::Stamped<KDL::Wrench> copy;
  tf2::fromMsg(tf2::toMsg(wrench), copy);
  CHECK(copy.torque.z() == 1 && copy.frame_id_ == "robot");
  std::ostringstream text;
  text << KDL::Vector(1, 2, 3);
  CHECK(text.str().find('2') != std::string::npos);
}

void check_eigen(Checks& checks) {
  const KDL::Frame frame(KDL::Rotation::RPY(0.1, 0.2, 0.3), KDL::Vector(1, 2, 3));
  Eigen::Isometry3d isometry;
  tf2::convert(frame, isometry);
  KDL::Frame back;
  tf2::transformEigenToKDL(isometry, back);
  CHECK(KDL::Equal(frame, back, kNear) && isometry(3, 3) == 1 && isometry(1, 3) == 2);
  Eigen::Affine3d affine;
  tf2::transformKDLToEigen(frame, affine);
  CHECK(affine.isApprox(Eigen::Affine3d(isometry)));
  Eigen::Quaterniond rotation;
  tf2::convert(frame.M, rotation);
  CHECK(rotation.toRotationMatrix().isApprox(isometry.linear()));
  Eigen::Matrix<double, 6, 1> six;
  tf2::convert(KDL::Twist(KDL::Vector(1, 2, 3), KDL::Vector(4, 5, 6)), six);
  CHECK(six == (Eigen::Matrix<double, 6, 1>::LinSpaced(1, 6)));
  KDL::Wrench wrench;
  tf2::convert(six, wrench);
  CHECK(wrench.torque.x() == 4);
}

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("kinematics");
  check_chain(checks);
  check_messages(checks);
  check_eigen(checks);
  return checks.finish();
}
