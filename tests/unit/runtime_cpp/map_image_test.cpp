// Images of maps: the portable formats, PNG and BMP, and files that claim more than they have.

// Guarantee, hostile input: an image of a map that is cut, or that claims more pixels than it has
// or than 33,554,432, gives an error, before memory is taken for them

#include <gtest/gtest.h>

#include <stdexcept>

#include "map_image.hpp"

namespace nav2_map_server {
namespace {

using namespace std::string_literals;
using Bytes = std::vector<std::uint8_t>;

std::string error_of(const std::string& bytes) {
  try {
    read_image(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MapImage, ReadsBinaryGrayWithCommentsInItsHeader) {
  const MapImage image = read_image("P5 # CREATOR: x\n2\n# rows\n2 255\n\0\x7f\xcd\xfe"s);
  EXPECT_EQ(image.width, 2U);
  EXPECT_EQ(image.height, 2U);
  EXPECT_EQ(image.gray, (Bytes{0, 127, 205, 254}));
  EXPECT_TRUE(image.alpha.empty());
}

TEST(MapImage, ReadsTextAndScalesToTheLargestValue) {
  EXPECT_EQ(read_image("P2\n3 1\n100\n0 50 100").gray, (Bytes{0, 127, 255}));
  EXPECT_EQ(read_image("P2 2 1 15 7 99\n").gray, (Bytes{119, 255}));  // 99 is cut to 15
}

TEST(MapImage, ReadsSamplesOfTwoBytes) {
  EXPECT_EQ(read_image("P5 3 1 65535\n\x80\x00\xff\xff\x00\xff"s).gray,
            (Bytes{127, 255, 0}));  // 32768 / 257 = 127.5; 255 / 257 < 1
}

TEST(MapImage, WeighsColours) {
  // 306, 601 and 117 parts of 1024.
  EXPECT_EQ(read_image("P3 3 1 255  255 0 0  0 255 0  0 0 255").gray, (Bytes{76, 149, 29}));
  EXPECT_EQ(read_image("P6 1 1 255\n\xff\xff\xff"s).gray, Bytes{255});
}

TEST(MapImage, ReadsBits) {
  EXPECT_EQ(read_image("P1 3 2 101\n0 1 0").gray, (Bytes{0, 255, 0, 255, 0, 255}));
  EXPECT_EQ(read_image("P4 9 1\n\x80\x80"s).gray, (Bytes{0, 255, 255, 255, 255, 255, 255, 255, 0}));
}

TEST(MapImage, RefusesBrokenFiles) {
  EXPECT_EQ(error_of(""), "the image is not a PGM, PNG or BMP file");
  EXPECT_EQ(error_of("GIF89a"), "the image is not a PGM, PNG or BMP file");
  EXPECT_EQ(error_of("P5"), "not a valid portable image: the width is not a number");
  EXPECT_EQ(error_of("P5 2 x"), "not a valid portable image: the height is not a number");
  EXPECT_EQ(error_of("P5 # only a comment"),
            "not a valid portable image: the width is not a number");
  EXPECT_EQ(error_of("P5 0 2 255\n"), "the image has no pixels");
  EXPECT_EQ(error_of("P5 2 2 0\n1234"),
            "not a valid portable image: the largest value is not 1 to 65535");
  EXPECT_EQ(error_of("P5 2 2 70000\n1234"),
            "not a valid portable image: the largest value is not 1 to 65535");
  EXPECT_EQ(error_of("P5 2 2 255\n123"),
            "not a valid portable image: it ends after 3 of 4 bytes of pixels");
  EXPECT_EQ(error_of("P5 2 2 255"),
            "not a valid portable image: it ends after 0 of 4 bytes of pixels");
  EXPECT_EQ(error_of("P2 2 2 255 1 2 3"),
            "not a valid portable image: it ends before its last pixel");
  EXPECT_EQ(error_of("P2 2 1 255 1 -2 3"),
            "not a valid portable image: the value of a pixel is not a number");
  EXPECT_EQ(error_of("P1 2 1 0 2"), "not a valid portable image: a pixel is neither 0 nor 1");
}

TEST(MapImage, RefusesSizesBeforeItReservesMemory) {
  EXPECT_EQ(error_of("P5 999999 999999 255\n"),
            "the image has 999999 x 999999 pixels, more than 33554432");
  EXPECT_EQ(error_of("P5 99999999999 1 255\n"),
            "not a valid portable image: the width is not below 10000000");
  EXPECT_EQ(error_of("P2 5000 5000 255 1"),
            "not a valid portable image: it ends before its last pixel");
  EXPECT_EQ(error_of("P1 5000 5000 1"),
            "not a valid portable image: it ends before its last pixel");
  EXPECT_EQ(error_of("P4 5000 5000 1"),
            "not a valid portable image: it ends before its last pixel");
  EXPECT_NO_THROW(check_size(5792, 5792));
  EXPECT_THROW(check_size(1U << 13, (1U << 12) + 1), std::runtime_error);
}

MapImage checkered(bool has_alpha) {
  MapImage image;
  image.width = 3;
  image.height = 2;
  image.gray = {0, 128, 205, 254, 255, 1};
  if (has_alpha) image.alpha = {255, 0, 255, 255, 0, 255};
  return image;
}

TEST(MapImage, ReadsWhatItWrites) {
  EXPECT_EQ(written_image(checkered(false), "pgm"), "P5\n3 2\n255\n\0\x80\xcd\xfe\xff\x01"s);
  for (const char* format : {"pgm", "png", "bmp"}) {
    const MapImage image = read_image(written_image(checkered(false), format));
    EXPECT_EQ(image.width, 3U) << format;
    EXPECT_EQ(image.gray, checkered(false).gray) << format;
    EXPECT_TRUE(image.alpha.empty()) << format;
  }
  const MapImage clear = read_image(written_image(checkered(true), "png"));
  EXPECT_EQ(clear.gray, checkered(true).gray);
  EXPECT_EQ(clear.alpha, checkered(true).alpha);
}

// The header of OS/2: sizes of 16 bits. Two pixels, white and black, from the bottom.
TEST(MapImage, ReadsTheOldestHeaderOfBmp) {
  const std::string bmp =
      "BM\x22\0\0\0\0\0\0\0\x1a\0\0\0\x0c\0\0\0\x02\0\x01\0\x01\0\x18\0"
      "\xff\xff\xff\0\0\0\0\0"s;
  const MapImage image = read_image(bmp);
  EXPECT_EQ(image.width, 2U);
  EXPECT_EQ(image.height, 1U);
  EXPECT_EQ(image.gray, (std::vector<std::uint8_t>{255, 0}));
  std::string wide = bmp;
  wide[18] = wide[19] = wide[20] = wide[21] = '\xff';
  EXPECT_NE(error_of(wide), "");
}

TEST(MapImage, RefusesPicturesThatEndEarlyOrClaimTooMuch) {
  const std::string png = written_image(checkered(true), "png");
  for (std::size_t size = 0; size + 12 < png.size(); ++size) {
    EXPECT_NE(error_of(png.substr(0, size)), "") << size;
  }
  std::string wide = png;
  wide[18] = 0x7f;  // the third byte of the width
  wide[22] = 0x7f;
  EXPECT_EQ(error_of(wide), "the image has 32515 x 32514 pixels, more than 33554432");
  EXPECT_EQ(error_of("BM"), "the image has no pixels");
  std::string large = png;  // 4096 x 4096 pixels of four samples
  large[18] = large[22] = 0x10;
  large[19] = large[23] = 0;
  EXPECT_EQ(error_of(large), "the pixels of the image take more than 64 MiB");
}

}  // namespace
}  // namespace nav2_map_server
