// Throws dice at random times, sums what others throw with the help of a service: a site of several
// of them is all chance, unless it runs stepped. `--ros-args -p host:=true` gives the service.
#include <random>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int64.hpp"

using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::Int64;

class Dice : public rclcpp::Node {
 public:
  Dice() : Node("dice"), random_(std::random_device()()) {
    if (declare_parameter("host", false)) {
      service_ = create_service<AddTwoInts>("/sum", [](AddTwoInts::Request::SharedPtr request,
                                                       AddTwoInts::Response::SharedPtr response) {
        response->sum = request->a + request->b;
      });
    }
    client_ = create_client<AddTwoInts>("/sum");
    thrown_ = create_publisher<Int64>("/thrown", 10);
    sums_ = create_publisher<Int64>("/sums", 10);
    heard_ = create_subscription<Int64>("/thrown", 10, [this](const Int64& thrown) {
      auto request = std::make_shared<AddTwoInts::Request>();
      request->a = sum_;
      request->b = thrown.data;
      client_->async_send_request(request, [this](rclcpp::Client<AddTwoInts>::SharedFuture sum) {
        sum_ = sum.get()->sum;
        sums_->publish(Int64().set__data(sum_));
      });
    });
    throw_soon();
  }

 private:
  void throw_soon() {
    const std::chrono::milliseconds soon(std::uniform_int_distribution<>(5, 50)(random_));
    timer_ = create_wall_timer(soon, [this] {
      timer_->cancel();
      thrown_->publish(Int64().set__data(std::uniform_int_distribution<>(1, 6)(random_)));
      throw_soon();
    });
  }

  std::mt19937 random_;
  int64_t sum_ = 0;
  rclcpp::Service<AddTwoInts>::SharedPtr service_;
  rclcpp::Client<AddTwoInts>::SharedPtr client_;
  rclcpp::Publisher<Int64>::SharedPtr thrown_;
  rclcpp::Publisher<Int64>::SharedPtr sums_;
  rclcpp::Subscription<Int64>::SharedPtr heard_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Dice>());
  rclcpp::shutdown();
  return 0;
}
