// Libraries that are compiled for the site.

// Compatibility, works: GeographicLib 2.1 (`geographiclib`, `find_package(GeographicLib)`) but for
// the tables of geoids and gravity, which a node would bring itself; tinyxml2 (`tinyxml2`,
// `tinyxml2_vendor`, `find_package(TinyXML2)`)

// Compatibility, differs: GraphicsMagick's Magick++ (`graphicsmagick`) -> images, pixels, colours
// and files of the formats PNG, BMP, JPEG, PBM, PGM and PPM by a library of ros2wasm with its
// names, as nav2_map_server uses them; no drawing, no effects

#include <Magick++.h>
#include <tinyxml2.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "expect.hpp"

namespace {

void check_geography(Expectations& expectations) {
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(40.6, -73.8, 51.6, -0.5, metres);
  EXPECT(near(metres, 5551759.4, 0.1));
  int zone = 0;
  bool is_north = false;
  double x = 0;
  double y = 0;
  GeographicLib::UTMUPS::Forward(33.3, 44.4, zone, is_north, x, y);
  EXPECT(zone == 38 && is_north && near(x, 444140.54, 0.01) && near(y, 3684706.36, 0.01));
  std::string grid;
  GeographicLib::MGRS::Forward(zone, is_north, x, y, 5, grid);
  EXPECT(grid == "38SMB4414084706");
  const GeographicLib::LocalCartesian local(48.0, 11.0, 500.0);
  double z = 0;
  local.Forward(48.0, 11.001, 500.0, x, y, z);
  EXPECT(near(x, 74.62, 0.02) && near(y, 0.0, 0.01) && near(z, 0.0, 0.01));
  EXPECT_THROWS(GeographicLib::GeographicErr,
                GeographicLib::UTMUPS::Forward(91.0, 0.0, zone, is_north, x, y));
}

void check_documents(Expectations& expectations) {
  tinyxml2::XMLDocument document;
  EXPECT(document.Parse(R"(<robot name="arm"><joint limit="1.5"/><joint/></robot>)") ==
         tinyxml2::XML_SUCCESS);
  const tinyxml2::XMLElement* joint = document.RootElement()->FirstChildElement("joint");
  EXPECT(joint != nullptr && joint->DoubleAttribute("limit") == 1.5);
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  EXPECT(std::strcmp(printer.CStr(), R"(<robot name="arm"><joint limit="1.5"/><joint/></robot>)") ==
         0);
  EXPECT(document.Parse("<robot>") != tinyxml2::XML_SUCCESS && document.ErrorLineNum() == 1);
}

void check_pictures(Expectations& expectations) {
  Magick::InitializeMagick(nullptr);
  Magick::Image map({2, 2}, "white");
  map.type(Magick::TrueColorMatteType);
  map.depth(8);
  map.pixelColor(0, 0, Magick::ColorGray(205 / 255.0));
  Magick::Color unknown = Magick::ColorGray(0.5);
  unknown.alphaQuantum(TransparentOpacity);
  map.pixelColor(1, 1, unknown);
  Magick::Blob file;
  map.write(&file, "PNG");
  const Magick::Image read(file);
  EXPECT(read.matte() && read.size().width() == 2 && read.magick() == "PNG");
  std::array<std::uint8_t, 4> values = {};
  read.write(0, 0, 2, 2, "I", Magick::CharPixel, values.data());
  EXPECT((values == std::array<std::uint8_t, 4>{205, 255, 255, 127}));
  read.write(0, 0, 2, 2, "A", Magick::CharPixel, values.data());
  EXPECT((values == std::array<std::uint8_t, 4>{255, 255, 255, 0}));

  const std::string text = "P2\n# by hand\n2 1\n100\n0 50\n";
  const Magick::Image gray(Magick::Blob(text.data(), text.size()));
  EXPECT(gray.type() == Magick::GrayscaleType && gray.pixelColor(1, 0).redQuantum() == MaxRGB / 2);
  EXPECT_THROWS(Magick::ErrorOption, Magick::CoderInfo("tga"));
  EXPECT_THROWS(Magick::ErrorFileOpen, Magick::Image("/tmp/absent.png"));
  EXPECT_THROWS(Magick::ErrorCorruptImage, Magick::Image(Magick::Blob("P5 2 2 255\nab", 13)));
  EXPECT_THROWS(Magick::ErrorResourceLimit,
                Magick::Image(Magick::Blob("P5 99999 99999 255\nab", 21)));
}

}  // namespace

int main() {
  Expectations expectations;
  check_geography(expectations);
  check_documents(expectations);
  check_pictures(expectations);
  return expectations.finish();
}
