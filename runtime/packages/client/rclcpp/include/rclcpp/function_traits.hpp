// Which ways a callable can be called.
#pragma once

#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>

namespace rclcpp {
namespace function_traits {

template <typename FunctionT>
struct function_traits : function_traits<decltype(&std::decay_t<FunctionT>::operator())> {};

template <typename ReturnT, typename... Args>
struct function_traits<ReturnT(Args...)> {
  using arguments = std::tuple<Args...>;
  static constexpr std::size_t arity = sizeof...(Args);
  template <std::size_t N>
  using argument_type = typename std::tuple_element<N, arguments>::type;
  using return_type = ReturnT;
};

template <typename ReturnT, typename... Args>
struct function_traits<ReturnT (*)(Args...)> : function_traits<ReturnT(Args...)> {};
template <typename ReturnT, typename... Args>
struct function_traits<ReturnT (&)(Args...)> : function_traits<ReturnT(Args...)> {};
template <typename ClassT, typename ReturnT, typename... Args>
struct function_traits<ReturnT (ClassT::*)(Args...)> : function_traits<ReturnT(Args...)> {};
template <typename ClassT, typename ReturnT, typename... Args>
struct function_traits<ReturnT (ClassT::*)(Args...) const> : function_traits<ReturnT(Args...)> {};
template <typename ClassT, typename ReturnT, typename... Args>
struct function_traits<ReturnT (ClassT::*)(Args...) noexcept> : function_traits<ReturnT(Args...)> {
};
template <typename ClassT, typename ReturnT, typename... Args>
struct function_traits<ReturnT (ClassT::*)(Args...) const noexcept>
    : function_traits<ReturnT(Args...)> {};

template <std::size_t Arity, typename FunctorT>
struct arity_comparator : std::bool_constant<Arity == function_traits<FunctorT>::arity> {};

template <typename FunctorT, typename... Args>
struct check_arguments
    : std::is_same<typename function_traits<FunctorT>::arguments, std::tuple<Args...>> {};

template <typename FunctorAT, typename FunctorBT>
struct same_arguments : std::is_same<typename function_traits<FunctorAT>::arguments,
                                     typename function_traits<FunctorBT>::arguments> {};

}  // namespace function_traits
}  // namespace rclcpp
