// Pixels, and files by their names. See Image.h.
#include "Magick++/Image.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "codecs.hpp"

namespace Magick {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return std::toupper(letter); });
  return text;
}

/// The text before the colon of "png:name".
std::string prefix_of(const std::string& file) {
  const std::size_t colon = file.find(':');
  const bool is_format = colon != std::string::npos && file.find('/') > colon;
  return is_format ? file.substr(0, colon) : "";
}

std::string ending_of(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos || file.find('/', dot) != std::string::npos
             ? ""
             : file.substr(dot + 1);
}

void put(Quantum value, StorageType storage, void*& at) {
  const auto store = [&](auto one) {
    *static_cast<decltype(one)*>(at) = one;
    at = static_cast<decltype(one)*>(at) + 1;
  };
  switch (storage) {
    case CharPixel:
      return store(static_cast<std::uint8_t>(value / 257));
    case ShortPixel:
      return store(static_cast<std::uint16_t>(value));
    case IntegerPixel:
      return store(static_cast<std::uint32_t>(value * 65537U));
    case LongPixel:
      return store(static_cast<unsigned long>(value * 65537UL));
    case FloatPixel:
      return store(static_cast<float>(value) / static_cast<float>(MaxRGB));
    case DoublePixel:
      return store(Color::scaled(value));
  }
}

}  // namespace

CoderInfo::CoderInfo(const std::string& name) : name_(upper(name)) {
  if (name_ == "JPG") name_ = "JPEG";
  for (const char* known : {"BMP", "JPEG", "PGM", "PNG", "PNM", "PPM"}) {
    if (name_ == known) return;
  }
  throw ErrorOption("Magick: Coder not found (" + name + ")");
}

Image::Image(const Geometry& size, const Color& color) {
  Codecs::allot(*this, size.width(), size.height());
  const Pixel pixel = {color.redQuantum(), color.greenQuantum(), color.blueQuantum(),
                       color.alphaQuantum()};
  std::fill(pixels_.begin(), pixels_.end(), pixel);
  has_matte_ = color.alphaQuantum() != OpaqueOpacity;
}

void Image::read(const std::string& file) {
  const std::string prefix = prefix_of(file);
  const std::string name = prefix.empty() ? file : file.substr(prefix.size() + 1);
  std::ifstream stream(name, std::ios::binary);
  if (!stream) throw ErrorFileOpen("Magick: Unable to open file (" + name + ")");
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  Codecs::decode(bytes, *this);
  file_ = name;
}

void Image::read(const Blob& blob) {
  Codecs::decode({static_cast<const char*>(blob.data()), blob.length()}, *this);
}

void Image::write(const std::string& file) {
  const std::string prefix = prefix_of(file);
  const std::string name = prefix.empty() ? file : file.substr(prefix.size() + 1);
  const std::string wanted = !prefix.empty()            ? prefix
                             : !ending_of(name).empty() ? ending_of(name)
                                                        : magick_;
  const Blob blob = encoded(wanted);
  std::ofstream stream(name, std::ios::binary);
  stream.write(static_cast<const char*>(blob.data()), static_cast<std::streamsize>(blob.length()));
  stream.close();
  if (!stream) throw ErrorFileOpen("Magick: Unable to open file (" + name + ")");
  file_ = name;
}

Blob Image::encoded(const std::string& format) const {
  if (pixels_.empty()) throw ErrorOption("Magick: the image has no pixels");
  const std::string bytes = Codecs::encode(*this, CoderInfo(format).name());
  return {bytes.data(), bytes.size()};
}

void Image::write(int x, int y, unsigned int columns, unsigned int rows, const std::string& map,
                  StorageType storage, void* pixels) const {
  const bool is_inside = x >= 0 && y >= 0 && static_cast<unsigned int>(x) <= this->columns() &&
                         columns <= this->columns() - static_cast<unsigned int>(x) &&
                         static_cast<unsigned int>(y) <= this->rows() &&
                         rows <= this->rows() - static_cast<unsigned int>(y);
  if (!is_inside || map.find_first_not_of("RGBAOI") != std::string::npos) {
    throw ErrorOption("Magick: Unrecognized pixel map or a region beyond the image (" + map + ")");
  }
  for (unsigned int row = 0; row < rows; ++row) {
    for (unsigned int column = 0; column < columns; ++column) {
      const Pixel& pixel =
          pixels_[index(static_cast<unsigned int>(x) + column, static_cast<unsigned int>(y) + row)];
      const Quantum opacity = has_matte_ ? pixel.opacity : Quantum{OpaqueOpacity};
      for (const char letter : map) {
        const Quantum value = letter == 'R'   ? pixel.red
                              : letter == 'G' ? pixel.green
                              : letter == 'B' ? pixel.blue
                              : letter == 'I' ? pixel.gray()
                              : letter == 'O' ? opacity
                                              : static_cast<Quantum>(MaxRGB - opacity);
        put(value, storage, pixels);
      }
    }
  }
}

std::size_t Image::index(unsigned int x, unsigned int y) const {
  if (x >= columns() || y >= rows()) {
    throw ErrorOption("Magick: the pixel " + std::to_string(x) + "," + std::to_string(y) +
                      " is outside of the image");
  }
  return std::size_t{y} * columns() + x;
}

Color Image::pixelColor(unsigned int x, unsigned int y) const {
  const Pixel& pixel = pixels_[index(x, y)];
  return {pixel.red, pixel.green, pixel.blue, pixel.opacity};
}

void Image::pixelColor(unsigned int x, unsigned int y, const Color& color) {
  pixels_[index(x, y)] = {color.redQuantum(), color.greenQuantum(), color.blueQuantum(),
                          color.alphaQuantum()};
}

void Image::matte(bool has_matte) {
  if (has_matte && !has_matte_) {
    for (Pixel& pixel : pixels_) pixel.opacity = OpaqueOpacity;
  }
  has_matte_ = has_matte;
}

bool Image::is_gray() const {
  return std::all_of(pixels_.begin(), pixels_.end(),
                     [](const Pixel& pixel) { return pixel.is_gray(); });
}

ImageType Image::type() const {
  if (is_gray()) {
    const bool is_bilevel = std::all_of(pixels_.begin(), pixels_.end(), [](const Pixel& pixel) {
      return pixel.red == 0 || pixel.red == MaxRGB;
    });
    return has_matte_ ? GrayscaleMatteType : is_bilevel ? BilevelType : GrayscaleType;
  }
  return has_matte_ ? TrueColorMatteType : TrueColorType;
}

void Image::type(ImageType type) {
  const bool is_gray = type == BilevelType || type == GrayscaleType || type == GrayscaleMatteType;
  for (Pixel& pixel : pixels_) {
    if (!is_gray) break;
    Quantum gray = pixel.gray();
    if (type == BilevelType) gray = gray > MaxRGB / 2 ? MaxRGB : 0;
    pixel.red = pixel.green = pixel.blue = gray;
  }
  if (type != UndefinedType)
    matte(type == GrayscaleMatteType || type == PaletteMatteType || type == TrueColorMatteType);
}

void Image::flip() {
  for (unsigned int row = 0; row < rows() / 2; ++row) {
    const auto at = pixels_.begin() + static_cast<std::ptrdiff_t>(index(0, row));
    std::swap_ranges(at, at + columns(),
                     pixels_.begin() + static_cast<std::ptrdiff_t>(index(0, rows() - 1 - row)));
  }
}

void Image::flop() {
  for (unsigned int row = 0; row < rows(); ++row) {
    const auto at = pixels_.begin() + static_cast<std::ptrdiff_t>(index(0, row));
    std::reverse(at, at + columns());
  }
}

void Image::negate(bool only_gray) {
  for (Pixel& pixel : pixels_) {
    if (only_gray && !pixel.is_gray()) continue;
    for (Quantum* part : {&pixel.red, &pixel.green, &pixel.blue})
      *part = static_cast<Quantum>(MaxRGB - *part);
  }
}

}  // namespace Magick
