// Point clouds: their fields and size, and iterators over the values of one field.
#pragma once

#include <cstddef>
#include <string>

#include "sensor_msgs/msg/point_cloud2.hpp"

namespace sensor_msgs {

/// Lays out a cloud. It keeps a reference to the message.
class PointCloud2Modifier {
 public:
  explicit PointCloud2Modifier(msg::PointCloud2& cloud_msg);

  /// Points in the cloud.
  size_t size() const;
  void reserve(size_t size);
  /// A cloud with height 1 (or width 1) stays so.
  void resize(size_t size);
  void clear();

  /// For each field its name (const char *), its count and its type (int), without padding.
  void setPointCloud2Fields(int n_fields, ...);
  /// Groups of fields with the usual padding: "xyz", "rgb", "rgba" (const char *).
  void setPointCloud2FieldsByString(int n_fields, ...);

 protected:
  msg::PointCloud2& cloud_msg_;
};

namespace impl {

/// T is the type of the field's values, TT the same as it is seen (const or not), U a byte, C a
/// cloud, V the iterator itself.
template <typename T, typename TT, typename U, typename C, template <typename> class V>
class PointCloud2IteratorBase {
 public:
  PointCloud2IteratorBase() = default;
  /// Throws std::runtime_error when there is no such field; r, g, b and a are parts of rgb and
  /// rgba.
  PointCloud2IteratorBase(C& cloud_msg, const std::string& field_name);

  V<T>& operator=(const V<T>& iter);
  /// The i-th value of the field in the point.
  TT& operator[](size_t i) const;
  TT& operator*() const;
  V<T>& operator++();
  V<T> operator+(int i);
  V<T>& operator+=(int i);
  bool operator!=(const V<T>& iter) const;
  V<T> end() const;

 private:
  std::ptrdiff_t point_step_ = 0;
  U* data_char_ = nullptr;
  U* data_end_ = nullptr;
};

}  // namespace impl

template <typename T>
class PointCloud2Iterator
    : public impl::PointCloud2IteratorBase<T, T, unsigned char, msg::PointCloud2,
                                           PointCloud2Iterator> {
 public:
  PointCloud2Iterator(msg::PointCloud2& cloud_msg, const std::string& field_name)
      : impl::PointCloud2IteratorBase<T, T, unsigned char, msg::PointCloud2,
                                      sensor_msgs::PointCloud2Iterator>(cloud_msg, field_name) {}
};

template <typename T>
class PointCloud2ConstIterator
    : public impl::PointCloud2IteratorBase<T, const T, const unsigned char, const msg::PointCloud2,
                                           PointCloud2ConstIterator> {
 public:
  PointCloud2ConstIterator(const msg::PointCloud2& cloud_msg, const std::string& field_name)
      : impl::PointCloud2IteratorBase<T, const T, const unsigned char, const msg::PointCloud2,
                                      sensor_msgs::PointCloud2ConstIterator>(cloud_msg,
                                                                             field_name) {}
};

}  // namespace sensor_msgs

#include "sensor_msgs/impl/point_cloud2_iterator.hpp"
