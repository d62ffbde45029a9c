// Passes commands on to several interfaces of one joint.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "forward_command_controller/forward_controllers_base.hpp"
#include "ros2wasm_parameters/parameters.hpp"

namespace forward_command_controller {

struct MultiInterfaceParams {
  std::string joint;
  std::vector<std::string> interface_names;
};

class MultiInterfaceForwardCommandController : public ForwardControllersBase {
 public:
  MultiInterfaceForwardCommandController() = default;

 protected:
  void declare_parameters() override;
  controller_interface::CallbackReturn read_parameters() override;

  using ParamListener = ros2wasm_parameters::ParameterListener<MultiInterfaceParams>;
  std::shared_ptr<ParamListener> param_listener_;
  MultiInterfaceParams params_;
};

}  // namespace forward_command_controller
