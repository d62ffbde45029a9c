// See filter_node.hpp: setting up, and the services.
#include "node/filter_node.hpp"

#include <chrono>
#include <utility>

namespace robot_localization {

FilterNode::FilterNode(const std::string& name, std::unique_ptr<Filter> filter)
    : rclcpp::Node(name), estimator_(std::move(filter)), transforms_(*this) {}

void FilterNode::start() {
  parameters_ = read_parameters(*this);
  report_ = FilterReport(parameters_.prints_diagnostics);
  report_.check_settings(parameters_);
  apply_parameters();
  create_services();
  create_outputs();
  subscribe();
  const std::chrono::duration<double> period(1.0 / parameters_.frequency);
  timer_ = create_timer(period, [this] { update(); });
}

void FilterNode::apply_parameters() {
  Filter& filter = estimator_.filter();
  filter.set_process_noise(parameters_.process_noise.value_or(default_process_noise()));
  filter.set_dynamic_process_noise(parameters_.is_noise_dynamic);
  if (parameters_.control) filter.set_control_model(*parameters_.control);
  filter.restore(FilterState{});
  filter.set_estimate(parameters_.initial_state.value_or(State::Zero()),
                      parameters_.initial_covariance.value_or(state().covariance));
  filter.set_time(now().nanoseconds());
  const auto nanoseconds = [](double seconds) {
    return rclcpp::Duration::from_seconds(seconds).nanoseconds();
  };
  estimator_.set_settings({.smooth_lagged_data = parameters_.smooths_lagged_data,
                           .history_length_ns = nanoseconds(parameters_.history_length),
                           .sensor_timeout_ns = nanoseconds(parameters_.sensor_timeout),
                           .predict_to_current_time = parameters_.predicts_to_current_time});
  is_enabled_ = !parameters_.is_disabled_at_startup;
}

void FilterNode::create_services() {
  using Empty = std_srvs::srv::Empty;
  set_pose_subscription_ = create_subscription<PoseMessage>(
      "set_pose", rclcpp::QoS(1), [this](const PoseMessage& message) { set_pose(message); });
  services_.push_back(create_service<SetPose>(
      "set_pose", [this](const SetPose::Request::SharedPtr request, SetPose::Response::SharedPtr) {
        set_pose(request->pose);
      }));
  enable_service_ = create_service<Empty>(
      "enable", [this](const Empty::Request::SharedPtr, Empty::Response::SharedPtr) { enable(); });
  services_.push_back(create_service<Empty>(
      "reset", [this](const Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(get_logger(), "Received a request to reset filter.");
        reset();
      }));
  services_.push_back(create_service<Toggle>(
      "toggle", [this](const Toggle::Request::SharedPtr request,
                       Toggle::Response::SharedPtr response) { toggle(request->on, *response); }));
}

void FilterNode::create_outputs() {
  updater_ = std::make_unique<diagnostic_updater::Updater>(shared_from_this());
  updater_->setHardwareID("none");
  if (parameters_.prints_diagnostics) {
    updater_->add(
        "Filter diagnostic updater",
        [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report_.fill(status); });
  }
  constexpr double kTolerance = 2.0;  // Hz
  least_frequency_ = parameters_.frequency - kTolerance;
  most_frequency_ = parameters_.frequency + kTolerance;
  frequency_task_ = std::make_unique<diagnostic_updater::HeaderlessTopicDiagnostic>(
      "odometry/filtered", *updater_,
      diagnostic_updater::FrequencyStatusParam(&least_frequency_, &most_frequency_, 0.1, 10));

  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);
  rclcpp::PublisherOptions options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  odometry_publisher_ =
      create_publisher<nav_msgs::msg::Odometry>("odometry/filtered", rclcpp::QoS(10), options);
  if (parameters_.publishes_acceleration) {
    acceleration_publisher_ = create_publisher<geometry_msgs::msg::AccelWithCovarianceStamped>(
        "accel/filtered", rclcpp::QoS(10), options);
  }
  if (parameters_.resets_on_time_jump) {
    rcl_jump_threshold_t backward{};
    backward.min_backward.nanoseconds = -1;
    jump_handler_ = get_clock()->create_jump_callback(
        nullptr, [this](const rcl_time_jump_t&) { has_time_jumped_ = true; }, backward);
  }
}

/// Not at once: time may jump while a message waits for its transform.
void FilterNode::reset_after_jump() {
  if (std::exchange(has_time_jumped_, false)) reset();
}

void FilterNode::reset() {
  for (Input& input : inputs_) {
    for (Part* part : {&input.pose, &input.twist, &input.acceleration}) {
      part->newest_ns.reset();
      part->poses = PoseSource{};
    }
  }
  estimator_.clear();
  set_pose_ns_ = 0;
  newest_published_ns_ = 0;
  turning_ = Turning{};
  transforms_.clear();
  const bool was_enabled = is_enabled_;
  apply_parameters();
  is_enabled_ = was_enabled;
}

void FilterNode::set_pose(const PoseMessage& message) {
  reset_after_jump();
  RCLCPP_INFO(get_logger(), "Received set_pose request with value\n%s",
              geometry_msgs::msg::to_yaml(message).c_str());
  for (Input& input : inputs_) {
    for (Part* part : {&input.pose, &input.twist}) part->poses = PoseSource{};
  }
  estimator_.clear();
  const rclcpp::Time stamp(message.header.stamp);
  set_pose_ns_ = stamp.nanoseconds();

  Measurement measurement;
  measurement.update.set();
  PoseReading reading;
  reading.pose.translation() = vector_of(message.pose.pose.position);
  reading.pose.linear() = rotation_of(message.pose.pose.orientation)
                              .value_or(Eigen::Quaterniond::Identity())
                              .toRotationMatrix();
  reading.covariance = Matrix6::Map(message.pose.covariance.data());
  const auto transform = transforms_.lookup(parameters_.world_frame, message.header.frame_id, stamp,
                                            parameters_.transform_timeout);
  constexpr double kVariance = 1e-6;  // of velocities, which become zero
  Covariance covariance = Covariance::Identity() * kVariance;
  if (transform) {
    reading.target_from_message = *transform;
    PoseSource().take(reading, turning_, measurement);
    if (parameters_.is_two_d) force_two_d(measurement);
    covariance.topLeftCorner<kPoseSize, kPoseSize>() =
        measurement.covariance.topLeftCorner<kPoseSize, kPoseSize>();
  } else {
    RCLCPP_WARN(get_logger(),
                "Could not obtain transform from %s->%s, the pose becomes that of the origin",
                message.header.frame_id.c_str(), parameters_.world_frame.c_str());
  }
  estimator_.filter().set_estimate(measurement.values, covariance);
  estimator_.filter().set_time(now().nanoseconds());
}

void FilterNode::toggle(bool on, Toggle::Response& response) {
  response.status = on != is_processing_;
  if (!response.status) {
    RCLCPP_WARN(get_logger(),
                "Service was called to toggle filter processing but state was already as "
                "requested.");
    return;
  }
  RCLCPP_INFO(get_logger(), "Toggling filter measurement filtering to %s.", on ? "On" : "Off");
  is_processing_ = on;
}

void FilterNode::enable() {
  if (is_enabled_) {
    RCLCPP_WARN(get_logger(),
                "[%s:] Asking for enabling filter service, but the filter was already enabled! "
                "Use param disabled_at_startup.",
                get_name());
    return;
  }
  RCLCPP_INFO(get_logger(), "[%s:] Enabling filter...", get_name());
  is_enabled_ = true;
}

}  // namespace robot_localization
