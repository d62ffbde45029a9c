// Names of image encodings, and what they say of a pixel.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace sensor_msgs {
namespace image_encodings {

constexpr char RGB8[] = "rgb8";
constexpr char RGBA8[] = "rgba8";
constexpr char RGB16[] = "rgb16";
constexpr char RGBA16[] = "rgba16";
constexpr char BGR8[] = "bgr8";
constexpr char BGRA8[] = "bgra8";
constexpr char BGR16[] = "bgr16";
constexpr char BGRA16[] = "bgra16";
constexpr char MONO8[] = "mono8";
constexpr char MONO16[] = "mono16";

// Channels of numbers, named as OpenCV does.
constexpr char TYPE_8UC1[] = "8UC1";
constexpr char TYPE_8UC2[] = "8UC2";
constexpr char TYPE_8UC3[] = "8UC3";
constexpr char TYPE_8UC4[] = "8UC4";
constexpr char TYPE_8SC1[] = "8SC1";
constexpr char TYPE_8SC2[] = "8SC2";
constexpr char TYPE_8SC3[] = "8SC3";
constexpr char TYPE_8SC4[] = "8SC4";
constexpr char TYPE_16UC1[] = "16UC1";
constexpr char TYPE_16UC2[] = "16UC2";
constexpr char TYPE_16UC3[] = "16UC3";
constexpr char TYPE_16UC4[] = "16UC4";
constexpr char TYPE_16SC1[] = "16SC1";
constexpr char TYPE_16SC2[] = "16SC2";
constexpr char TYPE_16SC3[] = "16SC3";
constexpr char TYPE_16SC4[] = "16SC4";
constexpr char TYPE_32SC1[] = "32SC1";
constexpr char TYPE_32SC2[] = "32SC2";
constexpr char TYPE_32SC3[] = "32SC3";
constexpr char TYPE_32SC4[] = "32SC4";
constexpr char TYPE_32FC1[] = "32FC1";
constexpr char TYPE_32FC2[] = "32FC2";
constexpr char TYPE_32FC3[] = "32FC3";
constexpr char TYPE_32FC4[] = "32FC4";
constexpr char TYPE_64FC1[] = "64FC1";
constexpr char TYPE_64FC2[] = "64FC2";
constexpr char TYPE_64FC3[] = "64FC3";
constexpr char TYPE_64FC4[] = "64FC4";

constexpr char BAYER_RGGB8[] = "bayer_rggb8";
constexpr char BAYER_BGGR8[] = "bayer_bggr8";
constexpr char BAYER_GBRG8[] = "bayer_gbrg8";
constexpr char BAYER_GRBG8[] = "bayer_grbg8";
constexpr char BAYER_RGGB16[] = "bayer_rggb16";
constexpr char BAYER_BGGR16[] = "bayer_bggr16";
constexpr char BAYER_GBRG16[] = "bayer_gbrg16";
constexpr char BAYER_GRBG16[] = "bayer_grbg16";

// YUV422 and YUV422_YUY2 are older names of UYVY and YUYV.
constexpr char UYVY[] = "uyvy";
constexpr char YUV422[] = "yuv422";
constexpr char YUYV[] = "yuyv";
constexpr char YUV422_YUY2[] = "yuv422_yuy2";
constexpr char NV12[] = "nv12";
constexpr char NV21[] = "nv21";
constexpr char NV24[] = "nv24";

constexpr char ABSTRACT_ENCODING_PREFIXES[][5] = {"8UC",  "8SC",  "16UC", "16SC",
                                                  "32SC", "32FC", "64FC"};

namespace impl {

template <std::size_t Count>
bool is_one_of(const std::string& encoding, const char* const (&names)[Count]) {
  return std::find(std::begin(names), std::end(names), encoding) != std::end(names);
}

/// Numbers of a name like 16UC3: bits and channels; 0 bits when it is none.
struct NumberType {
  int bits = 0;
  int channels = 1;
};
inline NumberType number_type(const std::string& encoding) {
  NumberType result;
  const auto kind = encoding.find_first_not_of("0123456789");
  const std::string bits = encoding.substr(0, kind);
  if (kind == std::string::npos || encoding.size() < kind + 2 || encoding[kind + 1] != 'C' ||
      std::string("USF").find(encoding[kind]) == std::string::npos ||
      !is_one_of(bits, {"8", "16", "32", "64"})) {
    return result;
  }
  const std::string channels = encoding.substr(kind + 2);
  if (channels.find_first_not_of("0123456789") != std::string::npos) {
    return result;
  }
  result.bits = std::atoi(bits.c_str());
  result.channels = channels.empty() ? 1 : std::atoi(channels.c_str());
  return result;
}

}  // namespace impl

inline bool isMono(const std::string& encoding) {
  return encoding == MONO8 || encoding == MONO16;
}
inline bool isBayer(const std::string& encoding) {
  return impl::is_one_of(encoding, {BAYER_RGGB8, BAYER_BGGR8, BAYER_GBRG8, BAYER_GRBG8,
                                    BAYER_RGGB16, BAYER_BGGR16, BAYER_GBRG16, BAYER_GRBG16});
}
inline bool hasAlpha(const std::string& encoding) {
  return impl::is_one_of(encoding, {RGBA8, BGRA8, RGBA16, BGRA16});
}
inline bool isPlanar(const std::string& encoding) {
  return impl::is_one_of(encoding, {NV12, NV21, NV24});
}
inline bool isColor(const std::string& encoding) {
  return impl::is_one_of(encoding, {RGB8, BGR8, RGB16, BGR16, YUV422, YUV422_YUY2, UYVY, YUYV}) ||
         hasAlpha(encoding) || isPlanar(encoding);
}

/// Throws std::runtime_error for an unknown encoding, as bitDepth does.
inline int numChannels(const std::string& encoding) {
  if (isMono(encoding) || isBayer(encoding) || encoding == NV12 || encoding == NV21) {
    return 1;
  }
  if (impl::is_one_of(encoding, {YUV422, YUV422_YUY2, UYVY, YUYV, NV24})) {
    return 2;
  }
  if (isColor(encoding)) {
    return hasAlpha(encoding) ? 4 : 3;
  }
  const impl::NumberType numbers = impl::number_type(encoding);
  if (numbers.bits == 0) {
    throw std::runtime_error("Unknown encoding " + encoding);
  }
  return numbers.channels;
}
/// Bits of one channel.
inline int bitDepth(const std::string& encoding) {
  if (const int bits = impl::number_type(encoding).bits; bits != 0) {
    return bits;
  }
  if (!isMono(encoding) && !isBayer(encoding) && !isColor(encoding)) {
    throw std::runtime_error("Unknown encoding " + encoding);
  }
  return encoding.size() > 2 && encoding.compare(encoding.size() - 2, 2, "16") == 0 ? 16 : 8;
}
/// How many rows of data there are for one of the image.
inline float getHeightScaling(const std::string& encoding) {
  return encoding == NV12 || encoding == NV21 ? 1.5F : 1.0F;
}

}  // namespace image_encodings
}  // namespace sensor_msgs
