// Does with a turtle simulator what the tutorials do, and checks the numbers.

// Compatibility, works: turtlesim (`turtlesim_node`, `turtle_teleop_key`, `draw_square`, `mimic`):
// its topics, services, action, parameters and texts; several simulators by namespaces

// Compatibility, differs: the window of turtlesim -> the page draws what the node tells it on the
// hidden topic
// `~/_scene`

// Compatibility, differs: `turtlesim_msgs`, where distributions after Jazzy have the interfaces of
// turtlesim -> they are in the package `turtlesim` alone, as in Jazzy and Humble

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_srvs/srv/empty.hpp"
#include "turtlesim/action/rotate_absolute.hpp"
#include "turtlesim/msg/color.hpp"
#include "turtlesim/msg/pose.hpp"
#include "turtlesim/srv/kill.hpp"
#include "turtlesim/srv/set_pen.hpp"
#include "turtlesim/srv/spawn.hpp"
#include "turtlesim/srv/teleport_absolute.hpp"
#include "turtlesim/srv/teleport_relative.hpp"
#include "turtlesim_scene/msg/scene.hpp"
#include "turtlesim_scene/srv/get_picture.hpp"

namespace {

using geometry_msgs::msg::Twist;
using std_srvs::srv::Empty;
using turtlesim::msg::Color;
using turtlesim::msg::Pose;
using turtlesim::srv::Kill;
using turtlesim::srv::SetPen;
using turtlesim::srv::Spawn;
using turtlesim::srv::TeleportAbsolute;
using turtlesim::srv::TeleportRelative;
using turtlesim_scene::msg::Scene;
using turtlesim_scene::srv::GetPicture;
using Rotate = turtlesim::action::RotateAbsolute;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

bool near(double a, double b, double tolerance = 1e-4) {
  return std::abs(a - b) <= tolerance;
}

class Visitor {
 public:
  Visitor() : node(std::make_shared<rclcpp::Node>("visitor")) {
    poses = node->create_subscription<Pose>("turtle1/pose", 1, [this](const Pose& one) {
      pose = one;
      ++ticks;
    });
    colors = node->create_subscription<Color>("turtle1/color_sensor", 1,
                                              [this](const Color& one) { color = one; });
    scenes = node->create_subscription<Scene>("turtlesim/_scene", rclcpp::QoS(64).transient_local(),
                                              [this](const Scene& one) { take(one); });
    commands = node->create_publisher<Twist>("turtle1/cmd_vel", 1);
  }

  template <typename ServiceT>
  typename ServiceT::Response call(const std::string& name,
                                   const typename ServiceT::Request& request) {
    const auto client = node->create_client<ServiceT>(name);
    if (!client->wait_for_service(60s)) throw std::runtime_error("there is no service " + name);
    auto future = client->async_send_request(std::make_shared<typename ServiceT::Request>(request));
    if (rclcpp::spin_until_future_complete(node, future, 60s) != rclcpp::FutureReturnCode::SUCCESS)
      throw std::runtime_error(name + " did not answer");
    return *future.get();
  }

  template <typename ServiceT>
  typename ServiceT::Response call(const std::string& name) {
    return call<ServiceT>(name, typename ServiceT::Request());
  }

  bool until(const std::function<bool()>& condition) {
    const auto end = node->now() + rclcpp::Duration(60, 0);
    while (!condition() && node->now() < end) {
      rclcpp::spin_some(node);
      rclcpp::sleep_for(1ms);
    }
    return condition();
  }
  /// Until the turtle has moved on some times: what was asked for before has happened then.
  bool some_ticks(int count = 3) {
    const int wanted = ticks + count;
    return until([&] { return ticks >= wanted; });
  }

  void drive(double ahead, double turn, double left = 0) {
    Twist twist;
    twist.linear.x = ahead;
    twist.linear.y = left;
    twist.angular.z = turn;
    commands->publish(twist);
  }

  void teleport(float x, float y, float theta) {
    TeleportAbsolute::Request there;
    there.x = x;
    there.y = y;
    there.theta = theta;
    call<TeleportAbsolute>("turtle1/teleport_absolute", there);
  }

  void take(const Scene& one) {
    if (one.picture != scene.picture) strokes = 0;
    // Nothing is lost: the strokes of a sheet come one after the other.
    gapless = gapless && one.first == strokes;
    strokes = one.first + static_cast<std::uint32_t>(one.strokes.size());
    scene = one;
  }

  rclcpp::Node::SharedPtr node;
  rclcpp::Subscription<Pose>::SharedPtr poses;
  rclcpp::Subscription<Color>::SharedPtr colors;
  rclcpp::Subscription<Scene>::SharedPtr scenes;
  rclcpp::Publisher<Twist>::SharedPtr commands;
  Pose pose;
  Color color;
  Scene scene;
  std::uint32_t strokes = 0;
  bool gapless = true;
  int ticks = 0;
};

void check_start(Checks& checks, Visitor& visitor) {
  CHECK(visitor.until([&] { return visitor.ticks > 2; }));
  CHECK(near(visitor.pose.x, 5.544445) && near(visitor.pose.y, 5.544445));
  CHECK(visitor.pose.theta == 0 && visitor.pose.linear_velocity == 0);
  CHECK(visitor.color.r == 255 && visitor.color.g == 255 && visitor.color.b == 255);
  CHECK(visitor.until([&] { return visitor.scene.picture == 1; }));
  CHECK(visitor.scene.width == 500 && visitor.scene.height == 500 && visitor.scene.meter == 45);
  CHECK((visitor.scene.background == std::array<std::uint8_t, 3>{69, 86, 255}));
  CHECK(visitor.scene.turtles.size() == 1 && visitor.scene.turtles[0].name == "turtle1");
  CHECK(visitor.scene.turtles[0].shape < 10 && visitor.scene.turtles[0].pen_on);
  CHECK(visitor.scene.turtles[0].pen_width == 3);
}

/// How often the pose comes, by the site's time: said, as a busy machine is late.
void check_rate(Checks& checks, Visitor& visitor) {
  constexpr int kTicks = 125;
  CHECK(visitor.some_ticks(1));
  const auto start = visitor.node->now();
  CHECK(visitor.some_ticks(kTicks));
  RCLCPP_INFO(visitor.node->get_logger(), "the pose comes at %.1f Hz",
              kTicks / (visitor.node->now() - start).seconds());
}

/// What is late is worth nothing: each topic of a turtle keeps one message.
void check_qos(Checks& checks, Visitor& visitor) {
  const auto own = [&](const std::vector<rclcpp::TopicEndpointInfo>& infos) {
    for (const auto& info : infos) {
      if (info.node_name() != "turtlesim") continue;
      const rclcpp::QoS& qos = info.qos_profile();
      return qos.depth() == 1 && qos.history() == rclcpp::HistoryPolicy::KeepLast &&
             qos.reliability() == rclcpp::ReliabilityPolicy::Reliable &&
             qos.durability() == rclcpp::DurabilityPolicy::Volatile;
    }
    return false;
  };
  CHECK(own(visitor.node->get_publishers_info_by_topic("/turtle1/pose")));
  CHECK(own(visitor.node->get_publishers_info_by_topic("/turtle1/color_sensor")));
  CHECK(own(visitor.node->get_subscriptions_info_by_topic("/turtle1/cmd_vel")));
}

/// A command lasts for a second, in which there are 62 or 63 ticks of 0.016 s, or fewer on a busy
/// machine.
void check_commands(Checks& checks, Visitor& visitor) {
  visitor.drive(2, 0);
  CHECK(visitor.until(
      [&] { return visitor.pose.x > 5.544445F && visitor.pose.linear_velocity == 0; }));
  const double ticks = (visitor.pose.x - 5.544445) / (2 * 0.016);
  CHECK(ticks > 0.5 && ticks < 64 && near(ticks, std::round(ticks), 1e-2));
  CHECK(near(visitor.pose.y, 5.544445));
  visitor.drive(0, 1);
  CHECK(
      visitor.until([&] { return visitor.pose.theta > 0 && visitor.pose.angular_velocity == 0; }));
  CHECK(visitor.pose.theta < 1.03);
  // It stands on what it drew: the pen's colour at the start.
  CHECK(visitor.color.r == 0xb3 && visitor.color.g == 0xb8 && visitor.color.b == 0xff);
}

void check_teleports(Checks& checks, Visitor& visitor) {
  visitor.teleport(2, 3, 0.5);
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.x, 2) && near(visitor.pose.y, 3) && near(visitor.pose.theta, 0.5));
  // It turns first, then moves.
  TeleportRelative::Request ahead;
  ahead.linear = 1;
  ahead.angular = static_cast<float>(M_PI_2) - 0.5F;
  visitor.call<TeleportRelative>("turtle1/teleport_relative", ahead);
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.x, 2) && near(visitor.pose.y, 4) && near(visitor.pose.theta, M_PI_2));
  // Headings are told within [-pi, pi).
  ahead.linear = 0;
  ahead.angular = static_cast<float>(M_PI);
  visitor.call<TeleportRelative>("turtle1/teleport_relative", ahead);
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.theta, -M_PI_2));
  for (const auto& [asked, told] : {std::pair{4.0, 4.0 - 2 * M_PI}, {-10.0, 4 * M_PI - 10}}) {
    visitor.teleport(2, 4, static_cast<float>(asked));
    CHECK(visitor.some_ticks());
    CHECK(near(visitor.pose.theta, told));
  }
}

void check_pen(Checks& checks, Visitor& visitor) {
  SetPen::Request pen;
  pen.r = 250;
  pen.g = 10;
  pen.width = 9;
  visitor.call<SetPen>("turtle1/set_pen", pen);
  TeleportAbsolute::Request there;
  there.x = 8;
  there.y = 4;
  visitor.call<TeleportAbsolute>("turtle1/teleport_absolute", there);
  CHECK(visitor.some_ticks());
  CHECK(visitor.color.r == 250 && visitor.color.g == 10 && visitor.color.b == 0);
  CHECK(visitor.until([&] { return visitor.scene.turtles[0].pen_width == 9; }));
  pen.off = 1;
  visitor.call<SetPen>("turtle1/set_pen", pen);
  there.y = 9;
  visitor.call<TeleportAbsolute>("turtle1/teleport_absolute", there);
  CHECK(visitor.some_ticks());
  CHECK(visitor.color.r == 255 && visitor.color.g == 255 && visitor.color.b == 255);
  CHECK(visitor.until([&] { return !visitor.scene.turtles[0].pen_on; }));
  // A pen without a width has Qt's.
  pen.off = 0;
  pen.width = 0;
  visitor.call<SetPen>("turtle1/set_pen", pen);
  CHECK(visitor.until([&] { return visitor.scene.turtles[0].pen_on; }));
  CHECK(visitor.scene.turtles[0].pen_width == 1);
  pen.off = 1;
  visitor.call<SetPen>("turtle1/set_pen", pen);
  CHECK(visitor.until([&] { return !visitor.scene.turtles[0].pen_on; }));
}

void check_turtles(Checks& checks, Visitor& visitor) {
  Spawn::Request wish;
  wish.x = 1;
  wish.y = 1;
  CHECK(visitor.call<Spawn>("spawn", wish).name == "turtle2");
  wish.name = "turtle2";
  CHECK(visitor.call<Spawn>("spawn", wish).name.empty());
  wish.name = "no name/of a topic";
  CHECK(visitor.call<Spawn>("spawn", wish).name.empty());
  wish.name = "bob";
  CHECK(visitor.call<Spawn>("spawn", wish).name == "bob");
  wish.name.clear();
  CHECK(visitor.call<Spawn>("spawn", wish).name == "turtle3");
  CHECK(visitor.until([&] { return visitor.scene.turtles.size() == 4; }));
  Kill::Request victim;
  victim.name = "bob";
  visitor.call<Kill>("kill", victim);
  visitor.call<Kill>("kill", victim);  // it is said, and that is all
  CHECK(visitor.until([&] { return visitor.scene.turtles.size() == 3; }));
}

void check_walls(Checks& checks, Visitor& visitor) {
  TeleportAbsolute::Request there;
  there.x = 100;
  there.y = -100;
  visitor.call<TeleportAbsolute>("turtle1/teleport_absolute", there);
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.x, 499.0 / 45) && near(visitor.pose.y, 0));
  there.x = std::numeric_limits<float>::quiet_NaN();
  there.y = std::numeric_limits<float>::infinity();
  there.theta = std::numeric_limits<float>::infinity();
  visitor.call<TeleportAbsolute>("turtle1/teleport_absolute", there);
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.x, 249.5 / 45) && near(visitor.pose.y, 499.0 / 45));
  CHECK(visitor.pose.theta == 0);
}

struct Ended {
  rclcpp_action::ResultCode code = rclcpp_action::ResultCode::UNKNOWN;
  float delta = 0;
  float remaining = 0;  ///< what the last feedback said
};

void check_rotation(Checks& checks, Visitor& visitor) {
  const auto client = rclcpp_action::create_client<Rotate>(visitor.node, "turtle1/rotate_absolute");
  CHECK(client->wait_for_action_server(60s));
  using Code = rclcpp_action::ResultCode;
  using Handle = rclcpp_action::ClientGoalHandle<Rotate>;
  std::map<int, Ended> ended;
  Handle::SharedPtr handle;
  int count = 0;
  const auto turn_to = [&](float theta) {
    const int number = ++count;
    handle.reset();
    rclcpp_action::Client<Rotate>::SendGoalOptions options;
    options.goal_response_callback = [&](const Handle::SharedPtr& given) { handle = given; };
    options.feedback_callback = [&, number](
                                    const Handle::SharedPtr&,
                                    const std::shared_ptr<const Rotate::Feedback> feedback) {
      ended[number].remaining = feedback->remaining;
    };
    options.result_callback = [&, number](const Handle::WrappedResult& result) {
      ended[number].code = result.code;
      ended[number].delta = result.result->delta;
    };
    Rotate::Goal goal;
    goal.theta = theta;
    client->async_send_goal(goal, options);
    CHECK(visitor.until([&] { return handle != nullptr; }));
  };
  const auto is_over = [&](int number) {
    return visitor.until([&] { return ended[number].code != Code::UNKNOWN; });
  };
  turn_to(1);
  CHECK(is_over(1) && ended[1].code == Code::SUCCEEDED);
  CHECK(near(visitor.pose.theta, 1, 0.02) && near(ended[1].delta, -1, 0.04));
  CHECK(std::abs(ended[1].remaining) < 0.02F);
  turn_to(-2);
  turn_to(3);  // another goal takes its place
  CHECK(is_over(2) && ended[2].code == Code::ABORTED);
  client->async_cancel_goal(handle);
  CHECK(is_over(3) && ended[3].code == Code::CANCELED);
  turn_to(-1);
  visitor.drive(0, 0);  // so does a command
  CHECK(is_over(4) && ended[4].code == Code::ABORTED);
}

/// What somebody sees who comes late: the picture as it is, and from there on every stroke.
void check_picture(Checks& checks, Visitor& visitor) {
  const auto picture = visitor.call<GetPicture>("turtlesim/_get_picture");
  CHECK(picture.picture == 1 && picture.strokes > 3 && picture.width == 500);
  std::uint32_t pixels = 0;
  std::map<std::uint32_t, std::uint32_t> of_color;
  for (std::size_t i = 0; i < picture.lengths.size(); ++i) {
    pixels += picture.lengths[i];
    of_color[picture.colors.at(i)] += picture.lengths[i];
  }
  CHECK(pixels == 500 * 500 && picture.colors.size() == picture.lengths.size());
  CHECK(of_color[0] > 200000 && of_color[0xffb3b8ff] > 10);
  // From (2, 4) to (8, 4), 9 pixels thick.
  CHECK(near(of_color[0xfffa0a00], 6 * 45 * 9, 200));
  CHECK(visitor.until([&] { return visitor.strokes == picture.strokes; }) && visitor.gapless);

  visitor.call<Empty>("clear");
  CHECK(visitor.until([&] { return visitor.scene.picture == 2; }) && visitor.strokes == 0);
  CHECK(visitor.call<GetPicture>("turtlesim/_get_picture").lengths.size() == 1);
}

void check_parameters(Checks& checks, Visitor& visitor) {
  const auto client = std::make_shared<rclcpp::SyncParametersClient>(visitor.node, "turtlesim");
  CHECK(client->wait_for_service(60s));
  const auto changed = client->set_parameters({rclcpp::Parameter("background_r", 255)});
  CHECK(changed.size() == 1 && changed[0].successful);
  CHECK(visitor.until([&] { return visitor.scene.background[0] == 255; }));
  CHECK(!client->set_parameters({rclcpp::Parameter("background_g", 256)})[0].successful);
  const auto described = client->describe_parameters({"background_b", "holonomic"});
  CHECK(described[0].integer_range[0].to_value == 255 && described[1].type == 1);
}

/// Aside goes only who may; the speed is told without its direction.
void check_holonomic(Checks& checks, Visitor& visitor) {
  const auto client = std::make_shared<rclcpp::SyncParametersClient>(visitor.node, "turtlesim");
  const auto at_rest = [&] {
    return visitor.until(
        [&] { return visitor.pose.linear_velocity == 0 && visitor.pose.angular_velocity == 0; });
  };
  const auto up = static_cast<float>(M_PI_2);
  visitor.teleport(5, 5, up);
  CHECK(visitor.some_ticks());
  visitor.drive(0, 1, 1);
  CHECK(visitor.until([&] { return visitor.pose.angular_velocity == 1; }));
  CHECK(visitor.pose.linear_velocity == 0);
  CHECK(at_rest());
  CHECK(near(visitor.pose.x, 5) && near(visitor.pose.y, 5) && visitor.pose.theta > up);

  CHECK(client->set_parameters({rclcpp::Parameter("holonomic", true)})[0].successful);
  visitor.teleport(5, 5, up);
  CHECK(visitor.some_ticks());
  visitor.drive(0, 0, 1);  // up is ahead, so its left is that of the sheet
  CHECK(visitor.until([&] { return visitor.pose.linear_velocity == 1; }));
  CHECK(at_rest());
  CHECK(visitor.pose.x < 5 && visitor.pose.x > 3.9 && near(visitor.pose.y, 5));
  visitor.drive(-3, 0, 4);
  CHECK(visitor.until([&] { return visitor.pose.linear_velocity == 5; }));
  CHECK(at_rest());
  CHECK(client->set_parameters({rclcpp::Parameter("holonomic", false)})[0].successful);
  visitor.teleport(5, 5, 0);
  CHECK(visitor.some_ticks());
  visitor.drive(-1, 0);
  CHECK(visitor.until([&] { return visitor.pose.linear_velocity != 0; }));
  CHECK(visitor.pose.linear_velocity == 1 && visitor.pose.x < 5);
  CHECK(at_rest());
}

void check_reset(Checks& checks, Visitor& visitor) {
  visitor.call<Empty>("reset");
  CHECK(visitor.until([&] { return visitor.scene.turtles.size() == 1; }));
  CHECK(visitor.scene.picture == 3 && visitor.scene.turtles[0].name == "turtle1");
  CHECK(visitor.some_ticks());
  CHECK(near(visitor.pose.x, 5.544445) && near(visitor.pose.y, 5.544445));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("visitor");
  Visitor visitor;
  try {
    for (const auto check : {check_start, check_rate, check_qos, check_commands, check_teleports,
                             check_pen, check_turtles, check_walls, check_rotation, check_picture,
                             check_parameters, check_holonomic, check_reset})
      check(checks, visitor);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(visitor.node->get_logger(), "%s", error.what());
    CHECK(false);
  }
  return checks.finish();
}
