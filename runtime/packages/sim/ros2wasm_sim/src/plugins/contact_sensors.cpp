// Contact sensors: libgazebo_ros_bumper.so, and `contact` of Gazebo Sim.
#include <gazebo_msgs/msg/contacts_state.hpp>
#include <ros_gz_interfaces/msg/contacts.hpp>

#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"
#include "plugins/sensor_names.hpp"
#include "sensors/contact_sensor.hpp"

namespace ros2wasm_sim {
namespace {

geometry_msgs::msg::Wrench wrench_message(const Wrench& wrench) {
  geometry_msgs::msg::Wrench message;
  message.force = vector_message(wrench.force);
  message.torque = vector_message(wrench.torque);
  return message;
}

ContactSensor contact_sensor_of(const PluginContext& context) {
  return {*context.sensor, context.physics(), context.model->name, *context.link};
}

void report(const ContactSensor& sensor, const rclcpp::Logger& logger) {
  for (const std::string& warning : sensor.warnings()) RCLCPP_WARN(logger, "%s", warning.c_str());
}

class ClassicBumper final : public System {
 public:
  explicit ClassicBumper(const PluginContext& context)
      : node_(context.host, context.plugin),
        sensor_(contact_sensor_of(context)),
        rate_(context.sensor->update_rate),
        frame_(Parameters(context.plugin.xml).text("frame_name", "world")) {
    if (context.sensor->type != "contact")
      throw PluginError("Contact sensor parent is not of type ContactSensor. Aborting");
    report(sensor_, node_->get_logger());
    publisher_ = node_->create_publisher<gazebo_msgs::msg::ContactsState>(
        "bumper_states", rclcpp::SensorDataQoS().reliable());
    RCLCPP_INFO(node_->get_logger(), "Publishing contact states to [%s]",
                publisher_->get_topic_name());
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    gazebo_msgs::msg::ContactsState message;
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    const std::vector<Contact> contacts = sensor_.touching();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      message.states.push_back(state_of(contacts[i]));
      message.states.back().info = "Debug:  i: (" + std::to_string(i + 1) + "/" +
                                   std::to_string(contacts.size()) + ")     my_geom: [" +
                                   message.states.back().collision1_name + "]  other_geom: [" +
                                   message.states.back().collision2_name + "]        time: [" +
                                   std::to_string(message.header.stamp.sec) + "." +
                                   std::to_string(message.header.stamp.nanosec) + "]\n";
    }
    publisher_->publish(message);
  }

  void on_reset() override { rate_.reset(); }

 private:
  static gazebo_msgs::msg::ContactState state_of(const Contact& contact) {
    gazebo_msgs::msg::ContactState state;
    state.collision1_name = contact.first;
    state.collision2_name = contact.second;
    Wrench total;
    for (const ContactPoint& point : contact.points) {
      state.wrenches.push_back(wrench_message(point.wrench));
      total.force = total.force + point.wrench.force;
      total.torque = total.torque + point.wrench.torque;
      state.contact_positions.push_back(vector_message(point.position));
      state.contact_normals.push_back(vector_message(point.normal));
      state.depths.push_back(point.depth);
    }
    state.total_wrench = wrench_message(total);
    return state;
  }

  PluginNode node_;
  ContactSensor sensor_;
  Rate rate_;
  std::string frame_;
  rclcpp::Publisher<gazebo_msgs::msg::ContactsState>::SharedPtr publisher_;
};

ros_gz_interfaces::msg::Entity collision_named(std::string_view name) {
  ros_gz_interfaces::msg::Entity entity;
  entity.name = name;
  entity.type = ros_gz_interfaces::msg::Entity::COLLISION;
  return entity;
}

/// In each step, but only while something touches.
class GzContact final : public System {
 public:
  explicit GzContact(const PluginContext& context) : sensor_(contact_sensor_of(context)) {
    const auto logger = context.host.node()->get_logger();
    report(sensor_, logger);
    const Parameters contact = Parameters(context.sensor->xml).inside("contact");
    std::string topic = contact.text("topic", "");
    // The second one is what Gazebo writes for "not given".
    if (topic.empty() || topic == "__default_topic__") topic = sensor_topic(context, "/contact");
    publisher_ = publish_gz<ros_gz_interfaces::msg::Contacts>(context.host, topic);
    RCLCPP_INFO(logger, "Contact system publishing on %s", topic.c_str());
  }

  void after_step(const Now& now) override {
    if (publisher_->get_subscription_count() == 0) return;
    ros_gz_interfaces::msg::Contacts message;
    message.header.stamp = stamp_of(now.time_ns);
    for (const Contact& contact : sensor_.touching())
      message.contacts.push_back(contact_message(contact));
    if (!message.contacts.empty()) publisher_->publish(message);
  }

 private:
  static ros_gz_interfaces::msg::Contact contact_message(const Contact& contact) {
    ros_gz_interfaces::msg::Contact message;
    message.collision1 = collision_named(contact.first);
    message.collision2 = collision_named(contact.second);
    for (const ContactPoint& point : contact.points) {
      message.positions.push_back(vector_message(point.position));
      message.normals.push_back(vector_message(point.normal));
      message.depths.push_back(point.depth);
      ros_gz_interfaces::msg::JointWrench wrench;
      wrench.body_1_name.data = contact.first;
      wrench.body_2_name.data = contact.second;
      wrench.body_1_wrench = wrench_message(point.wrench);
      wrench.body_2_wrench =
          wrench_message({-1.0 * point.wrench.force, -1.0 * point.wrench.torque});
      message.wrenches.push_back(wrench);
    }
    return message;
  }

  ContactSensor sensor_;
  rclcpp::Publisher<ros_gz_interfaces::msg::Contacts>::SharedPtr publisher_;
};

}  // namespace

std::unique_ptr<System> make_classic_bumper(const PluginContext& context) {
  return std::make_unique<ClassicBumper>(context);
}
std::unique_ptr<System> make_gz_contact(const PluginContext& context) {
  return std::make_unique<GzContact>(context);
}

}  // namespace ros2wasm_sim
