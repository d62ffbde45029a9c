// mux <outtopic> <intopic1> [intopic2...]
#include "mux_node.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace topic_tools;
  return run<MuxNode>(argc, argv, 1, [](const Words& words, rclcpp::NodeOptions& options) {
    if (words.size() < 3) {
      RCLCPP_ERROR(rclcpp::get_logger("mux"),
                   "Incorect number of arguments. Usage: ros2 run topic_tools mux <outtopic> "
                   "<intopic1> [intopic2...]");
      return false;
    }
    options.append_parameter_override("output_topic", words[1]);
    options.append_parameter_override("input_topics", Words(words.begin() + 2, words.end()));
    return true;
  });
}
