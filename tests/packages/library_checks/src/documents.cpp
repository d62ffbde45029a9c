// Documents that nodes read and write.

// Compatibility, works: JSON for Modern C++ (`nlohmann-json-dev`, `find_package(nlohmann_json)`),
// its exceptions too; fmt (`find_package(fmt)`)

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "checks.hpp"

using json = nlohmann::json;

namespace {

struct Waypoint {
  std::string name;
  double x = 0;
  double y = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Waypoint, name, x, y)

void check_json(Checks& checks) {
  const json mission = json::parse(R"({
    "name": "patrol", "speed": 0.5, "loop": true, "big": 9007199254740993,
    "waypoints": [{"name": "dock", "x": 1, "y": -2.5}, {"name": "gate", "x": 4e1, "y": 0}]
  })");
  const auto waypoints = mission.at("waypoints").get<std::vector<Waypoint>>();
  CHECK(waypoints.size() == 2 && waypoints[1].name == "gate" && waypoints[1].x == 40);
  CHECK(mission["big"].get<std::int64_t>() == 9007199254740993);
  CHECK(mission.value("retries", 3) == 3 && mission.contains("loop"));
  CHECK(json(waypoints[0]).dump() == R"({"name":"dock","x":1.0,"y":-2.5})");
  CHECK(json::from_cbor(json::to_cbor(mission)) == mission);
  CHECK(mission.flatten().at("/waypoints/0/name") == "dock");
  CHECK_THROWS(json::parse_error, json::parse("{\"open\": "));
  CHECK_THROWS(json::type_error, static_cast<void>(mission["name"].get<int>()));
  CHECK_THROWS(json::out_of_range, static_cast<void>(mission.at("goal")));
}

void check_fmt(Checks& checks) {
  CHECK(fmt::format("{:>6.2f}|{:#x}|{}", 3.14159, 255, "x") == "  3.14|0xff|x");
  CHECK(fmt::format("{1} of {0}: {2}", 3, "two", std::vector<int>{1, 2}) == "two of 3: [1, 2]");
  CHECK_THROWS(fmt::format_error, static_cast<void>(fmt::format(fmt::runtime("{:d}"), "text")));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("documents");
  check_json(checks);
  check_fmt(checks);
  return checks.finish();
}
