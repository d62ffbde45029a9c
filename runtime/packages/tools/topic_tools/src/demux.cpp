// demux <intopic> <outtopic1> [outtopic2...]
#include "demux_node.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace topic_tools;
  return run<DemuxNode>(argc, argv, 1, [](const Words& words, rclcpp::NodeOptions& options) {
    if (words.size() < 3) {
      RCLCPP_ERROR(rclcpp::get_logger("demux"),
                   "Incorect number of arguments. Usage: ros2 run topic_tools demux <intopic> "
                   "<outtopic1> [outtopic2...]");
      return false;
    }
    options.append_parameter_override("input_topic", words[1]);
    options.append_parameter_override("output_topics", Words(words.begin() + 2, words.end()));
    return true;
  });
}
