#include <functional>
#include <memory>
#include <set>
#include <string>

#include "learn_interfaces/msg/num.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/serialization.hpp"
#include "std_msgs/msg/string.hpp"

using std::placeholders::_1;
using std_msgs::msg::String;

class MinimalSubscriber : public rclcpp::Node
{
public:
  MinimalSubscriber()
  : Node("minimal_subscriber")
  {
    keep(this->create_subscription<String>("topic", 10, std::bind(&MinimalSubscriber::topic_callback, this, _1)));
    keep(this->create_subscription<String>("topic", 10,
      [this](const String & msg) {heard("constant reference", msg);}));
    keep(this->create_subscription<String>("topic", 10,
      [this](const String & msg, const rclcpp::MessageInfo & info) {
        const auto & about = info.get_rmw_message_info();
        heard(about.source_timestamp > 0 ? "constant reference with info" : "no stamp", msg);
      }));
    keep(this->create_subscription<String>("topic", 10,
      [this](String::UniquePtr msg) {
        msg->data += "!";
        heard("unique pointer", *msg);
      }));
    keep(this->create_subscription<String>("topic", rclcpp::SensorDataQoS(),
      [this](String::ConstSharedPtr msg) {heard("shared pointer to constant", *msg);}));
    keep(this->create_subscription<String>("topic", rclcpp::QoS(rclcpp::KeepLast(3)).best_effort(),
      [this](const String::SharedPtr msg) {heard("shared pointer", *msg);}));
    keep(this->create_subscription<String>("topic", 10,
      [this](const std::shared_ptr<const String> & msg, const rclcpp::MessageInfo &) {
        heard("reference to shared pointer, with info", *msg);
      }));
    keep(this->create_subscription<String>("topic", 10,
      [this](std::shared_ptr<rclcpp::SerializedMessage> bytes) {
        String msg;
        rclcpp::Serialization<String> serialization;
        serialization.deserialize_message(bytes.get(), &msg);
        heard("bytes", msg);
      }));
    numbers_ = this->create_subscription<learn_interfaces::msg::Num>("num", 10,
      [this](learn_interfaces::msg::Num::ConstSharedPtr msg) {
        RCLCPP_INFO_ONCE(this->get_logger(), "I heard the number %ld", static_cast<long>(msg->num));
      });
  }

private:
  void keep(rclcpp::Subscription<String>::SharedPtr one) {subscriptions_.push_back(one);}

  void topic_callback(const String::ConstSharedPtr msg) {heard("member function", *msg);}

  void heard(const std::string & how, const String & msg)
  {
    if (!forms_.insert(how).second) {
      return;
    }
    RCLCPP_INFO(this->get_logger(), "I heard as %s: '%s'", how.c_str(), msg.data.c_str());
    if (forms_.size() == subscriptions_.size()) {
      RCLCPP_INFO(this->get_logger(), "heard in all %zu forms", forms_.size());
    }
  }

  std::vector<rclcpp::Subscription<String>::SharedPtr> subscriptions_;
  rclcpp::Subscription<learn_interfaces::msg::Num>::SharedPtr numbers_;
  std::set<std::string> forms_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<MinimalSubscriber>());
  rclcpp::shutdown();
  return 0;
}
