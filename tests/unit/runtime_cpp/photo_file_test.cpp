// Pictures as files, and those that cannot be written.
#include "photo_file.hpp"

#include <stdexcept>

#include "gtest/gtest.h"

namespace nav2_waypoint_follower {
namespace {

using Bytes = std::vector<uint8_t>;

TEST(PhotoFile, RowsWithGapsAndBothOrdersOfColours) {
  // Two rows of two pixels, with two bytes between the rows.
  const Bytes rgb{1, 2, 3, 4, 5, 6, 0, 0, 7, 8, 9, 10, 11, 12, 0, 0};
  const Bytes bgr{3, 2, 1, 6, 5, 4, 9, 9, 9, 8, 7, 12, 11, 10, 9, 9};
  const std::string file = photo_file({2, 2, 8, "rgb8", rgb}, "bmp");
  EXPECT_EQ(file.substr(0, 2), "BM");
  EXPECT_EQ(file.substr(54),
            std::string("\x09\x08\x07\x0c\x0b\x0a\0\0\x03\x02\x01\x06\x05\x04\0\0", 16));
  EXPECT_EQ(photo_file({2, 2, 8, "bgr8", bgr}, "bmp"), file);
}

TEST(PhotoFile, Formats) {
  const Bytes data(64, 100);
  for (const char* encoding : {"mono8", "rgb8", "bgr8", "rgba8", "bgra8"}) {
    const Photo photo{4, 4, 16, encoding, data};
    EXPECT_EQ(photo_file(photo, "png").substr(1, 3), "PNG") << encoding;
    EXPECT_EQ(photo_file(photo, "jpg").substr(0, 2), "\xff\xd8") << encoding;
    EXPECT_EQ(photo_file(photo, "jpeg"), photo_file(photo, "jpg")) << encoding;
  }
}

TEST(PhotoFile, RefusesWhatItCannotWrite) {
  const Bytes data(48, 100);
  EXPECT_THROW(photo_file({0, 0, 0, "", {}}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({0, 4, 0, "rgb8", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 0, 12, "rgb8", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 4, 12, "16UC1", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 4, 12, "rgb8", data}, "tiff"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 5, 12, "rgb8", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 4, 11, "rgb8", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({0xffffffff, 1, 0xffffffff, "rgb8", data}, "png"), std::runtime_error);
  EXPECT_THROW(photo_file({4, 0xffffffff, 0xffffffff, "rgb8", data}, "png"), std::runtime_error);
}

}  // namespace
}  // namespace nav2_waypoint_follower
