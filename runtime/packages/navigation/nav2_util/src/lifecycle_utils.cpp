// See lifecycle_utils.hpp.
#include "nav2_util/lifecycle_utils.hpp"

#include <cstdint>
#include <initializer_list>
#include <stdexcept>

#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_util/lifecycle_service_client.hpp"

namespace nav2_util {
namespace {

using lifecycle_msgs::msg::Transition;

void change_states(const std::vector<std::string>& node_names,
                   std::initializer_list<uint8_t> transitions, std::chrono::seconds timeout,
                   int retries) {
  for (const std::string& name : node_names) {
    LifecycleServiceClient client(name);
    for (const uint8_t transition : transitions) {
      for (int failures = 0;; ++failures) {
        try {
          client.change_state(transition, timeout);
          break;
        } catch (const std::runtime_error&) {
          if (failures >= retries) throw;
        }
      }
    }
  }
}

}  // namespace

void startup_lifecycle_nodes(const std::vector<std::string>& node_names,
                             const std::chrono::seconds service_call_timeout, const int retries) {
  change_states(node_names, {Transition::TRANSITION_CONFIGURE, Transition::TRANSITION_ACTIVATE},
                service_call_timeout, retries);
}

void reset_lifecycle_nodes(const std::vector<std::string>& node_names,
                           const std::chrono::seconds service_call_timeout, const int retries) {
  change_states(node_names, {Transition::TRANSITION_DEACTIVATE, Transition::TRANSITION_CLEANUP},
                service_call_timeout, retries);
}

}  // namespace nav2_util
