// Base class of everything that an executor runs: subscriptions, services, clients, timers,
// waitables.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

namespace rclcpp {
namespace detail {

class Executable {
 public:
  virtual ~Executable() = default;
  /// The bus endpoint whose data makes it ready; -1: none.
  virtual int32_t ready_endpoint() const { return -1; }
  /// Whether the executor must call is_ready_now at every turn.
  virtual bool polls() const { return false; }
  /// If it polls: is_ready_now is needed only after the status version of the bus has changed.
  virtual bool follows_status() const { return false; }
  /// Ready for a reason of its own.
  virtual bool is_ready_now() { return false; }
  /// Called under the executor's lock before it runs; false: nothing to do after all.
  virtual bool claim(std::shared_ptr<void>& data) {
    (void)data;
    return true;
  }
  /// Takes one piece of work and calls back. False: there was none.
  virtual bool run(std::shared_ptr<void>& data) = 0;
};

/// Grows whenever nodes, groups or entities come or go anywhere: executors then look again.
uint32_t entities_version();
void bump_entities_version();

}  // namespace detail
}  // namespace rclcpp
