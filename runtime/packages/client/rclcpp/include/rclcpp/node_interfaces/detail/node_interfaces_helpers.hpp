// Finds an interface of a node: get_interface<I>(node) works for nodes, pointers and interfaces.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace rclcpp {
namespace node_interfaces {
namespace helpers {

/// Specialised for each interface by the macro below; `get` asks a node for it.
template <typename InterfaceT>
struct InterfaceOf;

template <typename T, typename = void>
struct IsPointer : std::false_type {};
template <typename T>
struct IsPointer<T, std::void_t<decltype(*std::declval<T&>())>> : std::true_type {};

/// The node itself, of a node or of any pointer to one.
template <typename T>
auto& dereference(T& node) {
  if constexpr (IsPointer<T>::value) {
    return *node;
  } else {
    return node;
  }
}

}  // namespace helpers
}  // namespace node_interfaces
}  // namespace rclcpp

#define RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(InterfaceT, NAME)               \
  namespace rclcpp::node_interfaces::helpers {                                \
  template <>                                                                 \
  struct InterfaceOf<InterfaceT> {                                            \
    template <typename NodeT>                                                 \
    static std::shared_ptr<InterfaceT> get(NodeT& node) {                     \
      return node.get_node_##NAME##_interface();                              \
    }                                                                         \
    /* The same question, answered by a class that keeps interfaces. */       \
    template <typename KeeperT>                                               \
    struct Getter {                                                           \
      std::shared_ptr<InterfaceT> get_node_##NAME##_interface() const {       \
        return static_cast<const KeeperT&>(*this).template get<InterfaceT>(); \
      }                                                                       \
    };                                                                        \
  };                                                                          \
  }                                                                           \
  namespace rclcpp::node_interfaces {                                         \
  inline std::shared_ptr<InterfaceT> get_node_##NAME##_interface(             \
      std::shared_ptr<InterfaceT> interface) {                                \
    return interface;                                                         \
  }                                                                           \
  template <typename NodeT>                                                   \
  std::shared_ptr<InterfaceT> get_node_##NAME##_interface(NodeT&& node) {     \
    return helpers::InterfaceOf<InterfaceT>::get(helpers::dereference(node)); \
  }                                                                           \
  }
