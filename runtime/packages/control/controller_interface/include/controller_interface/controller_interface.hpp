// The base of controllers that others cannot command.
#pragma once

#include <memory>
#include <vector>

#include "controller_interface/controller_interface_base.hpp"
#include "hardware_interface/handle.hpp"

namespace controller_interface {

class ControllerInterface : public ControllerInterfaceBase {
 public:
  ControllerInterface() = default;
  ~ControllerInterface() override = default;

  bool is_chainable() const final { return false; }
  std::vector<hardware_interface::StateInterface::ConstSharedPtr> export_state_interfaces() final {
    return {};
  }
  std::vector<hardware_interface::CommandInterface::SharedPtr> export_reference_interfaces() final {
    return {};
  }
  bool set_chained_mode(bool /*chained_mode*/) final { return false; }
  bool is_in_chained_mode() const final { return false; }
};

using ControllerInterfaceSharedPtr = std::shared_ptr<ControllerInterface>;

}  // namespace controller_interface
