// Documents that nodes read and write.

// Compatibility, works: JSON for Modern C++ (`nlohmann-json-dev`, `find_package(nlohmann_json)`),
// its exceptions too; fmt (`find_package(fmt)`); yaml-cpp (`yaml-cpp`, `libyaml-cpp-dev`,
// `yaml_cpp_vendor`, `find_package(yaml-cpp)`), also its files and exceptions; tl::expected
// (tl_expected)

// Compatibility, differs: yaml-cpp -> version 0.7, the one of the machine that builds; Jazzy's own
// systems have 0.8

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "tl_expected/expected.hpp"

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

void check_yaml(Checks& checks) {
  const YAML::Node mission = YAML::Load(R"(
name: patrol
speed: 0.5
loop: yes
waypoints:
  - &dock {name: dock, pose: [1, -2.5]}
  - {name: gate, pose: [4e1, 0]}
home: *dock
)");
  CHECK(mission.IsMap() && mission["name"].as<std::string>() == "patrol" &&
        mission["loop"].as<bool>());
  CHECK(mission["speed"].as<double>() == 0.5 && mission["retries"].as<int>(3) == 3);
  std::vector<std::string> names;
  for (const YAML::Node& waypoint : mission["waypoints"]) {
    names.push_back(waypoint["name"].as<std::string>());
  }
  CHECK(names == (std::vector<std::string>{"dock", "gate"}));
  CHECK(mission["home"]["pose"].as<std::vector<double>>() == (std::vector<double>{1, -2.5}));
  CHECK(mission["home"].is(mission["waypoints"][0]) && !mission["goal"].IsDefined());
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "gains" << YAML::Value << YAML::Flow
      << std::vector<int>{1, 2} << YAML::Key << "note" << YAML::Value << "a: b" << YAML::EndMap;
  CHECK(std::string(out.c_str()) == "gains: [1, 2]\nnote: \"a: b\"");
  std::ofstream("/tmp/gains.yaml") << out.c_str();
  YAML::Node read = YAML::LoadFile("/tmp/gains.yaml");
  read["gains"].push_back(3);
  CHECK(read["gains"].size() == 3 && YAML::Dump(read["gains"]) == "[1, 2, 3]");
  CHECK_THROWS(YAML::BadFile, YAML::LoadFile("/tmp/absent.yaml"));
  CHECK_THROWS(YAML::TypedBadConversion<int>, static_cast<void>(mission["name"].as<int>()));
  try {
    YAML::Load("a: [1, 2\nb: 3");
    CHECK(false);
  } catch (const YAML::ParserException& error) {
    CHECK(error.mark.line == 1 && error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW);
  }
}

tl::expected<int, std::string> halved(int number) {
  if (number % 2 != 0) {
    return tl::make_unexpected("odd");
  }
  return number / 2;
}

void check_expected(Checks& checks) {
  CHECK(halved(8).and_then(halved).value() == 2);
  CHECK(halved(6).and_then(halved).error() == "odd");
  CHECK_THROWS(tl::bad_expected_access<std::string>, static_cast<void>(halved(1).value()));
}

/// Says when it is gone.
struct Farewell {
  std::string name;
  Farewell(std::string of) : name(std::move(of)) {}
  ~Farewell() { std::printf("%s is gone\n", name.c_str()); }
  Farewell(const Farewell&) = delete;
  Farewell& operator=(const Farewell&) = delete;
};

/// References to temporaries live as long as the program, as tables of yaml-cpp do.
const Farewell& first = Farewell("the first");
const Farewell& last() {
  static const Farewell& kept = Farewell("the last");
  return kept;
}

/// A thread's objects go before those of the program.
std::string of_the_thread() {
  static thread_local Farewell one("the thread's one");
  static thread_local Farewell two[2] = {std::string("the thread's two"),
                                         std::string("the thread's three")};
  static thread_local const Farewell& kept = Farewell("the thread's kept");
  return one.name + two[0].name + two[1].name + kept.name;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("documents");
  check_json(checks);
  check_fmt(checks);
  check_yaml(checks);
  check_expected(checks);
  CHECK(first.name + " and " + last().name == "the first and the last");
  CHECK(of_the_thread().size() == 67);
  return checks.finish();
}
