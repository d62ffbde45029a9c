// Records a topic, as the tutorial "Recording a bag from a node" does.

// Compatibility, works: rosbag2_cpp: `Writer` of serialised messages and of values, `Reader`, with
// filters, read orders and seek, several files, snapshots; rosbag2_transport's
// `ReaderWriterFactory::make_reader`; bags are MCAP with metadata.yaml, in the node's file system

// Compatibility, differs: rosbag2_cpp and rosbag2_py -> MCAP is the one storage, sqlite3 (.db3) is
// refused; bags are written uncompressed, and read uncompressed or with chunks of LZ4; zstd, and
// bags that are compressed by file or message, are refused. A bag of a C++ node has the definitions
// of types that the program publishes, subscribes to or writes as values. The bag of a node that is
// killed is lost. Reading by published time, and files from behind, is refused as ROS 2's storage
// of MCAP refuses it

#include <memory>
#include <string>

#include <rclcpp/rclcpp.hpp>
#include <rosbag2_cpp/writer.hpp>
#include <std_msgs/msg/string.hpp>

using std::placeholders::_1;

class Recorder : public rclcpp::Node {
 public:
  Recorder() : Node("recorder") {
    writer_ = std::make_unique<rosbag2_cpp::Writer>();
    writer_->open("my_bag");
    subscription_ = create_subscription<std_msgs::msg::String>(
        "chatter", 10, std::bind(&Recorder::topic_callback, this, _1));
  }

 private:
  void topic_callback(std::shared_ptr<rclcpp::SerializedMessage> msg) const {
    rclcpp::Time time_stamp = this->now();
    writer_->write(msg, "chatter", "std_msgs/msg/String", time_stamp);
    RCLCPP_INFO(get_logger(), "recorded %zu bytes", msg->size());
  }

  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
  std::unique_ptr<rosbag2_cpp::Writer> writer_;
};

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Recorder>());
  rclcpp::shutdown();
  return 0;
}
