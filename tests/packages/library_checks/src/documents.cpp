// Documents that nodes read and write.

// Compatibility, works: JSON for Modern C++ (`nlohmann-json-dev`, `find_package(nlohmann_json)`),
// its exceptions too

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

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("documents");
  check_json(checks);
  return checks.finish();
}
