// The world for a viewer: its shapes, its poses, its pace, and the hand of a visitor, as hidden
// topics of ROS with standard messages. While nobody subscribes nothing is made.
//
// - /_gz/scene, visualization_msgs/MarkerArray, latched: the visuals of all links. frame_id is
//   `model::link`, text the visual's name; frame_locked is false for shapes that never move.
// - /_gz/collisions: the same of collisions.
// - /_gz/lights: the lights, as light_markers() describes them.
// - /_gz/contacts: the same of the last step's contacts, at most 60 Hz.
// - /_gz/poses, tf2_msgs/TFMessage: links in `world`. A message that begins with the frame `world`
//   has all links, and the joints and sensors in their links; others have the links that moved. At
//   most 60 Hz.
// - /_gz/stats, gazebo_msgs/PerformanceMetrics: time and real-time factor, at most 10 Hz.
// - /_gz/paused, std_msgs/Bool, latched.
// - /_gz/hand, visualization_msgs/InteractiveMarkerFeedback, is read here. marker_name is
//   `model::link`, pose.position a point of the link. MOUSE_DOWN holds it, POSE_UPDATE draws it
//   towards mouse_point, MOUSE_UP lets go. BUTTON_CLICK pushes it: mouse_point is the change of
//   velocity in m/s.
#pragma once

#include <gazebo_msgs/msg/performance_metrics.hpp>
#include <std_msgs/msg/bool.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/interactive_marker_feedback.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include <optional>
#include <string>
#include <vector>

#include "core/drag.hpp"
#include "ros/host.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

class ScenePublisher {
 public:
  ScenePublisher(Host& host, Simulation& simulation, Runner& runner);

 private:
  /// Looks what there is to say, often: it costs next to nothing while nobody subscribes.
  void look();
  void look_at_shapes();
  void look_at_poses(std::int64_t now_ns);
  void look_at_contacts();
  void look_at_pace(std::int64_t now_ns);
  void publish_poses(bool all);
  void add_inner_frames(tf2_msgs::msg::TFMessage& message) const;
  void take(const visualization_msgs::msg::InteractiveMarkerFeedback& feedback);
  void refresh_links();

  struct Shapes {
    rclcpp::Publisher<visualization_msgs::msg::MarkerArray>::SharedPtr publisher;
    std::optional<std::uint64_t> revision;  ///< of the world that was published
  };
  struct Shown {
    std::string frame;
    LinkHandle link;
    Pose pose;  ///< as published last
  };

  Host& host_;
  Simulation& simulation_;
  Runner& runner_;
  Drag drag_;
  Shapes visuals_, collisions_, lights_;
  rclcpp::Publisher<visualization_msgs::msg::MarkerArray>::SharedPtr contacts_;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr poses_;
  rclcpp::Publisher<gazebo_msgs::msg::PerformanceMetrics>::SharedPtr stats_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr paused_;
  rclcpp::Subscription<visualization_msgs::msg::InteractiveMarkerFeedback>::SharedPtr hand_;
  rclcpp::Clock clock_{RCL_STEADY_TIME};
  std::vector<Shown> links_;
  std::optional<std::uint64_t> links_revision_;
  std::optional<bool> said_paused_;
  bool refreshed_ = false;  ///< the poses of `links_` have not been read yet
  std::size_t viewers_ = 0;
  bool watches_contacts_ = false;
  std::int64_t contacts_of_ns_ = -1;  ///< the simulated time of those that were published
  // Times of the steady clock, in nanoseconds.
  std::int64_t next_poses_ns_ = 0, next_all_ns_ = 0, next_stats_ns_ = 0;
  std::int64_t pace_since_ns_ = 0, pace_from_ns_ = 0;  ///< the second one is of simulated time
};

}  // namespace ros2wasm_sim
