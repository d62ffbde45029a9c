// throttle messages <intopic> <msgs_per_sec> [outtopic]
// throttle bytes <intopic> <bytes_per_sec> <window> [outtopic]
#include <cstdio>

#include "program.hpp"
#include "throttle_node.hpp"

namespace {

using topic_tools::Words;

void read_messages(const Words& words, rclcpp::NodeOptions& options) {
  options.append_parameter_override("throttle_type", "messages");
  if (words.size() < 4) return;
  options.append_parameter_override("input_topic", words[2]);
  options.append_parameter_override("msgs_per_sec", topic_tools::number(words[3], "msgs_per_sec"));
  if (words.size() >= 5) options.append_parameter_override("output_topic", words[4]);
}

void read_bytes(const Words& words, rclcpp::NodeOptions& options) {
  options.append_parameter_override("throttle_type", "bytes");
  if (words.size() < 5) return;
  options.append_parameter_override("input_topic", words[2]);
  options.append_parameter_override("bytes_per_sec",
                                    topic_tools::whole_number(words[3], "bytes_per_sec"));
  options.append_parameter_override("window", topic_tools::number(words[4], "window"));
  if (words.size() >= 6) options.append_parameter_override("output_topic", words[5]);
}

}  // namespace

int main(int argc, char** argv) {
  return topic_tools::run<topic_tools::ThrottleNode>(
      argc, argv, 0, [](const Words& words, rclcpp::NodeOptions& options) {
        if (words.size() < 2) {
          std::puts("Throttle type is missing.");
          return false;
        }
        if (words[1] == "messages") read_messages(words, options);
        if (words[1] == "bytes") read_bytes(words, options);
        return true;
      });
}
