// delay <intopic> <delay> [outtopic]
#include "delay_node.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace topic_tools;
  return run<DelayNode>(argc, argv, 0, [](const Words& words, rclcpp::NodeOptions& options) {
    if (words.size() >= 2) options.append_parameter_override("input_topic", words[1]);
    if (words.size() >= 3) options.append_parameter_override("delay", number(words[2], "delay"));
    if (words.size() >= 4) options.append_parameter_override("output_topic", words[3]);
    return true;
  });
}
