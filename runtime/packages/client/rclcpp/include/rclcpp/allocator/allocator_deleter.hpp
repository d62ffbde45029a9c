// Deleters that give memory back to the allocator that it came from.
#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>

namespace rclcpp {
namespace allocator {

/// Does not own the allocator, which must be set before an object is deleted.
template <typename Allocator>
class AllocatorDeleter {
 public:
  AllocatorDeleter() = default;
  explicit AllocatorDeleter(Allocator* allocator) : allocator_(allocator) {}
  template <typename Other>
  AllocatorDeleter(const AllocatorDeleter<Other>& other)  // NOLINT: conversion wanted
      : allocator_(other.get_allocator()) {}

  template <typename T>
  void operator()(T* object) {
    using Traits = typename std::allocator_traits<Allocator>::template rebind_traits<T>;
    typename Traits::allocator_type allocator(*allocator_);
    Traits::destroy(allocator, object);
    Traits::deallocate(allocator, object, 1);
  }

  Allocator* get_allocator() const { return allocator_; }
  void set_allocator(Allocator* allocator) { allocator_ = allocator; }

 private:
  Allocator* allocator_ = nullptr;
};

/// An ordinary delete for the standard allocator.
template <typename Alloc, typename T>
using Deleter = std::conditional_t<
    std::is_same_v<typename std::allocator_traits<Alloc>::template rebind_alloc<T>,
                   std::allocator<T>>,
    std::default_delete<T>, AllocatorDeleter<Alloc>>;

/// Throws std::invalid_argument for a null pointer.
template <typename Alloc, typename T>
void set_allocator_for_deleter(AllocatorDeleter<T>* deleter, Alloc* alloc) {
  if (deleter == nullptr || alloc == nullptr) {
    throw std::invalid_argument("Argument was NULL to set_allocator_for_deleter");
  }
  deleter->set_allocator(alloc);
}

template <typename Alloc, typename T>
void set_allocator_for_deleter(std::default_delete<T>*, Alloc*) {}

}  // namespace allocator
}  // namespace rclcpp
