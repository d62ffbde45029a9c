// As the tutorial on subscribing to images has it: the camera's images, what `republish` makes of
// them, and both by way of a filter.
#include <image_transport/image_transport.hpp>
#include <image_transport/subscriber_filter.hpp>
#include <memory>

#include "checks.hpp"
#include "image_transport/camera_common.hpp"
#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/image_encodings.hpp"

using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;
namespace encodings = sensor_msgs::image_encodings;

class Viewer {
 public:
  Viewer(Checks& shared, const rclcpp::Node::SharedPtr& node)
      : checks(shared), node_(node), it_(node) {
    const image_transport::TransportHints hints(node.get());
    CHECK(hints.getTransport() == "raw");
    camera_ = it_.subscribeCamera("front/image_raw", 5, &Viewer::on_camera, this, &hints);
    again_ = it_.subscribe("again", 1, &Viewer::on_again, this);
    CHECK(again_.getTransport() == "raw" && again_.getTopic() == "/again");
    CHECK(camera_.getInfoTopic() == "/front/camera_info");
    filter_.subscribe(node.get(), "front/image_raw", "raw");
    filter_again_.subscribe(node.get(), "again", "raw");
    sync_.registerCallback(&Viewer::on_both, this);
  }
  bool is_done() const { return cameras_ > 2 && again_count_ > 2 && both_ > 2; }

  void stop() {
    camera_.shutdown();
    CHECK(!camera_ && camera_.getTopic().empty());
    again_.shutdown();
    CHECK(again_.getNumPublishers() == 0);
  }

 private:
  void on_camera(const Image::ConstSharedPtr& image, const CameraInfo::ConstSharedPtr& info) {
    if (++cameras_ == 1) {
      CHECK(image->header == info->header && image->width == info->width);
      CHECK(image->data.size() == 72 && image->data[71] == 7);
      CHECK(encodings::isColor(image->encoding) && encodings::bitDepth(image->encoding) == 8);
      CHECK(camera_.getNumPublishers() == 1);
    }
  }
  void on_again(const Image::ConstSharedPtr& image) {
    if (++again_count_ == 1) {
      CHECK(image->header.frame_id == "lens");
    }
  }
  void on_both(const Image::ConstSharedPtr& a, const Image::ConstSharedPtr& b) {
    ++both_;
    if (a->header.stamp == b->header.stamp && !was_same_) {
      was_same_ = true;
      CHECK(a->data == b->data);
    }
  }

  Checks& checks;
  rclcpp::Node::SharedPtr node_;
  image_transport::ImageTransport it_;
  image_transport::CameraSubscriber camera_;
  image_transport::Subscriber again_;
  image_transport::SubscriberFilter filter_;
  image_transport::SubscriberFilter filter_again_;
  message_filters::Synchronizer<message_filters::sync_policies::ApproximateTime<Image, Image>>
      sync_{message_filters::sync_policies::ApproximateTime<Image, Image>(10), filter_,
            filter_again_};
  int cameras_ = 0;
  int again_count_ = 0;
  int both_ = 0;
  bool was_same_ = false;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("viewer");
  CHECK(encodings::numChannels("16SC3") == 3 && encodings::bitDepth("16SC3") == 16);
  CHECK(encodings::numChannels("8UC") == 1 && encodings::bitDepth("bayer_rggb16") == 16);
  CHECK(encodings::isMono("mono16") && encodings::hasAlpha("bgra8") && !encodings::isColor("8UC3"));
  CHECK_THROWS(std::runtime_error, encodings::numChannels("9UC1"));
  CHECK(image_transport::getCameraInfoTopic("/a/b/image") == "/a/b/camera_info");
  CHECK(image_transport::getCameraInfoTopic("image") == "camera_info");
  {
    const auto node = rclcpp::Node::make_shared("viewer");
    Viewer viewer(checks, node);
    while (rclcpp::ok() && !viewer.is_done()) {
      rclcpp::spin_some(node);
      rclcpp::sleep_for(std::chrono::milliseconds(5));
    }
    viewer.stop();
  }
  return checks.finish();
}
