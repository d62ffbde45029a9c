// Services, clients, futures, deferred answers, and waiting for what does not come.
#include "checks.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"

using example_interfaces::srv::AddTwoInts;
using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("services");
  auto node = std::make_shared<rclcpp::Node>("services_node");
  auto client = node->create_client<AddTwoInts>("add");
  CHECK(!client->wait_for_service(10ms));
  auto server = node->create_service<AddTwoInts>(
      "add", [](const std::shared_ptr<AddTwoInts::Request> request,
                std::shared_ptr<AddTwoInts::Response> response) {
        response->sum = request->a + request->b;
      });
  CHECK(client->wait_for_service(1s));
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 41;
  request->b = 1;
  auto answer = client->async_send_request(request);
  CHECK(rclcpp::spin_until_future_complete(node, answer) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(answer.get()->sum == 42);

  int64_t called_with = 0;
  auto with_callback = client->async_send_request(
      request, [&called_with](rclcpp::Client<AddTwoInts>::SharedFuture future) {
        called_with = future.get()->sum;
      });
  rclcpp::spin_until_future_complete(node, with_callback.future);
  CHECK(called_with == 42);

  // An answer that comes later.
  std::shared_ptr<rmw_request_id_t> waiting;
  auto later = node->create_service<AddTwoInts>(
      "later", [&waiting](const std::shared_ptr<rmw_request_id_t> header,
                          const std::shared_ptr<AddTwoInts::Request>) { waiting = header; });
  auto later_client = node->create_client<AddTwoInts>("later");
  auto later_answer = later_client->async_send_request(request);
  CHECK(rclcpp::spin_until_future_complete(node, later_answer, 20ms) ==
        rclcpp::FutureReturnCode::TIMEOUT);
  CHECK(waiting != nullptr);
  AddTwoInts::Response response;
  response.sum = 7;
  later->send_response(*waiting, response);
  CHECK(rclcpp::spin_until_future_complete(node, later_answer, 1s) ==
        rclcpp::FutureReturnCode::SUCCESS);
  CHECK(later_answer.get()->sum == 7);

  auto nobody = node->create_client<AddTwoInts>("nobody");
  auto pending = nobody->async_send_request(request);
  CHECK(nobody->remove_pending_request(pending));
  CHECK(!nobody->remove_pending_request(pending));
  return checks.finish();
}
