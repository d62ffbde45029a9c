// Launch files in XML and YAML that say the same come to the same, and to what launch makes of
// them.
#include "bundler/launch/launch_evaluation.hpp"

#include <gtest/gtest.h>

#include "bundler/launch/launch_file_nodes.hpp"
#include "bundler/launch/launch_tree.hpp"

namespace ros2wasm {
namespace {

struct Case {
  const char* what;
  const char* xml;   ///< inside of <launch>
  const char* yaml;  ///< below `launch:`
  const char* tree;  ///< as launch_tree() has it, without places
};

constexpr Case kCases[] = {
    {"a node", R"x(<node pkg="a" exec="b"/>)x", "- node: {pkg: a, exec: b}", "a/b\n"},
    {"a name and a namespace", R"x(<node pkg="a" exec="b" name="n" namespace="x/y"/>)x",
     "- node: {pkg: a, exec: b, name: n, namespace: x/y}", "a/b  /x/y/n\n"},
    {"an absolute namespace wins over pushed ones",
     R"x(<push_ros_namespace namespace="p"/><node pkg="a" exec="b" name="n" namespace="/x"/>
        <node pkg="a" exec="b" name="m" namespace="x"/>)x",
     "- push-ros-namespace: {namespace: p}\n- node: {pkg: a, exec: b, name: n, namespace: /x}\n"
     "- node: {pkg: a, exec: b, name: m, namespace: x}",
     "a/b  /x/n\na/b  /p/x/m\n"},
    {"pushed namespaces add up and end with their group",
     R"x(<group><push-ros-namespace namespace="p"/><group><push_ros_namespace namespace="q"/>
        <node pkg="a" exec="b" name="n"/></group><node pkg="a" exec="b" name="n"/></group>
        <node pkg="a" exec="b" name="n"/>)x",
     "- group:\n  - push_ros_namespace: {namespace: p}\n  - group:\n    - push_ros_namespace: "
     "{namespace: q}\n    - node: {pkg: a, exec: b, name: n}\n  - node: {pkg: a, exec: b, name: "
     "n}\n"
     "- node: {pkg: a, exec: b, name: n}",
     "a/b  /p/q/n\na/b  /p/n\na/b  /n\n"},
    {"types of parameters",
     R"x(<node pkg="a" exec="b" name="n"><param name="i" value="1"/><param name="d" value="1.0"/>
        <param name="s" value="one"/><param name="t" value="true"/><param name="q" value="'1'"/>
        <param name="w" value="1" type="str"/><param name="f" value="2" type="float"/>
        <param name="e" value=""/></node>)x",
     "- node:\n    pkg: a\n    exec: b\n    name: n\n    param: [{name: i, value: 1}, {name: d, "
     "value: 1.0}, {name: s, value: one}, {name: t, value: true}, {name: q, value: \"1\"}, "
     "{name: w, value: '1', type: str}, {name: f, value: 2, type: float}, {name: e, value: ''}]",
     "a/b  /n\n  param i: 1\n  param d: 1.0\n  param s: 'one'\n  param t: true\n  param q: '1'\n"
     "  param w: '1'\n  param f: 2.0\n  param e: ''\n"},
    {"lists of parameters",
     R"x(<node pkg="a" exec="b" name="n"><param name="i" value="[1, 2]"/>
        <param name="d" value="1,2.5" value-sep=","/>
        <param name="s" value="1;2" value-sep=";" type="list_of_str"/></node>)x",
     "- node:\n    pkg: a\n    exec: b\n    name: n\n    param: [{name: i, value: [1, 2]}, "
     "{name: d, value: [1, 2.5]}, {name: s, value: ['1', '2'], type: str}]",
     "a/b  /n\n  param i: [1, 2]\n  param d: [1.0, 2.5]\n  param s: ['1', '2']\n"},
    {"nested parameters",
     R"x(<node pkg="a" exec="b" name="n"><param name="p"><param name="x" value="1"/><param name="q">
        <param name="y" value="2"/></param></param></node>)x",
     "- node:\n    pkg: a\n    exec: b\n    name: n\n    param: [{name: p, param: [{name: x, "
     "value: "
     "1}, {name: q, param: [{name: y, value: 2}]}]}]",
     "a/b  /n\n  param p.x: 1\n  param p.q.y: 2\n"},
    {"parameters of all nodes come before their own",
     R"x(<set_parameter name="p" value="1"/><node pkg="a" exec="b" name="n"><param name="p" value="2"/>
        </node><set_use_sim_time value="true"/><node pkg="a" exec="b" name="m"/>)x",
     "- set_parameter: {name: p, value: 1}\n- node: {pkg: a, exec: b, name: n, param: [{name: p, "
     "value: 2}]}\n- set_use_sim_time: {value: true}\n- node: {pkg: a, exec: b, name: m}",
     "a/b  /n\n  param p: 1\n  param p: 2\na/b  /m\n  param p: 1\n  param use_sim_time: true\n"},
    {"remappings of all nodes come before their own",
     R"x(<set_remap from="x" to="y"/><node pkg="a" exec="b" name="n"><remap from="x" to="z"/></node>)x",
     "- set_remap: {from: x, to: y}\n- node: {pkg: a, exec: b, name: n, remap: [{from: x, to: z}]}",
     "a/b  /n\n  remap x -> y\n  remap x -> z\n"},
    {"words of a command line",
     R"x(<let name="two" value="x y"/><node pkg="a" exec="b" name="n" args="--a 'b c' $(var two)z d"/>)x",
     "- let: {name: two, value: x y}\n- node: {pkg: a, exec: b, name: n, args: \"--a 'b c' $(var "
     "two)z d\"}",
     "a/b  /n\n  arg --a\n  arg b c\n  arg x yz\n  arg d\n"},
    {"conditions",
     R"x(<arg name="f" default="False"/><node pkg="a" exec="if" if="$(var f)"/>
        <node pkg="a" exec="unless" unless="$(var f)"/><node pkg="a" exec="one" if="1"/>)x",
     "- arg: {name: f, default: 'False'}\n- node: {pkg: a, exec: if, if: $(var f)}\n- node: {pkg: "
     "a, "
     "exec: unless, unless: $(var f)}\n- node: {pkg: a, exec: one, if: true}",
     "arguments\n  f:=False\na/unless\na/one\n"},
    {"a group that is skipped", R"x(<group if="false"><node pkg="a" exec="b"/></group>)x",
     "- group:\n    if: false\n    children:\n    - node: {pkg: a, exec: b}", ""},
    {"variables end with their group, unless it is not scoped",
     R"x(<let name="v" value="1"/><group><let name="v" value="2"/></group><log message="$(var v)"/>
        <group scoped="false"><let name="v" value="3"/></group><log message="$(var v)"/>)x",
     "- let: {name: v, value: '1'}\n- group:\n  - let: {name: v, value: '2'}\n- log: {message: "
     "$(var "
     "v)}\n- group:\n    scoped: false\n    children:\n    - let: {name: v, value: '3'}\n- log: "
     "{message: $(var v)}",
     "log info: 1\nlog info: 3\n"},
    {"a group that forwards only what is kept",
     R"x(<let name="v" value="1"/><let name="w" value="2"/><group forwarding="false">
        <keep name="w" value="$(var w)"/><log message="$(var v none) $(var w)"/></group>)x",
     "- let: {name: v, value: '1'}\n- let: {name: w, value: '2'}\n- group:\n    forwarding: false\n"
     "    keep: [{name: w, value: $(var w)}]\n    children:\n    - log: {message: '$(var v none) "
     "$(var w)'}",
     "log info: none 2\n"},
    {"an argument with a default of another",
     R"x(<arg name="a" default="1"/><arg name="b" default="$(var a)2" description="two"/>)x",
     "- arg: {name: a, default: '1'}\n- arg: {name: b, default: '$(var a)2', description: two}",
     "arguments\n  a:=1\n  b:=12  # two\n"},
    {"choices", R"x(<arg name="a" default="x"><choice value="x"/><choice value="y"/></arg>)x",
     "- arg: {name: a, default: x, choice: [{value: x}, {value: y}]}",
     "arguments\n  a:=x  one of x y\n"},
    {"an include with arguments, which stay set",
     R"x(<include file="/f/inner.launch.yaml"><arg name="x" value="7"/></include>
        <log message="$(var x)"/>)x",
     "- include: {file: /f/inner.launch.yaml, arg: [{name: x, value: '7'}]}\n- log: {message: "
     "$(var "
     "x)}",
     "log info: inner 7 of /f/inner.launch.yaml\nlog info: 7\n"},
    {"an include beside the file",
     R"x(<include file="inner.launch.xml"><let name="x" value="7"/></include>)x",
     "- include: {file: inner.launch.xml, let: [{name: x, value: '7'}]}",
     "log info: inner 7 in /f\n"},
    {"the environment",
     R"x(<set_env name="E" value="1"/><append_env name="E" value="2"/>
        <append_env name="E" value="0" prepend="true" separator=";"/>
        <node pkg="a" exec="b" name="n"><env name="F" value="$(env E)"/></node><unset_env name="E"/>
        <node pkg="a" exec="b" name="m"/>)x",
     "- set_env: {name: E, value: '1'}\n- append_env: {name: E, value: '2'}\n- append_env: {name: "
     "E, "
     "value: '0', prepend: true, separator: ;}\n- node: {pkg: a, exec: b, name: n, env: [{name: F, "
     "value: $(env E)}]}\n- unset_env: {name: E}\n- node: {pkg: a, exec: b, name: m}",
     "a/b  /n\n  env E=0;1:2\n  env F=0;1:2\na/b  /m\n"},
    {"environment of the site, and defaults",
     R"x(<log message="$(env ROS_DISTRO) $(env NONE x)"/>)x",
     "- log: {message: '$(env ROS_DISTRO) $(env NONE x)'}", "log info: jazzy x\n"},
    {"timers add up",
     R"x(<timer period="1.5"><timer period="2"><node pkg="a" exec="b"/></timer><log message="m"/>
        </timer>)x",
     "- timer:\n    period: 1.5\n    children:\n    - timer: {period: 2, children: [{node: {pkg: "
     "a, "
     "exec: b}}]}\n    - log: {message: m}",
     "a/b\n  after 3.5 s\nlog info: m  after 1.5 s\n"},
    {"the life of a process",
     R"x(<node pkg="a" exec="b" respawn="true" respawn_delay="4" output="log" on_exit="shutdown"/>)x",
     "- node: {pkg: a, exec: b, respawn: true, respawn_delay: 4, output: log, on_exit: shutdown}",
     "a/b\n  respawn after 4.0 s\n  when it ends, all ends\n"},
    {"a shutdown", R"x(<timer period="9"><shutdown reason="done"/></timer>)x",
     "- timer: {period: 9, children: [{shutdown: {reason: done}}]}",
     "all ends: done  after 9.0 s\n"},
    {"a command is skipped", R"x(<executable cmd="gz topic -l"/>)x",
     "- executable: {cmd: gz topic -l}",
     "skipped: gz topic -l (a site runs nodes of packages and commands of ros2 only)\n"},
    {"Gazebo is the simulator of the site, its window the page",
     R"x(<executable cmd="gz sim -r 'my world.sdf'"/><executable cmd="gazebo"/>
        <executable cmd="ruby $(find-exec gz) sim -s" shell="true"><env name="M" value="v"/>
        </executable><executable cmd="gzclient"/><executable cmd="gz sim -g"/>)x",
     "- executable: {cmd: \"gz sim -r 'my world.sdf'\"}\n- executable: {cmd: gazebo}\n"
     "- executable: {cmd: ruby $(find-exec gz) sim -s, shell: true, env: [{name: M, value: v}]}\n"
     "- executable: {cmd: gzclient}\n- executable: {cmd: gz sim -g}",
     "ros2wasm_sim/gz_sim\n  arg -r\n  arg my world.sdf\nros2wasm_sim/gzserver\n"
     "ros2wasm_sim/gz_sim\n  env M=v\n  arg -s\n"},
    {"commands of ros2", R"x(<let name="v" value="a b"/>
        <executable cmd="ros2 topic pub $(var v)/x T '{data: $(var v)}' -1" respawn="true"/>
        <executable cmd="ros2 param get $(var v)" shell="true" on_exit="shutdown"/>
        <executable cmd="ros2 launch p l.py"/>)x",
     "- let: {name: v, value: a b}\n- executable: {cmd: \"ros2 topic pub $(var v)/x T '{data: "
     "$(var v)}' -1\", respawn: true}\n- executable: {cmd: ros2 param get $(var v), shell: true, "
     "on_exit: shutdown}\n- executable: {cmd: ros2 launch p l.py}",
     "ros2 topic pub 'a b/x' T '{data: a b}' -1\n  respawn\nros2 param get a b\n  when it ends, "
     "all "
     "ends\nskipped: ros2 launch p l.py (include the launch file)\n"},
    {"components of a container, and some more of them",
     R"x(<node_container pkg="c" exec="component_container" name="box" namespace="">
        <composable_node pkg="a" plugin="a::B" name="one" namespace="in"><param name="p" value="1"/>
        <remap from="x" to="y"/><extra_arg name="use_intra_process_comms" value="true"/>
        </composable_node></node_container><load_composable_node target="box">
        <composable_node pkg="a" plugin="a::C" name="two"/></load_composable_node>)x",
     "- node_container:\n    pkg: c\n    exec: component_container\n    name: box\n    namespace: "
     "''\n    composable_node:\n    - pkg: a\n      plugin: a::B\n      name: one\n      "
     "namespace: "
     "in\n      param: [{name: p, value: 1}]\n      remap: [{from: x, to: y}]\n      extra_arg: "
     "[{name: use_intra_process_comms, value: 'true'}]\n- load_composable_node:\n    target: box\n"
     "    composable_node: [{pkg: a, plugin: 'a::C', name: two}]",
     "c/component_container  /box\n  component a a::B  /in/one\n    param p: 1\n    remap x -> y\n"
     "  component a a::C  /two\n"},
    {"texts and quotes", R"x(<log message="'a' &quot;b&quot; \$(c) $ \\ d"/>)x",
     "- log: {message: '''a'' \"b\" \\$(c) $ \\\\ d'}", "log info: 'a' \"b\" $(c) $ \\ d\n"},
    {"substitutions in substitutions",
     R"x(<let name="n" value="a b"/><let name="a b" value="c"/><log message="$(var $(var n)) $(var '$(var n)')"/>)x",
     "- let: {name: n, value: a b}\n- let: {name: a b, value: c}\n- log: {message: \"$(var $(var "
     "n)) "
     "$(var '$(var n)')\"}",
     "log info: c c\n"},
    {"booleans",
     R"x(<log message="$(not true) $(and 1 TRUE) $(or false 0) $(any 0 1) $(all true true false)"/>)x",
     "- log: {message: '$(not true) $(and 1 TRUE) $(or false 0) $(any 0 1) $(all true true "
     "false)'}",
     "log info: false true false true false\n"},
    {"comparisons",
     R"x(<log message="$(equals a a) $(equals 1 1.0) $(equals 1 true) $(not-equals a b) $(if 1 x y) $(if 0 x)."/>)x",
     "- log: {message: '$(equals a a) $(equals 1 1.0) $(equals 1 true) $(not-equals a b) $(if 1 x "
     "y) "
     "$(if 0 x).'}",
     "log info: true true true true x .\n"},
    {"expressions",
     R"x(<arg name="n" default="4"/><log message="$(eval '$(var n) * 2 > 7') $(eval '1 + 1')"/>)x",
     "- arg: {name: n, default: '4'}\n- log: {message: \"$(eval '$(var n) * 2 > 7') $(eval '1 + "
     "1')\"}",
     "arguments\n  n:=4\nlog info: True 2\n"},
    {"texts put together",
     R"x(<log message="$(string-join , a b) $(string-strip ' x ') $(anon n)"/>)x",
     "- log: {message: \"$(string-join , a b) $(string-strip ' x ') $(anon n)\"}",
     "log info: a,b x n_site\n"},
    {"paths of packages",
     R"x(<log message="$(find-pkg-share demo) $(find-pkg-prefix demo) $(exec-in-pkg x demo)"/>)x",
     "- log: {message: '$(find-pkg-share demo) $(find-pkg-prefix demo) $(exec-in-pkg x demo)'}",
     "log info: /p/share/demo /p /p/lib/demo/x\n"},
    {"values of set_parameter",
     R"x(<set_parameter name="g" value="text"/><log message="$(param g)"/>)x",
     "- set_parameter: {name: g, value: text}\n- log: {message: $(param g)}", "log info: text\n"},
    {"loops",
     R"x(<for len="2" name="i"><node pkg="a" exec="b" name="n$(index i)"/></for>
        <for_each values="{k: x}; {k: y}"><log message="$(for-var k) $(for-var z none)"/></for_each>)x",
     "- for: {len: 2, name: i, children: [{node: {pkg: a, exec: b, name: n$(index i)}}]}\n- "
     "for_each: "
     "{values: '{k: x}; {k: y}', children: [{log: {message: '$(for-var k) $(for-var z none)'}}]}",
     "a/b  /n0\na/b  /n1\nlog info: x none\nlog info: y none\n"},
    {"levels of the log", R"x(<log message="a" level="WARNING"/><log_error message="b"/>)x",
     "- log: {message: a, level: WARNING}\n- log_error: {message: b}",
     "log warning: a\nlog error: b\n"},
    {"forgotten variables", R"x(<let name="a" value="1"/><reset/><log message="$(var a gone)"/>)x",
     "- let: {name: a, value: '1'}\n- reset: {}\n- log: {message: '$(var a gone)'}",
     "log info: gone\n"},
    {"parameters from a file, as they are and with substitutions",
     R"x(<let name="v" value="5"/><node pkg="a" exec="b" name="n"><param from="/f/p.yaml"/>
        <param from="/f/p.yaml" allow_substs="true"/></node>)x",
     "- let: {name: v, value: '5'}\n- node: {pkg: a, exec: b, name: n, param: [{from: /f/p.yaml}, "
     "{from: /f/p.yaml, allow_substs: true}]}",
     "a/b  /n\n  params from /f/p.yaml\n  params from /f/p.yaml#2\n"},
};

LaunchWorld world_with(const std::string& name, const std::string& text) {
  std::map<std::string, std::string> files{
      {"/f/inner.launch.yaml",
       "launch:\n- arg: {name: x}\n- log: {message: inner $(var x) of $(filename)}\n"},
      {"/f/inner.launch.xml",
       "<launch><arg name='x' default='1'/><log message='inner $(var x) in $(dirname)'/></launch>"},
      {"/f/p.yaml", "/**:\n  ros__parameters: {v: $(var v)}\n"},
      {"/f/" + name, text}};
  return {.read = [files](const std::string& path) -> Outcome<std::string> {
            const auto found = files.find(path);
            if (found == files.end()) return Diagnostic{.code = "R2W0413", .message = path};
            return found->second;
          },
          .prefix_of = [](const std::string& package) -> std::optional<std::string> {
            const bool is_there = package == "demo" || package == "ros2wasm_sim";
            return is_there ? std::optional<std::string>("/p") : std::nullopt;
          },
          .environment = {{"ROS_DISTRO", "jazzy"}}};
}

std::string tree_of(const std::string& name, const std::string& text,
                    const std::map<std::string, std::string>& given = {}) {
  const auto result = evaluate_launch("/f/" + name, given, world_with(name, text));
  std::string lines;
  if (!result) {
    for (const Diagnostic& error : result.errors())
      lines += error.code + " " + error.message + "\n";
    return lines;
  }
  for (std::string line : launch_tree(*result)) {
    if (const std::size_t at = line.rfind("  [/"); at != std::string::npos) line.resize(at);
    lines += line + "\n";
  }
  return lines;
}

TEST(Launch, XmlAndYamlComeToTheSame) {
  for (const Case& one : kCases) {
    SCOPED_TRACE(one.what);
    EXPECT_EQ(tree_of("a.launch.xml", "<launch>" + std::string(one.xml) + "</launch>"), one.tree);
    EXPECT_EQ(tree_of("a.launch.yaml", "launch:\n" + std::string(one.yaml) + "\n"), one.tree);
  }
}

TEST(Launch, GivenArgumentsWin) {
  const std::string text =
      "<launch><arg name='a' default='$(var missing)'/><arg name='b'/><log message='$(var a)$(var "
      "b)'/></launch>";
  EXPECT_EQ(tree_of("a.launch.xml", text, {{"a", "1"}, {"b", "2"}}),
            "arguments\n  a:=1\n  b:=2\nlog info: 12\n");
  EXPECT_EQ(tree_of("a.launch.xml", text, {{"a", "1"}}),
            "R2W0412 the launch argument `b` must be given\n"
            "R2W0412 there is no launch configuration `b` here\n");
}

TEST(Launch, DotLaunchIsWhatItLooksLike) {
  EXPECT_EQ(tree_of("a.launch", "\n <launch><log message='x'/></launch>"), "log info: x\n");
  EXPECT_EQ(tree_of("a.launch", "launch:\n- log: {message: x}\n"), "log info: x\n");
}

TEST(Launch, HostileFilesEnd) {
  const std::string self = "<launch><include file='a.launch.xml'/></launch>";
  EXPECT_EQ(tree_of("a.launch.xml", self), "R2W0413 `/f/a.launch.xml` includes itself\n");
  std::string deep = "<launch>";
  for (int i = 0; i < 90; ++i) deep += "<group>";
  for (int i = 0; i < 90; ++i) deep += "</group>";
  EXPECT_NE(tree_of("a.launch.xml", deep + "</launch>").find("too deep"), std::string::npos);
  EXPECT_NE(tree_of(
                "a.launch.xml", "<launch><log message='" + std::string(100, 'x') +
                                    [] {
                                      std::string calls;
                                      for (int i = 0; i < 1000; ++i) calls += "$(not ";
                                      return calls;
                                    }() +
                                    "'/></launch>")
                .find("too deep"),
            std::string::npos);
  const std::string loops =
      "<launch><for len='10000' name='i'><for len='10000' name='j'><node pkg='a' exec='b'/></for>"
      "</for></launch>";
  EXPECT_NE(tree_of("a.launch.xml", loops).find("more than 10000"), std::string::npos);
}

TEST(Launch, WhatASiteCannotStartIsLeftOutOrRefused) {
  const std::vector<InstalledPackage> installed{{.name = "demo",
                                                 .programs = {{.package = "demo",
                                                               .executable = "talker",
                                                               .file = "/p/lib/demo/talker.wasm",
                                                               .kind = ProgramKind::kWasm}}}};
  const auto nodes_of = [&](const std::string& text) {
    const LaunchWorld world = world_with("a.launch.xml", "<launch>" + text + "</launch>");
    return launch_file_nodes("/f/a.launch.xml", {}, world, installed, {});
  };
  const auto some = nodes_of(
      "<node pkg='rviz2' exec='rviz2'/><executable cmd='gz topic'/><timer period='2'>"
      "<node pkg='demo' exec='talker' respawn='true' respawn_delay='3'/></timer>"
      "<node pkg='demo' exec='talker' on_exit='shutdown'><env name='E' value='v'/></node>");
  ASSERT_TRUE(some.ok());
  ASSERT_EQ(some->nodes.size(), 2U);
  EXPECT_EQ(some->nodes[0].start_after_s, 2);
  EXPECT_EQ(some->nodes[0].respawn_delay_s, 3);
  EXPECT_FALSE(some->nodes[0].shutdown_on_exit);
  EXPECT_TRUE(some->nodes[1].shutdown_on_exit);
  EXPECT_EQ(some->nodes[1].environment.at("E"), "v");
  ASSERT_EQ(some->warnings.size(), 2U);
  for (const Diagnostic& warning : some->warnings) EXPECT_EQ(warning.code, "R2W0415");

  const auto refused = nodes_of(
      "<node pkg='gone' exec='x'/><node pkg='demo' exec='x'/>"
      "<node_container pkg='demo' exec='talker' name='box' namespace=''>"
      "<composable_node pkg='demo' plugin='demo::A' name='a'/></node_container>");
  ASSERT_FALSE(refused.ok());
  std::vector<std::string> codes;
  for (const Diagnostic& error : refused.errors()) codes.push_back(error.code.text());
  EXPECT_EQ(codes, (std::vector<std::string>{"R2W0417", "R2W0401", "R2W0402"}));
}

TEST(Launch, AContainerHasTheComponentsOfItsPackages) {
  std::vector<InstalledPackage> installed;
  for (const char* name : {"a", "b"})
    for (const std::string container :
         {"component_container", "component_container_mt", "component_container_isolated"}) {
      if (installed.empty() || installed.back().name != name) installed.push_back({.name = name});
      installed.back().programs.push_back({.package = name,
                                           .executable = container,
                                           .file = "/p/" + container + ".wasm",
                                           .kind = ProgramKind::kWasm});
    }
  const std::string text =
      "<launch><node_container pkg='rclcpp_components' exec='component_container_isolated' "
      "name='box' namespace='/n' args='--use_multi_threaded_executor'>"
      "<composable_node pkg='a' plugin='a::One' name='one'><param name='p' value='1'/>"
      "<extra_arg name='use_intra_process_comms' value='true'/></composable_node>"
      "<composable_node pkg='b' plugin='b::Two'/><composable_node pkg='a' plugin='a::Three'/>"
      "</node_container>"
      "<node_container pkg='rclcpp_components' exec='component_container_mt' name='mt' "
      "namespace=''><composable_node pkg='a' plugin='a::One'/></node_container>"
      "<node_container pkg='rclcpp_components' exec='my_container' name='own' "
      "namespace=''><composable_node pkg='a' plugin='a::One'/></node_container>"
      "<node_container pkg='rclcpp_components' exec='component_container' name='none' "
      "namespace=''/>"
      "</launch>";
  const LaunchWorld world = world_with("a.launch.xml", text);
  const auto made = launch_file_nodes("/f/a.launch.xml", {}, world, installed, {});
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->nodes.size(), 3U);
  EXPECT_EQ(made->nodes[0].label, "/n/box");
  EXPECT_EQ(made->nodes[0].package, "a");
  EXPECT_EQ(made->nodes[0].executable, "component_container_isolated");
  EXPECT_EQ(made->nodes[0].linked_with, std::vector<std::string>{"b"});
  EXPECT_EQ(made->nodes[0].program, "/p/component_container_isolated-b.wasm");
  EXPECT_EQ(made->nodes[1].executable, "component_container_mt");
  EXPECT_EQ(made->nodes[1].program, "/p/component_container_mt.wasm");
  EXPECT_EQ(made->nodes[2].executable, "component_container");
  EXPECT_EQ(
      made->nodes[0].arguments,
      (std::vector<std::string>{
          "--component=a::One", "--component-arg=--ros-args", "--component-arg=-r",
          "--component-arg=__node:=one", "--component-arg=-p", "--component-arg=p:=1",
          "--component-flag=use_intra_process_comms", "--component=b::Two", "--component=a::Three",
          "--use_multi_threaded_executor", "--ros-args", "-r", "__node:=box", "-r", "__ns:=/n"}));
  ASSERT_EQ(made->warnings.size(), 2U);
  for (const Diagnostic& warning : made->warnings) EXPECT_EQ(warning.code, "R2W0417");
}

TEST(Launch, WhatGrowsIsBounded) {
  const auto refused = [](const std::string& body, const std::string& why) {
    const std::string told = tree_of("a.launch.xml", "<launch>" + body + "</launch>");
    EXPECT_NE(told.find(why), std::string::npos) << told.substr(0, 300);
  };
  refused(
      "<let name='x' value='aa'/><for len='60' name='i'>"
      "<let name='x' value='$(var x)$(var x)'/></for>",
      "more than 4 MiB");
  refused("<let name='x' value='" + std::string(100'000, 'x') +
              "'/><for len='10000' name='i'><let name='x$(index i)' value='$(var x)'/></for>",
          "more than 256 MiB");
  refused("<for len='10000' name='i'><for len='10000' name='j'><log message='m'/></for></for>",
          "more than 200000 actions");
}

TEST(Launch, PartsHaveTheirAttributesOnly) {
  const auto told = [](const std::string& part) {
    return tree_of("a.launch.xml", "<launch><node pkg='a' exec='b'>" + part + "</node></launch>");
  };
  EXPECT_EQ(told("<param name='x' value='1' if='false'/>"),
            "R2W0410 `param` has no attribute `if`\n");
  EXPECT_EQ(told("<remap from='x'/>"), "R2W0410 `remap` needs the attribute `to`\n");
  EXPECT_EQ(told("<env name='x' val='1'/>"),
            "R2W0410 `env` needs the attribute `value`\nR2W0410 `env` has no attribute `val`\n");
}

TEST(Launch, LettersAndQuotedNumbersAreTexts) {
  EXPECT_EQ(tree_of("a.launch.xml",
                    "<launch><node pkg='a' exec='b'><param name='axis' value='y'/><param name='u' "
                    "value='[t, f]'/><param name='on' value='on'/></node></launch>"),
            "a/b\n  param axis: 'y'\n  param u: ['t', 'f']\n  param on: true\n");
  EXPECT_EQ(tree_of("a.launch.yaml",
                    "launch:\n- node: {pkg: a, exec: b, param: [{name: port, value: \"8080\"}, "
                    "{name: l, value: [\"1\", \"2\"]}, {name: n, value: \"$(var x 8)\"}]}\n"),
            "a/b\n  param port: '8080'\n  param l: ['1', '2']\n  param n: 8\n");
}

TEST(Launch, WhatAnUnseenFileSaysIsLeftOutBeforeTheBuild) {
  const auto evaluated = [](const std::string& more) {
    LaunchWorld world =
        world_with("a.launch.xml",
                   "<launch><include file='/p/share/x/a.launch.xml'/><node pkg='a' exec='b'>"
                   "<param from='/p/share/x/p.yaml'/></node>" +
                       more + "</launch>");
    world.is_later = [](const std::string& path) { return path.starts_with("/p/share/"); };
    return evaluate_launch("/f/a.launch.xml", {}, world);
  };
  const auto result = evaluated("");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->processes.size(), 1U);
  ASSERT_EQ(result->warnings.size(), 2U);
  for (const Diagnostic& warning : result->warnings) EXPECT_EQ(warning.code, "R2W0419");

  const auto missing = evaluated("<include file='/f/none.launch.xml'/>");
  ASSERT_FALSE(missing.ok());
  ASSERT_EQ(missing.errors().size(), 1U);
  EXPECT_EQ(missing.errors()[0].code, "R2W0413");
}

}  // namespace
}  // namespace ros2wasm
