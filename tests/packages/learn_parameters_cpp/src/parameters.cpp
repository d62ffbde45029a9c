#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

class MinimalParam : public rclcpp::Node
{
public:
  MinimalParam()
  : Node("minimal_param_node")
  {
    auto param_desc = rcl_interfaces::msg::ParameterDescriptor{};
    param_desc.description = "Whom to greet";
    this->declare_parameter("my_parameter", "world", param_desc);
    this->declare_parameter<std::vector<double>>("gains", {1.0, 0.5});
    param_handle_ = this->add_on_set_parameters_callback(
      [](const std::vector<rclcpp::Parameter> & parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        for (const auto & parameter : parameters) {
          if (parameter.get_name() == "my_parameter" && parameter.as_string() == "nobody") {
            result.successful = false;
            result.reason = "somebody must be greeted";
          }
        }
        return result;
      });
    events_ = std::make_shared<rclcpp::ParameterEventHandler>(this);
    event_handle_ = events_->add_parameter_callback("my_parameter", [this](const rclcpp::Parameter & p) {
          RCLCPP_INFO(
            this->get_logger(), "Received an update to parameter \"%s\" of type %s: \"%s\"", p.get_name().c_str(),
            p.get_type_name().c_str(), p.as_string().c_str());
        });
    timer_ = this->create_wall_timer(100ms, [this]() {this->timer_callback();});
  }

private:
  void timer_callback()
  {
    std::string my_param = this->get_parameter("my_parameter").as_string();
    RCLCPP_INFO(this->get_logger(), "Hello %s!", my_param.c_str());
    if (my_param != "world") {
      return;
    }
    auto refused = this->set_parameter(rclcpp::Parameter("my_parameter", "nobody"));
    RCLCPP_INFO(this->get_logger(), "refused: %s", refused.reason.c_str());
    std::vector<rclcpp::Parameter> all_new_parameters{rclcpp::Parameter("my_parameter", "moon")};
    this->set_parameters(all_new_parameters);
    RCLCPP_INFO(this->get_logger(), "gains: %zu", this->get_parameter("gains").as_double_array().size());
  }

  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Node::OnSetParametersCallbackHandle::SharedPtr param_handle_;
  std::shared_ptr<rclcpp::ParameterEventHandler> events_;
  std::shared_ptr<rclcpp::ParameterCallbackHandle> event_handle_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<MinimalParam>());
  rclcpp::shutdown();
  return 0;
}
