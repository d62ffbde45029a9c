// As the tutorial on publishing images has it, with a camera: ends when nobody looks any more.

// Compatibility, works: image_transport with the transport raw: publishers, subscribers, cameras,
// filters, hints, and the node `republish`, which is a program of the channel

// Compatibility, differs: transports of image_transport other than raw (compressed, theora) ->
// `TransportLoadException`, as where their plugins are not installed

#include <chrono>
#include <image_transport/image_transport.hpp>
#include <memory>

#include "checks.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/image_encodings.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("camera");
  const auto node = rclcpp::Node::make_shared("camera", "front");
  image_transport::ImageTransport it(node);
  const image_transport::CameraPublisher pub = it.advertiseCamera("image_raw", 5);
  image_transport::Publisher nobody;
  CHECK(pub.getTopic() == "/front/image_raw" && pub.getInfoTopic() == "/front/camera_info");
  CHECK(!nobody && nobody.getTopic().empty() && nobody.getNumSubscribers() == 0);
  CHECK(it.getDeclaredTransports().size() == 1);
  CHECK_THROWS(image_transport::TransportLoadException,
               image_transport::create_subscription(
                   node.get(), "elsewhere", [](const sensor_msgs::msg::Image::ConstSharedPtr&) {},
                   "compressed"));

  sensor_msgs::msg::Image image;
  image.header.frame_id = "lens";
  image.encoding = sensor_msgs::image_encodings::RGB8;
  image.height = 4;
  image.width = 6;
  image.step = image.width * sensor_msgs::image_encodings::numChannels(image.encoding);
  image.data.resize(image.step * image.height, 7);
  sensor_msgs::msg::CameraInfo info;
  info.header.frame_id = "lens";
  info.width = image.width;
  info.height = image.height;

  bool was_seen = false;
  rclcpp::Rate rate(50);
  while (rclcpp::ok() && !(was_seen && pub.getNumSubscribers() == 0)) {
    was_seen = was_seen || pub.getNumSubscribers() > 0;
    pub.publish(image, info, node->now());
    rclcpp::spin_some(node);
    rate.sleep();
  }
  return checks.finish();
}
