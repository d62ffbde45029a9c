// Transmissions from their descriptions, as plugins.
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "transmission_interface/differential_transmission.hpp"
#include "transmission_interface/differential_transmission_loader.hpp"
#include "transmission_interface/four_bar_linkage_transmission.hpp"
#include "transmission_interface/four_bar_linkage_transmission_loader.hpp"
#include "transmission_interface/simple_transmission.hpp"
#include "transmission_interface/simple_transmission_loader.hpp"

namespace transmission_interface {
namespace {

using hardware_interface::TransmissionInfo;

template <typename TransmissionT>
std::shared_ptr<Transmission> of_two_joints(const TransmissionInfo& info, const char* logger) {
  try {
    const auto& joints = info.joints;
    const auto& actuators = info.actuators;
    return std::make_shared<TransmissionT>(
        std::vector<double>{actuators.at(0).mechanical_reduction,
                            actuators.at(1).mechanical_reduction},
        std::vector<double>{joints.at(0).mechanical_reduction, joints.at(1).mechanical_reduction},
        std::vector<double>{joints.at(0).offset, joints.at(1).offset});
  } catch (const std::exception& error) {
    RCLCPP_ERROR(rclcpp::get_logger(logger), "Failed to construct transmission '%s'", error.what());
    return nullptr;
  }
}

}  // namespace

std::shared_ptr<Transmission> SimpleTransmissionLoader::load(const TransmissionInfo& info) {
  try {
    return std::make_shared<SimpleTransmission>(info.joints.at(0).mechanical_reduction,
                                                info.joints.at(0).offset);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(rclcpp::get_logger("simple_transmission_loader"),
                 "Failed to construct transmission '%s'", error.what());
    return nullptr;
  }
}
std::shared_ptr<Transmission> DifferentialTransmissionLoader::load(const TransmissionInfo& info) {
  return of_two_joints<DifferentialTransmission>(info, "differential_transmission_loader");
}
std::shared_ptr<Transmission> FourBarLinkageTransmissionLoader::load(const TransmissionInfo& info) {
  return of_two_joints<FourBarLinkageTransmission>(info, "four_bar_linkage_transmission_loader");
}

}  // namespace transmission_interface

PLUGINLIB_EXPORT_CLASS(transmission_interface::SimpleTransmissionLoader,
                       transmission_interface::TransmissionLoader)
PLUGINLIB_EXPORT_CLASS(transmission_interface::DifferentialTransmissionLoader,
                       transmission_interface::TransmissionLoader)
PLUGINLIB_EXPORT_CLASS(transmission_interface::FourBarLinkageTransmissionLoader,
                       transmission_interface::TransmissionLoader)
