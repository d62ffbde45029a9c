// The two halves of a cycle.
#pragma once

namespace hardware_interface {

enum class TriggerType { READ, WRITE };

}  // namespace hardware_interface
