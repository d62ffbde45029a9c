// The buffer without any node: the tree, its times, and the texts of what goes wrong.

// Compatibility, works: tf2: linear algebra, the buffer with its interpolation, static frames, new
// parents, requests, errors with the texts of ROS 2

#include <cmath>
#include <memory>

#include "checks.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "tf2/buffer_core.h"
#include "tf2/convert.h"
#include "tf2/exceptions.h"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace {

geometry_msgs::msg::TransformStamped transform(const std::string& parent, const std::string& child,
                                               double seconds, double x, double yaw = 0) {
  geometry_msgs::msg::TransformStamped result;
  result.header.frame_id = parent;
  result.header.stamp = tf2_ros::toMsg(tf2::timeFromSec(seconds));
  result.child_frame_id = child;
  result.transform.translation.x = x;
  tf2::Quaternion q;
  q.setRPY(0, 0, yaw);
  result.transform.rotation = tf2::toMsg(q);
  return result;
}

tf2::TimePoint at(double seconds) {
  return tf2::timeFromSec(seconds);
}

bool near(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

// What a lookup throws says this.
template <typename ErrorT>
std::string error_of(const tf2::BufferCore& buffer, const std::string& target,
                     const std::string& source, tf2::TimePoint time) {
  try {
    buffer.lookupTransform(target, source, time);
  } catch (const ErrorT& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another class: ") + error.what();
  }
  return "nothing";
}

void check_tree(Checks& checks) {
  tf2::BufferCore buffer;
  // map <- odom <- base <- arm (static), and base <- leg.
  for (const double t : {1.0, 2.0}) {
    CHECK(buffer.setTransform(transform("map", "odom", t, 10 * t), "me"));
    CHECK(buffer.setTransform(transform("odom", "base", t, t, M_PI / 2), "me"));
    CHECK(buffer.setTransform(transform("base", "leg", t, -1), "me"));
  }
  CHECK(buffer.setTransform(transform("base", "/arm", 0, 1), "me", true));

  const auto up = buffer.lookupTransform("map", "arm", at(1.5));
  CHECK(near(up.transform.translation.x, 16.5));
  CHECK(near(up.transform.translation.y, 1));
  CHECK(near(tf2::getYaw(up.transform.rotation), M_PI / 2));
  CHECK(tf2_ros::fromMsg(up.header.stamp) == at(1.5));
  const auto down = buffer.lookupTransform("arm", "map", at(1.5));
  CHECK(near(down.transform.translation.x, -1));
  CHECK(near(down.transform.translation.y, 16.5));
  const auto across = buffer.lookupTransform("leg", "arm", tf2::TimePointZero);
  CHECK(near(across.transform.translation.x, 2));
  CHECK(tf2_ros::fromMsg(across.header.stamp) == at(2));
  // The latest time that all of the way has; a static frame has all times.
  CHECK(buffer.setTransform(transform("map", "odom", 3, 30), "me"));
  CHECK(tf2_ros::fromMsg(buffer.lookupTransform("map", "arm", tf2::TimePointZero).header.stamp) ==
        at(2));
  CHECK(tf2_ros::fromMsg(buffer.lookupTransform("base", "arm", tf2::TimePointZero).header.stamp) ==
        tf2::TimePointZero);
  // Where base was at 1, seen from base at 2, with odom fixed.
  const auto moved = buffer.lookupTransform("base", at(2), "base", at(1), "odom");
  CHECK(near(moved.transform.translation.y, 1));
  CHECK(tf2_ros::fromMsg(moved.header.stamp) == at(2));
  // What is above both is not asked.
  CHECK(buffer.setTransform(transform("odom", "base", 5, 5), "me"));
  CHECK(buffer.setTransform(transform("base", "leg", 5, -5), "me"));
  CHECK(near(buffer.lookupTransform("arm", "leg", at(5)).transform.translation.x, -6));

  const auto identity = buffer.lookupTransform("leg", "leg", tf2::TimePointZero);
  CHECK(near(identity.transform.rotation.w, 1) && tf2_ros::fromMsg(identity.header.stamp) == at(5));
  const auto velocity = buffer.lookupVelocity("odom", "map", at(1.5), std::chrono::seconds(1));
  CHECK(near(velocity.velocity.linear.x, 10));

  // A new parent: from then on the frame is elsewhere.
  CHECK(buffer.setTransform(transform("map", "leg", 6, 7), "me"));
  CHECK(near(buffer.lookupTransform("map", "leg", at(6)).transform.translation.x, 7));
  CHECK(near(buffer.lookupTransform("base", "leg", at(2)).transform.translation.x, -1));
  std::string parent;
  CHECK(buffer._getParent("arm", at(1), parent) && parent == "base");
  CHECK(buffer.getAllFrameNames().size() == 5);
  CHECK(buffer.allFramesAsString().find("Frame arm exists with parent base.\n") !=
        std::string::npos);
  CHECK(buffer.allFramesAsYAML().find("arm: \n  parent: 'base'\n  broadcaster: 'me'\n  rate: "
                                      "10000.000\n") != std::string::npos);
  std::vector<std::string> chain;
  buffer._chainAsVector("arm", at(1), "map", at(1), "odom", chain);
  CHECK((chain == std::vector<std::string>{"map", "odom", "base", "arm"}));
  buffer.clear();
  CHECK(!buffer.canTransform("map", "odom", tf2::TimePointZero));
}

void check_errors(Checks& checks) {
  tf2::BufferCore buffer;
  const auto latest = tf2::TimePointZero;
  buffer.setTransform(transform("a", "b", 1, 1), "me");
  CHECK(error_of<tf2::NoDataForExtrapolationException>(buffer, "a", "b", at(2)) ==
        "Lookup would require extrapolation at time 2.000000, but only time 1.000000 is in the "
        "buffer, when looking up transform from frame [b] to frame [a]");
  buffer.setTransform(transform("a", "b", 2, 1), "me");
  buffer.setTransform(transform("c", "d", 1, 1), "me");
  CHECK(error_of<tf2::LookupException>(buffer, "a", "x", latest) ==
        "\"x\" passed to lookupTransform argument source_frame does not exist. ");
  CHECK(error_of<tf2::InvalidArgumentException>(buffer, "", "a", latest) ==
        "Invalid argument \"\" passed to lookupTransform argument target_frame - in tf2 "
        "frame_ids cannot be empty");
  CHECK(error_of<tf2::InvalidArgumentException>(buffer, "a", "/b", latest) ==
        "Invalid argument \"/b\" passed to lookupTransform argument source_frame - in tf2 "
        "frame_ids cannot start with a '/'");
  CHECK(error_of<tf2::ConnectivityException>(buffer, "a", "d", latest) ==
        "Could not find a connection between 'a' and 'd' because they are not part of the same "
        "tree.Tf has two or more unconnected trees.");
  CHECK(error_of<tf2::ForwardExtrapolationException>(buffer, "b", "a", at(3)) ==
        "Lookup would require extrapolation into the future.  Requested time 3.000000 but the "
        "latest data is at time 2.000000, when looking up transform from frame [a] to frame [b]");
  CHECK(error_of<tf2::BackwardExtrapolationException>(buffer, "a", "b", at(0.5)) ==
        "Lookup would require extrapolation into the past.  Requested time 0.500000 but the "
        "earliest data is at time 1.000000, when looking up transform from frame [b] to frame [a]");
  CHECK_THROWS(tf2::ExtrapolationException, buffer.lookupTransform("a", "b", at(0.5)));
  CHECK_THROWS(tf2::TransformException, buffer.lookupTransform("a", "d", latest));
  std::string error;
  CHECK(!buffer.canTransform("a", "x", latest, &error));
  CHECK(error ==
        "Invalid frame ID \"x\" passed to canTransform argument source_frame - frame does not "
        "exist");
  CHECK(buffer.canTransform("x", "x", latest));

  // Not taken: a frame in itself, no names, no number, too old.
  CHECK(!buffer.setTransform(transform("a", "a", 1, 1), "me"));
  CHECK(!buffer.setTransform(transform("", "e", 1, 1), "me"));
  CHECK(!buffer.setTransform(transform("a", "", 1, 1), "me"));
  CHECK(!buffer.setTransform(transform("a", "e", 1, NAN), "me"));
  auto no_rotation = transform("a", "e", 1, 1);
  no_rotation.transform.rotation.w = 0;
  CHECK(!buffer.setTransform(no_rotation, "me"));
  buffer.setTransform(transform("a", "b", 100, 1), "me");
  CHECK(!buffer.setTransform(transform("a", "b", 89, 1), "me"));

  buffer.setTransform(transform("x", "y", 1, 1), "me");
  buffer.setTransform(transform("y", "x", 1, 1), "me");
  buffer.setTransform(transform("z", "w", 1, 1), "me");
  CHECK(error_of<tf2::LookupException>(buffer, "w", "x", at(1))
            .find("The tf tree is invalid because it contains a loop.\n") == 0);
}

void check_requests(Checks& checks) {
  tf2::BufferCore buffer;
  int answers = 0;
  tf2::TransformableResult result = tf2::TransformFailure;
  const auto note = [&](tf2::TransformableRequestHandle, const std::string&, const std::string&,
                        tf2::TimePoint, tf2::TransformableResult what) {
    ++answers;
    result = what;
  };
  CHECK(buffer.addTransformableRequest(note, "a", "a", at(1)) == 0);
  CHECK(buffer.addTransformableRequest(note, "a", "b", at(1)) == 1);
  const auto cancelled = buffer.addTransformableRequest(note, "a", "b", at(1));
  buffer.cancelTransformableRequest(cancelled);
  buffer.setTransform(transform("a", "b", 0.5, 1), "me");
  CHECK(answers == 0);
  buffer.setTransform(transform("a", "b", 1.5, 1), "me");
  CHECK(answers == 1 && result == tf2::TransformAvailable);
  CHECK(buffer.addTransformableRequest(note, "a", "b", at(1)) == 0);
  buffer.setTransform(transform("a", "b", 50, 1), "me");
  CHECK(buffer.addTransformableRequest(note, "a", "b", at(1)) == 0xffffffffffffffffULL);
  CHECK(buffer.addTransformableRequest(note, "a", "b", at(51)) != 0);
  buffer.setTransform(transform("a", "b", 100, 1), "me");
  CHECK(answers == 2);
}

void check_messages(Checks& checks) {
  const auto quarter = transform("map", "base", 3, 1, M_PI / 2);
  geometry_msgs::msg::PoseStamped pose;
  pose.pose.position.x = 2;
  pose.pose.orientation.w = 1;
  geometry_msgs::msg::PoseStamped moved;
  tf2::doTransform(pose, moved, quarter);
  CHECK(near(moved.pose.position.x, 1) && near(moved.pose.position.y, 2));
  CHECK(near(tf2::getYaw(moved.pose.orientation), M_PI / 2));
  CHECK(moved.header == quarter.header);
  geometry_msgs::msg::Vector3 vector;
  vector.x = 1;
  tf2::doTransform(vector, vector, quarter);
  CHECK(near(vector.x, 0) && near(vector.y, 1));
  geometry_msgs::msg::WrenchStamped wrench;
  wrench.wrench.force.x = 1;
  tf2::doTransform(wrench, wrench, quarter);
  CHECK(near(wrench.wrench.force.y, 1) && near(wrench.wrench.torque.z, 1));
  geometry_msgs::msg::PoseWithCovarianceStamped uncertain;
  uncertain.pose.pose.orientation.w = 1;
  uncertain.pose.covariance[0] = 4;
  tf2::doTransform(uncertain, uncertain, quarter);
  CHECK(near(uncertain.pose.covariance[0], 0) && near(uncertain.pose.covariance[7], 4));
  CHECK(near(tf2::getCovarianceMatrix(uncertain)[1][1], 4));

  tf2::Stamped<tf2::Transform> stamped;
  tf2::fromMsg(quarter, stamped);
  CHECK(tf2::getTimestamp(stamped) == at(3) && tf2::getFrameId(stamped) == "map");
  CHECK(tf2::toMsg(stamped).header == quarter.header);
  tf2::Quaternion q;
  tf2::convert(quarter.transform.rotation, q);
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  tf2::getEulerYPR(q, yaw, pitch, roll);
  CHECK(near(yaw, M_PI / 2) && near(pitch, 0) && near(roll, 0));
  CHECK(tf2::getTransformIdentity<tf2::Transform>() == tf2::Transform::getIdentity());
  tf2::Transform from_pose;
  tf2::fromMsg(moved.pose, from_pose);
  geometry_msgs::msg::Pose again;
  tf2::toMsg(from_pose, again);
  CHECK(near(again.position.y, 2));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("buffer");
  check_tree(checks);
  check_errors(checks);
  check_requests(checks);
  check_messages(checks);
  return checks.finish();
}
