// Names of the states of components and controllers.
#pragma once

namespace hardware_interface {
namespace lifecycle_state_names {

constexpr char UNKNOWN[] = "unknown";
constexpr char UNCONFIGURED[] = "unconfigured";
constexpr char INACTIVE[] = "inactive";
constexpr char ACTIVE[] = "active";
constexpr char FINALIZED[] = "finalized";

}  // namespace lifecycle_state_names
}  // namespace hardware_interface
