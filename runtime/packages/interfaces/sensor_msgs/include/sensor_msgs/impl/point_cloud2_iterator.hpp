// Bodies for point_cloud2_iterator.hpp.
#pragma once

#include <algorithm>
#include <cstdarg>
#include <stdexcept>
#include <string>

#include "sensor_msgs/point_cloud2_iterator.hpp"

namespace sensor_msgs {

namespace impl {

inline int point_field_size(int datatype) {
  switch (datatype) {
    case msg::PointField::INT8:
    case msg::PointField::UINT8:
      return 1;
    case msg::PointField::INT16:
    case msg::PointField::UINT16:
      return 2;
    case msg::PointField::INT32:
    case msg::PointField::UINT32:
    case msg::PointField::FLOAT32:
      return 4;
    case msg::PointField::FLOAT64:
      return 8;
    default:
      throw std::runtime_error("PointField of type " + std::to_string(datatype) +
                               " does not exist");
  }
}

/// Returns the offset after the field.
inline int add_point_field(msg::PointCloud2& cloud, const std::string& name, int count,
                           int datatype, int offset) {
  const int size = point_field_size(datatype);
  msg::PointField field;
  field.name = name;
  field.offset = static_cast<uint32_t>(offset);
  field.datatype = static_cast<uint8_t>(datatype);
  field.count = static_cast<uint32_t>(count);
  cloud.fields.push_back(field);
  return offset + count * size;
}

inline void set_point_step(msg::PointCloud2& cloud, int point_step) {
  cloud.point_step = static_cast<uint32_t>(point_step);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(static_cast<size_t>(cloud.height) * cloud.row_step);
}

/// Where in a point the values of a field begin.
inline size_t point_field_offset(const msg::PointCloud2& cloud, const std::string& name) {
  for (const msg::PointField& field : cloud.fields) {
    if (field.name == name) {
      return field.offset;
    }
  }
  // Bytes of a colour, least significant first.
  const size_t channel = name.size() == 1 ? std::string("bgra").find(name) : std::string::npos;
  if (channel != std::string::npos) {
    for (const msg::PointField& field : cloud.fields) {
      if (field.name == "rgb" || field.name == "rgba") {
        return field.offset + (cloud.is_bigendian ? 3 - channel : channel);
      }
    }
  }
  throw std::runtime_error("Field " + name + " does not exist");
}

template <typename T, typename TT, typename U, typename C, template <typename> class V>
PointCloud2IteratorBase<T, TT, U, C, V>::PointCloud2IteratorBase(C& cloud_msg,
                                                                 const std::string& field_name)
    : point_step_(static_cast<std::ptrdiff_t>(cloud_msg.point_step)) {
  const size_t offset = point_field_offset(cloud_msg, field_name);
  data_char_ = cloud_msg.data.data() + offset;
  data_end_ = data_char_ + cloud_msg.data.size();
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
V<T>& PointCloud2IteratorBase<T, TT, U, C, V>::operator=(const V<T>& iter) {
  point_step_ = iter.point_step_;
  data_char_ = iter.data_char_;
  data_end_ = iter.data_end_;
  return *static_cast<V<T>*>(this);
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
TT& PointCloud2IteratorBase<T, TT, U, C, V>::operator[](size_t i) const {
  return reinterpret_cast<TT*>(data_char_)[i];
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
TT& PointCloud2IteratorBase<T, TT, U, C, V>::operator*() const {
  return *reinterpret_cast<TT*>(data_char_);
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
V<T>& PointCloud2IteratorBase<T, TT, U, C, V>::operator++() {
  return *this += 1;
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
V<T> PointCloud2IteratorBase<T, TT, U, C, V>::operator+(int i) {
  V<T> result = *static_cast<V<T>*>(this);
  result += i;
  return result;
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
V<T>& PointCloud2IteratorBase<T, TT, U, C, V>::operator+=(int i) {
  data_char_ += i * point_step_;
  return *static_cast<V<T>*>(this);
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
bool PointCloud2IteratorBase<T, TT, U, C, V>::operator!=(const V<T>& iter) const {
  return iter.data_char_ != data_char_;
}
template <typename T, typename TT, typename U, typename C, template <typename> class V>
V<T> PointCloud2IteratorBase<T, TT, U, C, V>::end() const {
  V<T> result = *static_cast<const V<T>*>(this);
  result.data_char_ = data_end_;
  return result;
}

}  // namespace impl

inline PointCloud2Modifier::PointCloud2Modifier(msg::PointCloud2& cloud_msg)
    : cloud_msg_(cloud_msg) {}
inline size_t PointCloud2Modifier::size() const {
  return cloud_msg_.point_step == 0 ? 0 : cloud_msg_.data.size() / cloud_msg_.point_step;
}
inline void PointCloud2Modifier::reserve(size_t size) {
  cloud_msg_.data.reserve(size * cloud_msg_.point_step);
}
inline void PointCloud2Modifier::resize(size_t size) {
  cloud_msg_.data.resize(size * cloud_msg_.point_step);
  if (cloud_msg_.height != 1 && cloud_msg_.width == 1) {
    cloud_msg_.height = static_cast<uint32_t>(size);
    return;
  }
  cloud_msg_.height = 1;
  cloud_msg_.width = static_cast<uint32_t>(size);
  cloud_msg_.row_step = cloud_msg_.width * cloud_msg_.point_step;
}
inline void PointCloud2Modifier::clear() {
  cloud_msg_.data.clear();
  if (cloud_msg_.height != 1) {
    cloud_msg_.height = 0;
    if (cloud_msg_.width == 1) {
      return;
    }
  }
  cloud_msg_.width = 0;
  cloud_msg_.row_step = 0;
}
inline void PointCloud2Modifier::setPointCloud2Fields(int n_fields, ...) {
  cloud_msg_.fields.clear();
  va_list arguments;
  va_start(arguments, n_fields);
  int offset = 0;
  for (int i = 0; i < n_fields; ++i) {
    const std::string name(va_arg(arguments, const char*));
    const int count = va_arg(arguments, int);
    const int datatype = va_arg(arguments, int);
    offset = impl::add_point_field(cloud_msg_, name, count, datatype, offset);
  }
  va_end(arguments);
  impl::set_point_step(cloud_msg_, offset);
}
inline void PointCloud2Modifier::setPointCloud2FieldsByString(int n_fields, ...) {
  cloud_msg_.fields.clear();
  const int kFloat = msg::PointField::FLOAT32;
  va_list arguments;
  va_start(arguments, n_fields);
  int offset = 0;
  for (int i = 0; i < n_fields; ++i) {
    const std::string group(va_arg(arguments, const char*));
    const int start = offset;
    if (group == "xyz") {
      for (const char* name : {"x", "y", "z"}) {
        offset = impl::add_point_field(cloud_msg_, name, 1, kFloat, offset);
      }
    } else if (group == "rgb" || group == "rgba") {
      impl::add_point_field(cloud_msg_, group, 1, kFloat, offset);
    } else {
      va_end(arguments);
      throw std::runtime_error("Field " + group + " does not exist");
    }
    offset = start + 16;  // as a vector of four floats
  }
  va_end(arguments);
  impl::set_point_step(cloud_msg_, offset);
}

}  // namespace sensor_msgs
