// Runs an unscented Kalman filter as a node.
#include <memory>
#include <stdexcept>
#include <utility>

#include "filter/ukf.hpp"
#include "node/filter_node.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto filter = std::make_unique<robot_localization::Ukf>();
  robot_localization::Ukf& ukf = *filter;
  auto node =
      std::make_shared<robot_localization::FilterNode>("ukf_filter_node", std::move(filter));
  const double alpha = node->declare_parameter("alpha", 0.001);
  const double kappa = node->declare_parameter("kappa", 0.0);
  const double beta = node->declare_parameter("beta", 2.0);
  if (!ukf.set_constants(alpha, kappa, beta)) {
    throw std::invalid_argument("alpha^2 * (15 + kappa) must be positive");
  }
  node->start();
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
