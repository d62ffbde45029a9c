// Pictures in memory, and the files that they are read from and written to.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "Color.h"
#include "Exception.h"

namespace Magick {

/// Nothing has to be set up here.
inline void InitializeMagick(const char*) {}

enum ImageType {
  UndefinedType,
  BilevelType,
  GrayscaleType,
  GrayscaleMatteType,
  PaletteType,
  PaletteMatteType,
  TrueColorType,
  TrueColorMatteType
};

enum StorageType { CharPixel, ShortPixel, IntegerPixel, LongPixel, FloatPixel, DoublePixel };

class Geometry {
 public:
  Geometry() = default;
  Geometry(unsigned int width, unsigned int height) : width_(width), height_(height) {}
  unsigned int width() const { return width_; }
  unsigned int height() const { return height_; }

 private:
  unsigned int width_ = 0;
  unsigned int height_ = 0;
};

/// The bytes of a file.
class Blob {
 public:
  Blob() = default;
  Blob(const void* data, std::size_t length) : bytes_(static_cast<const char*>(data), length) {}
  const void* data() const { return bytes_.data(); }
  std::size_t length() const { return bytes_.size(); }

 private:
  std::string bytes_;
};

/// A format of files by its name; ErrorOption for one that is not there.
class CoderInfo {
 public:
  explicit CoderInfo(const std::string& name);
  std::string name() const { return name_; }
  bool isReadable() const { return true; }
  bool isWritable() const { return true; }
  bool isMultiFrame() const { return false; }

 private:
  std::string name_;
};

class Image {
 public:
  Image() = default;
  /// A file; "png:name" names its format.
  explicit Image(const std::string& file) { read(file); }
  explicit Image(const Blob& blob) { read(blob); }
  Image(const Geometry& size, const Color& color);

  void read(const std::string& file);
  void read(const Blob& blob);
  /// In the format that magick() names, else that of the name's ending.
  void write(const std::string& file);
  void write(Blob* blob) { *blob = encoded(magick_); }
  void write(Blob* blob, const std::string& format) {
    magick(format);
    write(blob);
  }
  /// Pixels from column x and row y: for each one value per letter of `map` (R, G, B, A, O, I).
  void write(int x, int y, unsigned int columns, unsigned int rows, const std::string& map,
             StorageType storage, void* pixels) const;

  unsigned int columns() const { return size_.width(); }
  unsigned int rows() const { return size_.height(); }
  Geometry size() const { return size_; }
  bool isValid() const { return !pixels_.empty(); }
  std::string fileName() const { return file_; }

  std::string magick() const { return magick_; }
  void magick(const std::string& format) { magick_ = CoderInfo(format).name(); }
  /// Bits of a sample in files: 8 or 16.
  unsigned int depth() const { return depth_; }
  void depth(unsigned int bits) { depth_ = bits > 8 ? 16 : 8; }
  /// Quality of JPEG files, 1 to 100.
  unsigned int quality() const { return quality_; }
  void quality(unsigned int quality) { quality_ = quality; }
  /// Whether pixels have an opacity.
  bool matte() const { return has_matte_; }
  void matte(bool has_matte);
  ImageType type() const;
  /// Changes pixels: grey, black or white, and opaque where the type says so.
  void type(ImageType type);

  Color pixelColor(unsigned int x, unsigned int y) const;
  void pixelColor(unsigned int x, unsigned int y, const Color& color);
  void flip();
  void flop();
  void negate(bool only_gray = false);

 private:
  struct Pixel {
    Quantum red, green, blue, opacity;
    /// Weights 0.299, 0.587, 0.114.
    Quantum gray() const {
      return static_cast<Quantum>((306U * red + 601U * green + 117U * blue) >> 10U);
    }
    bool is_gray() const { return red == green && green == blue; }
  };
  friend struct Codecs;

  std::size_t index(unsigned int x, unsigned int y) const;
  Blob encoded(const std::string& format) const;
  bool is_gray() const;

  Geometry size_;
  std::vector<Pixel> pixels_;  // rows from the top
  std::string file_;
  std::string magick_;
  unsigned int depth_ = 16;
  unsigned int quality_ = 75;
  bool has_matte_ = false;
};

}  // namespace Magick
