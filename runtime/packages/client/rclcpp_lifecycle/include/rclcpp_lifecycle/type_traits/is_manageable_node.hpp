// Whether a type can be activated and deactivated as managed entities are.
#pragma once

#include <type_traits>
#include <utility>

template <class T, typename = void>
struct has_on_activate : std::false_type {};

template <class T>
struct has_on_activate<
    T, std::enable_if_t<std::is_same_v<void, decltype(std::declval<T>().on_activate())>>>
    : std::true_type {};

template <class T, typename = void>
struct has_on_deactivate : std::false_type {};

template <class T>
struct has_on_deactivate<
    T, std::enable_if_t<std::is_same_v<void, decltype(std::declval<T>().on_deactivate())>>>
    : std::true_type {};

template <class T>
struct is_manageable_node : std::conjunction<has_on_activate<T>, has_on_deactivate<T>> {};
