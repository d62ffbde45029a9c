// usage: view_frames [-t SECONDS] [-o NAME] [--tf_topic TOPIC] [--tf_static_topic TOPIC]
// Listens for some seconds, says which frames there are, and writes their graph to NAME.gv. No PDF
// is made of it: a browser has no Graphviz.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/qos.hpp"

namespace {

using tf2_msgs::msg::TFMessage;

struct Asked {
  double wait_time = 5.0;  ///< [s]
  std::string output;
  std::string tf_topic = "/tf";
  std::string tf_static_topic = "/tf_static";
};

Asked read_arguments(const std::vector<std::string>& words) {
  Asked asked;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (i + 1 == words.size()) throw std::invalid_argument(words[i]);
    const std::string& option = words[i];
    const std::string& value = words[++i];
    if (option == "-t" || option == "--wait-time") {
      asked.wait_time = std::stod(value);
    } else if (option == "-o" || option == "--output") {
      asked.output = value;
    } else if (option == "--tf_topic") {
      asked.tf_topic = value;
    } else if (option == "--tf_static_topic") {
      asked.tf_static_topic = value;
    } else {
      throw std::invalid_argument(option);
    }
  }
  return asked;
}

/// 5 is printed as 5.0, as in Python.
std::string as_float(double value) {
  std::ostringstream text;
  text << value;
  return text.str().find_first_of(".e") == std::string::npos ? text.str() + ".0" : text.str();
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d_%H.%M.%S", std::localtime(&now));
  return text;
}

/// The text in quotes, as Python prints it.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '\n') {
      result += "\\n";
    } else {
      if (letter == '"' || letter == '\\') result += '\\';
      result += letter;
    }
  }
  return result + "\"";
}

int run(const Asked& asked) {
  const auto node = rclcpp::Node::make_shared("view_frames");
  tf2_ros::Buffer buffer(node->get_clock());
  const auto listen = [&](const std::string& topic, const rclcpp::QoS& qos, bool is_static) {
    return node->create_subscription<TFMessage>(
        topic, qos, [&, is_static](const TFMessage& message) {
          for (const auto& transform : message.transforms) {
            buffer.setTransform(transform, "default_authority", is_static);
          }
        });
  };
  const auto moving = listen(asked.tf_topic, tf2_ros::DynamicListenerQoS(), false);
  const auto fixed = listen(asked.tf_static_topic, tf2_ros::StaticListenerQoS(), true);

  RCLCPP_INFO(node->get_logger(), "Listening to tf data for %s seconds...",
              as_float(asked.wait_time).c_str());
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(asked.wait_time);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok() && std::chrono::steady_clock::now() < end) {
    executor.spin_once(std::chrono::milliseconds(100));
  }
  RCLCPP_INFO(node->get_logger(), "Generating graph...");
  const std::string frames = buffer.allFramesAsYAML();
  RCLCPP_INFO(node->get_logger(), "Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml=%s)",
              quoted(frames).c_str());
  const std::string file = (asked.output.empty() ? "frames_" + date() : asked.output) + ".gv";
  RCLCPP_INFO(node->get_logger(), "Exporting graph in %s file...", file.c_str());
  std::ofstream(file) << buffer._allFramesAsDot();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  int status = 2;
  try {
    status = run(read_arguments(words));
  } catch (const std::invalid_argument& wrong) {
    std::fprintf(stderr, "view_frames: error: unrecognized arguments: %s\n", wrong.what());
  }
  rclcpp::shutdown();
  return status;
}
