// drop <intopic> <X> <Y> [outtopic]
#include "drop_node.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace topic_tools;
  return run<DropNode>(argc, argv, 0, [](const Words& words, rclcpp::NodeOptions& options) {
    if (words.size() < 4) return true;
    options.append_parameter_override("input_topic", words[1]);
    options.append_parameter_override("X", whole_number(words[2], "X"));
    options.append_parameter_override("Y", whole_number(words[3], "Y"));
    if (words.size() >= 5) options.append_parameter_override("output_topic", words[4]);
    return true;
  });
}
