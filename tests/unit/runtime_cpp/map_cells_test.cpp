// Pixels and cells of maps in the three modes, and the YAML file beside an image.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>

#include "map_cells.hpp"
#include "map_yaml.hpp"

namespace nav2_map_server {
namespace {

using Cells = std::vector<std::int8_t>;
using Bytes = std::vector<std::uint8_t>;

MapImage row_of(Bytes gray, Bytes alpha = {}) {
  MapImage image;
  image.width = gray.size();
  image.height = 1;
  image.gray = std::move(gray);
  image.alpha = std::move(alpha);
  return image;
}

LoadParameters rules(MapMode mode, double free = 0.196, double occupied = 0.65) {
  LoadParameters parameters;
  parameters.mode = mode;
  parameters.free_thresh = free;
  parameters.occupied_thresh = occupied;
  return parameters;
}

TEST(MapCells, TrinaryHasThreeValues) {
  EXPECT_EQ(cells_of(row_of({0, 128, 205, 254}), rules(MapMode::Trinary)), (Cells{100, -1, -1, 0}));
  // 1 - 205 / 255 = 0.19608
  EXPECT_EQ(cells_of(row_of({205}), rules(MapMode::Trinary, 0.25)), (Cells{0}));
  // 1 - 89 / 255 = 0.65098, 1 - 90 / 255 = 0.64706
  EXPECT_EQ(cells_of(row_of({89, 90}), rules(MapMode::Trinary)), (Cells{100, -1}));
}

TEST(MapCells, TheLowestRowComesFirst) {
  MapImage image = row_of({0, 255, 255, 128, 0, 0});
  image.width = 2;
  image.height = 3;
  EXPECT_EQ(cells_of(image, rules(MapMode::Trinary)), (Cells{100, 100, 0, -1, 100, 0}));
}

TEST(MapCells, NegateMakesWhiteOccupied) {
  LoadParameters negated = rules(MapMode::Trinary);
  negated.negate = true;
  EXPECT_EQ(cells_of(row_of({0, 128, 255}), negated), (Cells{0, -1, 100}));
}

TEST(MapCells, ScaleIsLinearBetweenTheThresholds) {
  // (127 / 255 - 0.196) / 0.454 = 0.6653; (50 / 255 - 0.196) / 0.454 = 0.0002
  EXPECT_EQ(cells_of(row_of({0, 128, 205, 254}), rules(MapMode::Scale)), (Cells{100, 67, 0, 0}));
  // (0.2 - 0) / 1, (0.8 - 0) / 1
  EXPECT_EQ(cells_of(row_of({204, 51}), rules(MapMode::Scale, 0, 1)), (Cells{20, 80}));
}

TEST(MapCells, TransparentPixelsAreUnknownButInRaw) {
  const MapImage image = row_of({0, 255, 100}, {254, 255, 0});
  EXPECT_EQ(cells_of(image, rules(MapMode::Trinary)), (Cells{-1, 0, -1}));
  EXPECT_EQ(cells_of(image, rules(MapMode::Scale)), (Cells{-1, 0, -1}));
  EXPECT_EQ(cells_of(image, rules(MapMode::Raw)), (Cells{0, -1, 100}));
}

TEST(MapCells, RawHasThePixels) {
  LoadParameters raw = rules(MapMode::Raw);
  raw.negate = true;  // has no effect
  EXPECT_EQ(cells_of(row_of({0, 1, 100, 101, 127, 128, 255}), raw),
            (Cells{0, 1, 100, -1, -1, -1, -1}));
}

TEST(MapCells, StrangeThresholdsGiveCellsThatExist) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cells_of(row_of({0, 128}), rules(MapMode::Scale, nan, nan)), (Cells{-1, -1}));
  EXPECT_EQ(cells_of(row_of({0, 255}), rules(MapMode::Scale, 0.9, 0.1)), (Cells{100, 0}));
  EXPECT_EQ(cells_of(row_of({0}), rules(MapMode::Scale, 0.0, inf)), (Cells{0}));
  EXPECT_EQ(cells_of(row_of({128}), rules(MapMode::Scale, -inf, inf)), (Cells{-1}));
}

SaveParameters saving(MapMode mode) {
  SaveParameters parameters;
  parameters.mode = mode;
  parameters.free_thresh = 0.25;
  parameters.occupied_thresh = 0.65;
  return parameters;
}

TEST(MapCells, SavesTrinaryInThreeShades) {
  const MapImage image =
      image_of({-1, 0, 25, 26, 64, 65, 100, 101}, 8, 1, saving(MapMode::Trinary));
  EXPECT_EQ(image.gray, (Bytes{205, 254, 254, 205, 205, 0, 0, 205}));
  EXPECT_TRUE(image.alpha.empty());
}

TEST(MapCells, SavesScaleWithHoles) {
  // 0.67 * 65535 = 43908.45, / 257 = 170.85; 0.5 * 65535 = 32767.5, / 257 = 127.4
  const MapImage image = image_of({-1, 0, 33, 50, 100, 127}, 6, 1, saving(MapMode::Scale));
  EXPECT_EQ(image.gray, (Bytes{127, 255, 170, 127, 0, 127}));
  EXPECT_EQ(image.alpha, (Bytes{0, 255, 255, 255, 255, 0}));
}

TEST(MapCells, SavesRawAsItIsAndRowsFromTheTop) {
  const MapImage image = image_of({-1, 0, 50, 100}, 2, 2, saving(MapMode::Raw));
  EXPECT_EQ(image.gray, (Bytes{50, 100, 255, 0}));
}

TEST(MapMode, HasNamesInAnyCase) {
  EXPECT_EQ(map_mode_from_string("Scale"), MapMode::Scale);
  EXPECT_STREQ(map_mode_to_string(MapMode::Raw), "raw");
  EXPECT_THROW(map_mode_from_string(""), std::invalid_argument);
}

constexpr const char* kMap =
    "image: room.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.5]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST(MapYaml, HasWhatTheFileSays) {
  const LoadParameters map = read_map_yaml(kMap, "/maps");
  EXPECT_EQ(map.image_file_name, "/maps/room.pgm");
  EXPECT_DOUBLE_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.origin, (std::vector<double>{-1.5, 2, 0.5}));
  EXPECT_DOUBLE_EQ(map.free_thresh, 0.196);
  EXPECT_DOUBLE_EQ(map.occupied_thresh, 0.65);
  EXPECT_EQ(map.mode, MapMode::Trinary);
  EXPECT_FALSE(map.negate);
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kMap;
  return text.replace(text.find(from), from.size(), to);
}

TEST(MapYaml, TakesOtherForms) {
  EXPECT_EQ(read_map_yaml(changed("room.pgm", "/a/b.png"), "/maps").image_file_name, "/a/b.png");
  EXPECT_TRUE(read_map_yaml(changed("negate: 0", "negate: 1"), ".").negate);
  EXPECT_TRUE(read_map_yaml(changed("negate: 0", "negate: true"), ".").negate);
  EXPECT_EQ(read_map_yaml(std::string(kMap) + "mode: raw\n", ".").mode, MapMode::Raw);
}

std::string error_of(const std::string& text) {
  try {
    read_map_yaml(text, ".");
  } catch (const YAML::Exception& error) {
    return error.msg;
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MapYaml, SaysWhichTagIsWrong) {
  EXPECT_EQ(error_of(changed("image: room.pgm", "image: ''")), "The image tag was empty.");
  EXPECT_EQ(error_of(changed("0.05", "narrow")),
            "Failed to parse YAML tag 'resolution' for reason: bad conversion");
  EXPECT_EQ(error_of(changed("[-1.5, 2, 0.5]", "[1, 2]")),
            "value of the 'origin' tag should have 3 elements, not 2");
  EXPECT_EQ(error_of(changed("negate: 0", "negate: perhaps")),
            "Failed to parse YAML tag 'negate' for reason: bad conversion");
  EXPECT_EQ(error_of(std::string(kMap) + "mode: grey\n"), "map_mode_name");
  EXPECT_NE(error_of(changed("free_thresh: 0.196", "")).find("'free_thresh'"), std::string::npos);
  EXPECT_NE(error_of("just a text"), "");
  EXPECT_NE(error_of(""), "");
}

TEST(MapYaml, RefusesHostileText) {
  EXPECT_NE(error_of(std::string(100000, '[')), "");
  EXPECT_EQ(error_of(std::string(kMostYamlBytes + 1, ' ')), "the file has more than 1 MiB");
  EXPECT_NE(error_of("image: \"\n"), "");
}

TEST(MapYaml, WritesThresholdsThatFitTheMode) {
  EXPECT_EQ(map_yaml("room.pgm", {0.05, -10.25, 3, 0}, saving(MapMode::Trinary)),
            "image: room.pgm\nmode: trinary\nresolution: 0.050\norigin: [-10.250, 3.000, 0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196");
  EXPECT_EQ(map_yaml("room.png", {0.1F, 0, 0, 1.57079632679}, saving(MapMode::Scale)),
            "image: room.png\nmode: scale\nresolution: 0.100\norigin: [0.000, 0.000, 1.570796]\n"
            "negate: 0\noccupied_thresh: 0.650\nfree_thresh: 0.250");
}

}  // namespace
}  // namespace nav2_map_server
