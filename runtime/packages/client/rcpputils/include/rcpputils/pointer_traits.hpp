// The type that a plain or smart pointer points to.
#pragma once

#include <memory>
#include <type_traits>

namespace rcpputils {
namespace details {

template <class T>
struct is_smart_pointer_helper : std::false_type {};
template <class T>
struct is_smart_pointer_helper<std::shared_ptr<T>> : std::true_type {};
template <class T, class D>
struct is_smart_pointer_helper<std::unique_ptr<T, D>> : std::true_type {};

}  // namespace details

template <class T>
struct is_smart_pointer : details::is_smart_pointer_helper<std::remove_cv_t<T>> {};

template <class T>
struct is_pointer : std::bool_constant<std::is_pointer_v<std::remove_reference_t<T>> ||
                                       is_smart_pointer<std::remove_reference_t<T>>::value> {};

template <class T>
struct remove_pointer {
  using type = std::remove_reference_t<decltype(*std::declval<std::remove_reference_t<T>&>())>;
};
template <class T>
using remove_pointer_t = typename remove_pointer<T>::type;

}  // namespace rcpputils
