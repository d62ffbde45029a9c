// Values in the buffer of a point cloud, whose type is told by a PointField's number.
#pragma once

#include <cstdint>
#include <cstring>

#include "sensor_msgs/msg/point_field.hpp"

namespace sensor_msgs {

template <int>
struct pointFieldTypeAsType {};
template <typename T>
struct typeAsPointFieldType {};

#define SENSOR_MSGS_POINT_FIELD(NUMBER, TYPE)             \
  template <>                                             \
  struct pointFieldTypeAsType<msg::PointField::NUMBER> {  \
    typedef TYPE type;                                    \
  };                                                      \
  template <>                                             \
  struct typeAsPointFieldType<TYPE> {                     \
    static const uint8_t value = msg::PointField::NUMBER; \
  };
SENSOR_MSGS_POINT_FIELD(INT8, int8_t)
SENSOR_MSGS_POINT_FIELD(UINT8, uint8_t)
SENSOR_MSGS_POINT_FIELD(INT16, int16_t)
SENSOR_MSGS_POINT_FIELD(UINT16, uint16_t)
SENSOR_MSGS_POINT_FIELD(INT32, int32_t)
SENSOR_MSGS_POINT_FIELD(UINT32, uint32_t)
SENSOR_MSGS_POINT_FIELD(FLOAT32, float)
SENSOR_MSGS_POINT_FIELD(FLOAT64, double)
#undef SENSOR_MSGS_POINT_FIELD

template <int point_field_type, typename T>
T readPointCloud2BufferValue(const unsigned char* data_ptr) {
  typename pointFieldTypeAsType<point_field_type>::type value;
  std::memcpy(&value, data_ptr, sizeof value);
  return static_cast<T>(value);
}
template <int point_field_type, typename T>
void writePointCloud2BufferValue(unsigned char* data_ptr, T value) {
  const auto stored = static_cast<typename pointFieldTypeAsType<point_field_type>::type>(value);
  std::memcpy(data_ptr, &stored, sizeof stored);
}

/// T() for an unknown type.
template <typename T>
T readPointCloud2BufferValue(const unsigned char* data_ptr, const unsigned char datatype) {
  switch (datatype) {
    case msg::PointField::INT8:
      return readPointCloud2BufferValue<msg::PointField::INT8, T>(data_ptr);
    case msg::PointField::UINT8:
      return readPointCloud2BufferValue<msg::PointField::UINT8, T>(data_ptr);
    case msg::PointField::INT16:
      return readPointCloud2BufferValue<msg::PointField::INT16, T>(data_ptr);
    case msg::PointField::UINT16:
      return readPointCloud2BufferValue<msg::PointField::UINT16, T>(data_ptr);
    case msg::PointField::INT32:
      return readPointCloud2BufferValue<msg::PointField::INT32, T>(data_ptr);
    case msg::PointField::UINT32:
      return readPointCloud2BufferValue<msg::PointField::UINT32, T>(data_ptr);
    case msg::PointField::FLOAT32:
      return readPointCloud2BufferValue<msg::PointField::FLOAT32, T>(data_ptr);
    case msg::PointField::FLOAT64:
      return readPointCloud2BufferValue<msg::PointField::FLOAT64, T>(data_ptr);
    default:
      return T();
  }
}
/// Does nothing for an unknown type.
template <typename T>
void writePointCloud2BufferValue(unsigned char* data_ptr, const unsigned char datatype, T value) {
  switch (datatype) {
    case msg::PointField::INT8:
      return writePointCloud2BufferValue<msg::PointField::INT8, T>(data_ptr, value);
    case msg::PointField::UINT8:
      return writePointCloud2BufferValue<msg::PointField::UINT8, T>(data_ptr, value);
    case msg::PointField::INT16:
      return writePointCloud2BufferValue<msg::PointField::INT16, T>(data_ptr, value);
    case msg::PointField::UINT16:
      return writePointCloud2BufferValue<msg::PointField::UINT16, T>(data_ptr, value);
    case msg::PointField::INT32:
      return writePointCloud2BufferValue<msg::PointField::INT32, T>(data_ptr, value);
    case msg::PointField::UINT32:
      return writePointCloud2BufferValue<msg::PointField::UINT32, T>(data_ptr, value);
    case msg::PointField::FLOAT32:
      return writePointCloud2BufferValue<msg::PointField::FLOAT32, T>(data_ptr, value);
    case msg::PointField::FLOAT64:
      return writePointCloud2BufferValue<msg::PointField::FLOAT64, T>(data_ptr, value);
    default:
      return;
  }
}

}  // namespace sensor_msgs
