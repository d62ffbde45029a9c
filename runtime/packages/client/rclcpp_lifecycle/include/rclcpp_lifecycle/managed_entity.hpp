// An entity that is activated and deactivated together with its node.
#pragma once

#include <atomic>

#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle {

class ManagedEntityInterface {
 public:
  virtual ~ManagedEntityInterface() = default;
  virtual void on_activate() = 0;
  virtual void on_deactivate() = 0;
};

/// Remembers whether it is active; at first it is not.
class SimpleManagedEntity : public ManagedEntityInterface {
 public:
  ~SimpleManagedEntity() override = default;
  void on_activate() override;
  void on_deactivate() override;
  bool is_activated() const;

 private:
  std::atomic<bool> activated_ = false;
};

}  // namespace rclcpp_lifecycle
