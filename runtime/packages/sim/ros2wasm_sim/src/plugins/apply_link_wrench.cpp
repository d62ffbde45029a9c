// ApplyLinkWrench of Gazebo Sim, of a world: forces and torques on links and models.
#include <ros_gz_interfaces/msg/entity.hpp>
#include <ros_gz_interfaces/msg/entity_wrench.hpp>

#include <map>

#include "plugins/gz_topics.hpp"

namespace ros2wasm_sim {
namespace {

using ros_gz_interfaces::msg::Entity;
using ros_gz_interfaces::msg::EntityWrench;

/// Along the axes of the world.
struct LinkWrench {
  Vector3 force, torque;
};

Vector3 vector_of(const geometry_msgs::msg::Vector3& v) {
  return {v.x, v.y, v.z};
}

class ApplyLinkWrench final : public System {
 public:
  explicit ApplyLinkWrench(const PluginContext& context)
      : simulation_(context.simulation), logger_(context.host.node()->get_logger()) {
    const std::string prefix = "/world/" + context.simulation.world().name + "/wrench";
    once_ = subscribe_gz<EntityWrench>(context.host, prefix, [this](const EntityWrench& message) {
      if (const LinkHandle link = link_of(message.entity); link.valid())
        add(link, message, pending_);
    });
    persistent_ = subscribe_gz<EntityWrench>(
        context.host, prefix + "/persistent", [this](const EntityWrench& message) {
          if (const LinkHandle link = link_of(message.entity); link.valid())
            add(link, message, lasting_);
        });
    clear_ = subscribe_gz<Entity>(context.host, prefix + "/clear", [this](const Entity& entity) {
      if (const LinkHandle link = link_of(entity); link.valid()) lasting_.erase(link.index);
    });
  }

  void before_step(const Now&) override {
    for (const auto* wrenches : {&lasting_, &pending_})
      for (const auto& [index, wrench] : *wrenches) {
        const LinkHandle link{index};
        Physics& physics = simulation_.physics();
        physics.add_wrench(link, wrench.force, wrench.torque, physics.centre_of_mass(link));
      }
    pending_.clear();
  }

  void on_reset() override {
    lasting_.clear();
    pending_.clear();
  }

 private:
  using Wrenches = std::map<int, LinkWrench>;  ///< by the number of the link

  static void add(LinkHandle link, const EntityWrench& message, Wrenches& wrenches) {
    LinkWrench& sum = wrenches[link.index];
    sum.force = sum.force + vector_of(message.wrench.force);
    sum.torque = sum.torque + vector_of(message.wrench.torque);
  }

  /// A link as `model::link`; the canonical link of a model.
  LinkHandle link_of(const Entity& entity) {
    const std::size_t colons = entity.name.find("::");
    std::string model = entity.name.substr(0, colons), link;
    if (colons != std::string::npos) {
      link = entity.name.substr(colons + 2);
    } else if (const Model* one = simulation_.model(model)) {
      link = one->canonical_link.empty() ? one->links.front().name : one->canonical_link;
    }
    const LinkHandle found = simulation_.physics().link(model, link);
    if (!found.valid()) RCLCPP_ERROR(logger_, "Entity [%s] not found", entity.name.c_str());
    return found;
  }

  Simulation& simulation_;
  rclcpp::Logger logger_;
  Wrenches pending_;  ///< for the next step only
  Wrenches lasting_;  ///< until they are cleared
  rclcpp::Subscription<EntityWrench>::SharedPtr once_, persistent_;
  rclcpp::Subscription<Entity>::SharedPtr clear_;
};

}  // namespace

std::unique_ptr<System> make_apply_link_wrench(const PluginContext& context) {
  return std::make_unique<ApplyLinkWrench>(context);
}

}  // namespace ros2wasm_sim
