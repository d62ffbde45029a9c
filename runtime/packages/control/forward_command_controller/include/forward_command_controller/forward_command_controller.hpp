// Passes commands on to one interface of several joints.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "forward_command_controller/forward_controllers_base.hpp"
#include "ros2wasm_parameters/parameters.hpp"

namespace forward_command_controller {

struct Params {
  std::vector<std::string> joints;
  std::string interface_name;
};
using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

class ForwardCommandController : public ForwardControllersBase {
 public:
  ForwardCommandController() = default;

 protected:
  void declare_parameters() override;
  controller_interface::CallbackReturn read_parameters() override;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
};

}  // namespace forward_command_controller
