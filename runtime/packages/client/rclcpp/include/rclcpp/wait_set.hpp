// The kinds of wait sets.
#pragma once

#include <cstddef>

#include "rclcpp/wait_set_policies/dynamic_storage.hpp"
#include "rclcpp/wait_set_policies/sequential_synchronization.hpp"
#include "rclcpp/wait_set_policies/static_storage.hpp"
#include "rclcpp/wait_set_policies/thread_safe_synchronization.hpp"
#include "rclcpp/wait_set_template.hpp"

namespace rclcpp {

/// Entities may be added and removed between waits.
using WaitSet = WaitSetTemplate<wait_set_policies::SequentialSynchronization,
                                wait_set_policies::DynamicStorage>;
/// As WaitSet; entities may also be added and removed by other threads.
using ThreadSafeWaitSet = WaitSetTemplate<wait_set_policies::ThreadSafeSynchronization,
                                          wait_set_policies::DynamicStorage>;
/// Entities, in these numbers, are given to the constructor.
template <std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardCondtions,
          std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
          std::size_t NumberOfWaitables>
using StaticWaitSet = WaitSetTemplate<
    wait_set_policies::SequentialSynchronization,
    wait_set_policies::StaticStorage<NumberOfSubscriptions, NumberOfGuardCondtions, NumberOfTimers,
                                     NumberOfClients, NumberOfServices, NumberOfWaitables>>;

}  // namespace rclcpp
