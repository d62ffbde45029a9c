// The options of create_publisher.
#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/intra_process_buffer_type.hpp"
#include "rclcpp/intra_process_setting.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"

namespace rclcpp {

struct PublisherOptionsBase {
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::SharedPtr;
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints =
      RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED;
  std::shared_ptr<rclcpp::CallbackGroup> callback_group;
  QosOverridingOptions qos_overriding_options;
};

template <typename Allocator>
struct PublisherOptionsWithAllocator : public PublisherOptionsBase {
  static_assert(std::is_void_v<typename std::allocator_traits<Allocator>::value_type>,
                "Publisher allocator value type must be void");

  /// Messages are made with it; null: a default one.
  std::shared_ptr<Allocator> allocator = nullptr;

  PublisherOptionsWithAllocator() {}
  explicit PublisherOptionsWithAllocator(const PublisherOptionsBase& publisher_options_base)
      : PublisherOptionsBase(publisher_options_base) {}

  std::shared_ptr<Allocator> get_allocator() const {
    return allocator ? allocator : std::make_shared<Allocator>();
  }
};

using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

}  // namespace rclcpp
