// See bridge_argument.hpp.
#include "bridge_argument.hpp"

namespace ros_gz_bridge {
namespace {

/// Where the sign stands that separates the types; npos: none, or nothing is before it.
std::size_t place_of(const std::string& text, char sign) {
  const std::size_t at = text.find(sign);
  return at == 0 ? std::string::npos : at;
}

std::optional<BridgeArgument> service(const std::string& name, const std::string& types) {
  ServiceEntry entry{.service = name, .ros_type = types, .gz_request = {}, .gz_answer = {}};
  if (types.find_first_of("[]") != std::string::npos) return std::nullopt;
  const std::size_t at = place_of(types, '@');
  if (at == std::string::npos) return types[0] == '@' ? std::nullopt : std::optional(entry);
  entry.ros_type = types.substr(0, at);
  const std::string rest = types.substr(at + 1);
  const std::size_t second = place_of(rest, '@');
  if (second == std::string::npos) return std::nullopt;
  entry.gz_request = rest.substr(0, second);
  entry.gz_answer = rest.substr(second + 1);
  return entry;
}

}  // namespace

std::optional<BridgeArgument> read_bridge_argument(const std::string& text) {
  const std::size_t name_end = place_of(text, '@');
  if (name_end == std::string::npos || name_end + 1 == text.size()) return std::nullopt;
  const std::string name = text.substr(0, name_end);
  const std::string types = text.substr(name_end + 1);
  if (types.substr(0, types.find_first_of("@[]")).find("/srv/") != std::string::npos)
    return service(name, types);
  BridgeEntry entry;
  entry.ros_topic = entry.gz_topic = name;
  std::size_t at = place_of(types, ']');
  entry.direction = Direction::kRosToGz;
  if (at == std::string::npos) {
    at = place_of(types, '[');
    entry.direction = Direction::kGzToRos;
  }
  if (at == std::string::npos) {
    at = place_of(types, '@');
    entry.direction = Direction::kBoth;
  }
  if (at == std::string::npos) return std::nullopt;
  entry.ros_type = types.substr(0, at);
  entry.gz_type = types.substr(at + 1);
  // A topic of another name on Gazebo's side.
  if (const std::size_t more = entry.gz_type.find('@'); more != std::string::npos) {
    entry.gz_topic = entry.gz_type.substr(more + 1);
    entry.gz_type.erase(more);
    if (entry.gz_topic.empty() || entry.gz_topic.find('@') != std::string::npos)
      return std::nullopt;
  }
  if (entry.gz_type.empty()) return std::nullopt;
  return entry;
}

std::string bridge_usage() {
  return "Carries topics and services between ROS 2 and Gazebo.\n\n"
         "  parameter_bridge [<topic@ROS_type@GZ_type> ..]  "
         "[<service@ROS_srv_type[@GZ_request_type@GZ_response_type]> ..]\n\n"
         "The sign between the types of a topic is its direction:\n"
         "  @  both ways\n"
         "  [  from Gazebo to ROS\n"
         "  ]  from ROS to Gazebo\n\n"
         "Examples:\n"
         "  parameter_bridge /chatter@std_msgs/msg/String@gz.msgs.StringMsg\n"
         "  parameter_bridge /scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan\n"
         "  parameter_bridge /cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist\n"
         "  parameter_bridge /world/default/control@ros_gz_interfaces/srv/ControlWorld\n";
}

}  // namespace ros_gz_bridge
