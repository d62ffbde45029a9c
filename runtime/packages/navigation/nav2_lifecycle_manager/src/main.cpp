// The manager as a program. It needs no thread, so it runs where pages have no shared memory.
#include <memory>

#include "nav2_lifecycle_manager/lifecycle_manager.hpp"
#include "rclcpp/rclcpp.hpp"

namespace {

class ManagerProgram : public nav2_lifecycle_manager::LifecycleManager {
 public:
  ManagerProgram() : LifecycleManager(rclcpp::NodeOptions(), nullptr) {}
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<ManagerProgram>());
  rclcpp::shutdown();
  return 0;
}
