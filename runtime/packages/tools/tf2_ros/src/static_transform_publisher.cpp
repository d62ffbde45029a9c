// usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW]
//          [--roll ROLL] [--pitch PITCH] [--yaw YAW] --frame-id FRAME --child-frame-id CHILD
// or, as long ago: x y z yaw pitch roll FRAME CHILD, or x y z qx qy qz qw FRAME CHILD
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2_ros/static_transform_broadcaster_node.hpp"

namespace {

using Words = std::map<std::string, std::string>;

constexpr const char* kUsage =
    "usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw "
    "QW] [--roll ROLL] [--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID --child-frame-id "
    "CHILD_FRAME_ID\n\n"
    "A command line utility for manually sending a static transform.\n\n"
    "The translation offsets are in meters.\n"
    "The rotation may be provided with roll, pitch, yaw (in radians), or as a quaternion.\n"
    "If the rotation is not provided, it defaults to identity.\n";

const std::vector<std::string> kAngles = {"roll", "pitch", "yaw"};
const std::vector<std::string> kQuaternion = {"qx", "qy", "qz", "qw"};

bool has_any(const Words& words, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    if (words.count(key) != 0) {
      return true;
    }
  }
  return false;
}

double number(const Words& words, const std::string& key, double alternative) {
  const auto found = words.find(key);
  if (found == words.end()) {
    return alternative;
  }
  std::size_t end = 0;
  const double value = std::stod(found->second, &end);
  if (end != found->second.size()) {
    throw std::invalid_argument("--" + key + " is not a number: " + found->second);
  }
  return value;
}

Words by_place(const std::vector<std::string>& values) {
  std::vector<std::string> keys = {"x", "y", "z"};
  const bool has_quaternion = values.size() == 9;
  if (has_quaternion) {
    keys.insert(keys.end(), kQuaternion.begin(), kQuaternion.end());
  } else if (values.size() == 8) {
    keys.insert(keys.end(), kAngles.rbegin(), kAngles.rend());
  } else {
    throw std::invalid_argument("there must be 8 or 9 values without names");
  }
  keys.insert(keys.end(), {"frame-id", "child-frame-id"});
  Words result;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    result[keys[i]] = values[i];
  }
  return result;
}

Words by_name(const std::vector<std::string>& arguments) {
  Words result;
  for (std::size_t i = 0; i < arguments.size(); i += 2) {
    static const std::map<std::string, std::string> kShort = {
        {"-x", "--x"}, {"-y", "--y"}, {"-z", "--z"}};
    const auto full = kShort.find(arguments[i]);
    const std::string& flag = full == kShort.end() ? arguments[i] : full->second;
    static const std::string kKnown =
        " --x --y --z --qx --qy --qz --qw --roll --pitch --yaw "
        "--frame-id --child-frame-id ";
    if (kKnown.find(" " + flag + " ") == std::string::npos || i + 1 == arguments.size()) {
      throw std::invalid_argument(arguments[i] + " is not known, or has no value");
    }
    result[flag.substr(2)] = arguments[i + 1];
  }
  return result;
}

rclcpp::NodeOptions options_of(const Words& words) {
  if (has_any(words, kAngles) && has_any(words, kQuaternion)) {
    throw std::invalid_argument("a rotation is given by angles or by a quaternion, not by both");
  }
  for (const char* key : {"frame-id", "child-frame-id"}) {
    if (words.count(key) == 0 || words.at(key).empty()) {
      throw std::invalid_argument("--" + std::string(key) + " is needed");
    }
  }
  tf2::Quaternion rotation(number(words, "qx", 0), number(words, "qy", 0), number(words, "qz", 0),
                           number(words, "qw", 1));
  if (has_any(words, kAngles)) {
    rotation.setRPY(number(words, "roll", 0), number(words, "pitch", 0), number(words, "yaw", 0));
  }
  rclcpp::NodeOptions options;
  options.append_parameter_override("translation.x", number(words, "x", 0));
  options.append_parameter_override("translation.y", number(words, "y", 0));
  options.append_parameter_override("translation.z", number(words, "z", 0));
  options.append_parameter_override("rotation.x", rotation.x());
  options.append_parameter_override("rotation.y", rotation.y());
  options.append_parameter_override("rotation.z", rotation.z());
  options.append_parameter_override("rotation.w", rotation.w());
  options.append_parameter_override("frame_id", words.at("frame-id"));
  options.append_parameter_override("child_frame_id", words.at("child-frame-id"));
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  arguments.erase(arguments.begin());
  std::shared_ptr<rclcpp::Node> node;
  try {
    const bool has_names = arguments.empty() || arguments.front().substr(0, 2) == "--" ||
                           (arguments.size() % 2 == 0 && arguments.front().size() == 2 &&
                            std::string("-x-y-z").find(arguments.front()) != std::string::npos);
    node = std::make_shared<tf2_ros::StaticTransformBroadcasterNode>(
        options_of(has_names ? by_name(arguments) : by_place(arguments)));
    if (!has_names) {
      RCLCPP_WARN(node->get_logger(),
                  "Old-style arguments are deprecated; see --help for new-style arguments");
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n%s", error.what(), kUsage);
    return 1;
  }
  const auto value = [&node](const char* name) { return node->get_parameter(name).as_double(); };
  RCLCPP_INFO(node->get_logger(),
              "Spinning until stopped - publishing transform\ntranslation: ('%lf', '%lf', '%lf')\n"
              "rotation: ('%lf', '%lf', '%lf', '%lf')\nfrom '%s' to '%s'",
              value("translation.x"), value("translation.y"), value("translation.z"),
              value("rotation.x"), value("rotation.y"), value("rotation.z"), value("rotation.w"),
              node->get_parameter("frame_id").as_string().c_str(),
              node->get_parameter("child_frame_id").as_string().c_str());
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
