// relay <intopic> [outtopic]
#include "program.hpp"
#include "relay_node.hpp"

int main(int argc, char** argv) {
  using namespace topic_tools;
  return run<RelayNode>(argc, argv, 0, [](const Words& words, rclcpp::NodeOptions& options) {
    if (words.size() >= 2) options.append_parameter_override("input_topic", words[1]);
    if (words.size() >= 3) options.append_parameter_override("output_topic", words[2]);
    return true;
  });
}
