// lifecycle_bringup NODE...: configures and activates managed nodes in the order of the words.
#include <cstdio>
#include <string>
#include <vector>

#include "nav2_util/lifecycle_utils.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[]) {
  if (argc == 1) {
    std::fputs(
        "Invalid command line.\n\n"
        "This command will take a set of unconfigured lifecycle nodes through the\n"
        "CONFIGURED to the ACTIVATED state\n"
        "The nodes are brought up in the order listed on the command line\n\n"
        "Usage:\n"
        " > lifecycle_startup <node name> ...\n",
        stderr);
    return 1;
  }
  rclcpp::init(0, nullptr);
  nav2_util::startup_lifecycle_nodes(std::vector<std::string>(argv + 1, argv + argc),
                                     std::chrono::seconds(10));
  rclcpp::shutdown();
  return 0;
}
