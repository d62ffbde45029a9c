// A document of xacro among files that it can include, and what it comes to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bundler/launch/xacro/xacro.hpp"

namespace ros2wasm::xacro_documents {

/// Below /f/, beside the document.
inline const std::map<std::string, std::string>& files() {
  static const std::map<std::string, std::string> all{
      {"/f/wheel.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><!-- parts -->
          <xacro:property name="radius" value="0.25"/>
          <xacro:macro name="wheel" params="side"><link name="${side}" r="${radius}"/></xacro:macro>
          <tyre/></robot>)x"},
      {"/f/twin.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro">
          <xacro:property name="radius" value="9"/>
          <xacro:macro name="wheel" params="side"><twin name="${side}" r="${radius}" out="${outer}"/>
          </xacro:macro></robot>)x"},
      {"/f/parts/arm.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="hand.xacro"/>
          <xacro:include filename="../wheel.xacro"/></robot>)x"},
      {"/f/parts/hand.xacro", "<robot><hand/></robot>"},
      {"/f/caller.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:load/></robot>)x"},
      {"/f/parts/caller.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:load/></robot>)x"},
      {"/f/hand.xacro", "<robot><other_hand/></robot>"},
      {"/f/outer.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="inner.xacro" ns="low"/>
          <seen where="outer" p="${p}"/></robot>)x"},
      {"/f/inner.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:property name="p" value="mine"/>
          <xacro:property name="p" value="given" scope="parent"/>
          <xacro:macro name="mark"><xacro:property name="p" value="marked" scope="parent"/></xacro:macro>
          </robot>)x"},
      {"/f/prefixed.xacro", R"x(<robot xmlns:gz="http://gz"><gz:light/></robot>)x"},
      {"/f/broken.xacro", "<robot>\n  <link>\n</robot>\n"},
      {"/f/loop.xacro",
       R"x(<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="loop.xacro"/></robot>)x"},
      {"/f/late.xacro",
       "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<xacro:macro name=\"bad\">\n  "
       "<a b=\"${nothing}\"/>\n</xacro:macro>\n</robot>\n"},
      {"/f/arms.yaml",
       R"x(left: {length: 0.5, joints: [shoulder, elbow], ok: yes, 3: three}
right: {length: 1.5e-3, joints: [], file: "007", none: ~, small: 1e-3, "quoted": "yes"}
base: &base {mass: 2, name: b}
heavy: {<<: *base, mass: 0x10}
)x"},
      {"/f/turns.yaml", "half: !degrees 180\nquarter: !radians pi/2\nstep: !millimeters 2+3\n"},
      {"/f/list.yaml", "- {name: a, at: {x: 1}}\n- {name: b, at: {x: 2}}\n"},
      {"/f/bad_unit.yaml", "a: !radians __import__('os')\n"},
      {"/opt/share/arm_pkg/urdf/arm.xacro", "<robot><from_package/></robot>"},
  };
  return all;
}

inline LaunchWorld world_with(const std::string& document) {
  LaunchWorld world;
  world.read = [document](const std::string& path) -> Outcome<std::string> {
    if (path == "/f/robot.xacro") return document;
    // As a file system takes it.
    std::string plain = path;
    for (const char* part : {"/./", "/parts/../"})
      while (plain.find(part) != std::string::npos)
        plain.replace(plain.find(part), std::string(part).size(), "/");
    const auto found = files().find(plain);
    if (found != files().end()) return found->second;
    return Diagnostic{.code = "R2W0413", .message = "", .why = {"there is no such file"}};
  };
  world.names_in = [](const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& [path, text] : files()) {
      if (!path.starts_with(folder + "/")) continue;
      const std::string below = path.substr(folder.size() + 1);
      names.push_back(below.substr(0, below.find('/')));
      if (names.size() > 1 && names.back() == names[names.size() - 2]) names.pop_back();
    }
    return names;
  };
  world.prefix_of = [](const std::string& package) -> std::optional<std::string> {
    return package == "arm_pkg" ? std::optional<std::string>("/opt") : std::nullopt;
  };
  world.shown = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
  return world;
}

inline Outcome<std::string> expand(const std::string& document,
                                   const std::map<std::string, std::string>& arguments = {}) {
  const XacroRequest request{.path = "/f/robot.xacro",
                             .arguments = arguments,
                             .environment = {{"ROBOT", "r2"}},
                             .directory = "/f"};
  return expand_xacro(request, world_with(document));
}

/// The document that has this in its element.
inline std::string robot(const std::string& content) {
  return "<r xmlns:xacro=\"http://ros.org/wiki/xacro\">" + content + "</r>";
}

}  // namespace ros2wasm::xacro_documents
