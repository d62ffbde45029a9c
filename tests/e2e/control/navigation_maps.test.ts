// Maps and managed nodes as bringup packages of Nav2 start them: map_server with files in all modes, map_saver_cli, and two lifecycle
// managers, whose nodes crash, with and without a respawn. Headless.

// Compatibility, works: Nav2's maps: `map_server` (PGM, PPM, PNG and BMP; modes trinary, scale and raw; `load_map`, `map`), `map_saver_cli`,
// `map_saver_server`, `costmap_filter_info_server`, and the library map_io for nodes of the workspace

// Compatibility, works: Nav2's `lifecycle_manager` (autostart, `manage_nodes`, `is_active`, bonds, restart after a respawn), its C++ client,
// bondcpp, and `nav2_util::LifecycleNode` for nodes of the workspace

// Compatibility, differs: maps -> images of more than 33 million pixels, YAML files of more than 1 MiB and other image formats than
// those are refused; a map is saved as PGM, PNG or BMP

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { crc32, deflateSync } from 'node:zlib';

import { played } from '../../support/nightly.ts';
import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml


def server(package, executable, name=None, **more):
    return Node(package=package, executable=executable, name=name or executable, output='screen', **more)


def manager(name, nodes, **more):
    return server('nav2_lifecycle_manager', 'lifecycle_manager', name,
                  parameters=[{'use_sim_time': False}, {'autostart': LaunchConfiguration('autostart')},
                              {'node_names': nodes}, more])


def saver(*words):
    return Node(package='nav2_map_server', executable='map_saver_cli', output='screen', arguments=list(words))


def generate_launch_description():
    share = get_package_share_directory('house_maps')
    params_file = os.path.join(share, 'params', 'nav2_params.yaml')
    configured_params = RewrittenYaml(source_file=params_file, root_key='', convert_types=True,
                                      param_rewrites={'yaml_filename': LaunchConfiguration('map')})
    watcher = Node(package='house_maps', executable='watcher', output='screen')
    first, second, third = saver('-f', 'house', '--fmt', 'PNG', '--mode', 'scale'), saver('-t', 'nothing'), saver('--size')
    return LaunchDescription([
        DeclareLaunchArgument('map', default_value=os.path.join(share, 'maps', 'house.yaml')),
        DeclareLaunchArgument('autostart', default_value='true'),
        server('nav2_map_server', 'map_server', parameters=[configured_params]),
        server('nav2_map_server', 'map_saver_server', 'map_saver', parameters=[configured_params]),
        server('nav2_map_server', 'costmap_filter_info_server', parameters=[configured_params]),
        server('house_maps', 'sentry', respawn=True, respawn_delay=1.0),
        server('house_maps', 'sentry', 'guard'),
        manager('lifecycle_manager_localization', ['sentry', 'map_server', 'map_saver']),
        manager('lifecycle_manager_filters', ['guard', 'costmap_filter_info_server'], bond_respawn_max_duration=2.0),
        watcher,
        RegisterEventHandler(OnProcessExit(target_action=watcher, on_exit=[first])),
        RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[second])),
        RegisterEventHandler(OnProcessExit(target_action=second, on_exit=[third])),
        RegisterEventHandler(OnProcessExit(target_action=third, on_exit=[
            Node(package='house_maps', executable='driver', output='screen')])),
    ])
`;

const parameters = `
map_server:
  ros__parameters:
    yaml_filename: ""
map_saver:
  ros__parameters:
    save_map_timeout: 5.0
    free_thresh_default: 0.25
    occupied_thresh_default: 0.65
    map_subscribe_transient_local: True
costmap_filter_info_server:
  ros__parameters:
    type: 1
    filter_info_topic: "/speed_filter_info"
    mask_topic: "/speed_mask"
    base: 100.0
    multiplier: -1.0
`;

const sentry = `
#include "nav2_util/lifecycle_node.hpp"
#include "std_msgs/msg/empty.hpp"

class Sentry : public nav2_util::LifecycleNode {
 public:
  Sentry() : LifecycleNode("sentry") {}
  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    crash_ = create_subscription<std_msgs::msg::Empty>("crash", 1, [](const std_msgs::msg::Empty&) { std::_Exit(3); });
    return nav2_util::CallbackReturn::SUCCESS;
  }
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State&) override { createBond(); return nav2_util::CallbackReturn::SUCCESS; }
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) override { destroyBond(); return nav2_util::CallbackReturn::SUCCESS; }

 private:
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr crash_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Sentry>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
}
`;

const head = `
#include <functional>
#include <string>

#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using namespace std::chrono_literals;
using nav_msgs::msg::OccupancyGrid;

${driverStart}

inline std::string text_of(const OccupancyGrid& map) {
  std::string text = std::to_string(map.info.width) + "x" + std::to_string(map.info.height) + ":";
  for (const int cell : map.data) text += " " + std::to_string(cell);
  return text;
}

inline OccupancyGrid::SharedPtr heard;
inline auto hear() {
  return node->create_subscription<OccupancyGrid>(
      "map", rclcpp::QoS(rclcpp::KeepLast(1)).transient_local(), [](const OccupancyGrid::SharedPtr map) { heard = map; });
}
`;

const watcher = `
#include "house.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("watcher");
  const auto subscription = hear();
  spin_until([] { return heard != nullptr; });
  const auto& origin = heard->info.origin;
  say("map %s", text_of(*heard).c_str());
  say("in %s at %.2f %.2f %.4f with %.3f m", heard->header.frame_id.c_str(), origin.position.x, origin.position.y,
      tf2::getYaw(origin.orientation), heard->info.resolution);
  rclcpp::shutdown();
}
`;

const driver = `
#include "house.hpp"

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "nav2_lifecycle_manager/lifecycle_manager_client.hpp"
#include "nav2_map_server/map_io.hpp"
#include "nav2_msgs/msg/costmap_filter_info.hpp"
#include "nav2_msgs/srv/load_map.hpp"
#include "nav2_msgs/srv/save_map.hpp"
#include "nav_msgs/srv/get_map.hpp"
#include "std_msgs/msg/empty.hpp"

using nav2_lifecycle_manager::LifecycleManagerClient;
using nav2_lifecycle_manager::SystemStatus;

template <typename ServiceT>
typename ServiceT::Response call(const std::string& name, std::shared_ptr<typename ServiceT::Request> request = std::make_shared<typename ServiceT::Request>()) {
  nav2_util::ServiceClient<ServiceT> client(name, node);
  return *client.invoke(request, 30s);
}

void load(const std::string& name) {
  auto request = std::make_shared<nav2_msgs::srv::LoadMap::Request>();
  request->map_url = name.empty() ? "" : ament_index_cpp::get_package_share_directory("house_maps") + "/maps/" + name + ".yaml";
  const auto response = call<nav2_msgs::srv::LoadMap>("map_server/load_map", request);
  const bool is_loaded = response.result == nav2_msgs::srv::LoadMap::Response::RESULT_SUCCESS;
  say("load %s: %d%s", name.c_str(), response.result, is_loaded ? (" " + text_of(response.map)).c_str() : "");
  if (is_loaded && !spin_until([&] { return heard != nullptr && heard->data == response.map.data; })) say("%s", "not published");
}

void save(const std::string& name, const std::string& mode, const std::string& format) {
  auto request = std::make_shared<nav2_msgs::srv::SaveMap::Request>();
  request->map_url = name;
  request->map_mode = mode;
  request->image_format = format;
  const bool is_saved = call<nav2_msgs::srv::SaveMap>("map_saver/save_map", request).result;
  OccupancyGrid map = *heard;
  nav2_map_server::SaveParameters own;
  own.map_file_name = name + "_here";
  own.image_format = format;
  own.mode = nav2_map_server::map_mode_from_string(mode);
  const bool is_written = nav2_map_server::saveMapToFile(map, own);
  map.data.clear();
  const auto status = nav2_map_server::loadMapFromYaml(own.map_file_name + ".yaml", map);
  say("save %s: %d, here %d, read %d %s", name.c_str(), is_saved, is_written, status, text_of(map).c_str());
}

std::string state(const std::string& name) {
  return call<lifecycle_msgs::srv::GetState>(name + "/get_state").current_state.label;
}

void crash(LifecycleManagerClient& localization, LifecycleManagerClient& filters) {
  const auto publisher = node->create_publisher<std_msgs::msg::Empty>("crash", 1);
  spin_until([&] { return publisher->get_subscription_count() == 2; });
  const double start = node->now().seconds();
  publisher->publish(std_msgs::msg::Empty());
  spin_until([&] { return filters.is_active() == SystemStatus::INACTIVE; });
  say("down after %.2f s", node->now().seconds() - start);
  say("filters %s", state("costmap_filter_info_server").c_str());
  spin_until([&] { return localization.is_active() == SystemStatus::ACTIVE && state("sentry") == "active"; });
  say("again map_server %s, sentry %s, filters %s", state("map_server").c_str(), state("sentry").c_str(), state("costmap_filter_info_server").c_str());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  const auto subscription = hear();
  nav2_msgs::msg::CostmapFilterInfo info;
  const auto infos = node->create_subscription<nav2_msgs::msg::CostmapFilterInfo>(
      "/speed_filter_info", rclcpp::QoS(1).transient_local(), [&](const nav2_msgs::msg::CostmapFilterInfo& message) { info = message; });
  LifecycleManagerClient localization("lifecycle_manager_localization", node);
  LifecycleManagerClient filters("lifecycle_manager_filters", node);
  spin_until([&] { return localization.is_active() == SystemStatus::ACTIVE && filters.is_active() == SystemStatus::ACTIVE && !info.filter_mask_topic.empty(); });
  say("info %d %s %.1f %.1f", info.type, info.filter_mask_topic.c_str(), info.base, info.multiplier);
  for (const char* name : {"scale", "loose", "raw", "png", "bmp", "", "missing", "broken", "deep", "no_image", "unknown_mode", "huge", "short", "bomb", "house"}) load(name);
  say("get %s", text_of(call<nav_msgs::srv::GetMap>("map_server/map").map).c_str());
  save("trinary", "trinary", "pgm");
  load("scale");
  save("scale", "scale", "png");
  load("raw");
  save("raw", "raw", "bmp");
  say("pause %d: %s", localization.pause(), state("map_server").c_str());
  say("paused get %s", text_of(call<nav_msgs::srv::GetMap>("map_server/map").map).c_str());
  say("resume %d: %s", localization.resume(), state("map_server").c_str());
  crash(localization, filters);
  say("reset %d: %s", localization.reset(), state("map_server").c_str());
  say("startup %d: %s", localization.startup(), state("map_server").c_str());
  say("shutdown %d: %s", localization.shutdown(), state("map_server").c_str());
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

/** A PNG of 8 bits: colour type 0 is gray, 6 is RGBA. */
function png(width: number, height: number, type: 0 | 6, rows: readonly (readonly number[])[]): Buffer {
  const chunk = (name: string, data: Uint8Array): Buffer => {
    const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
    const size = Buffer.alloc(4);
    size.writeUInt32BE(data.length);
    const sum = Buffer.alloc(4);
    sum.writeUInt32BE(crc32(body));
    return Buffer.concat([size, body, sum]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, type, 0, 0, 0], 8);
  const data = deflateSync(Uint8Array.from(rows.flatMap((row) => [0, ...row])));
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header), chunk('IDAT', data), chunk('IEND', Buffer.alloc(0))]);
}

/** A BMP of 24 bits, two pixels wide: the rows from the bottom. */
function bmp(rows: readonly (readonly number[])[]): Buffer {
  const head = Buffer.alloc(54);
  head.write('BM', 0, 'latin1');
  head.writeUInt32LE(54 + 8 * rows.length, 2);
  head.writeUInt32LE(54, 10);
  head.writeUInt32LE(40, 14);
  head.writeInt32LE(2, 18);
  head.writeInt32LE(rows.length, 22);
  head.writeUInt16LE(1, 26);
  head.writeUInt16LE(24, 28);
  return Buffer.concat([head, ...rows.map((row) => Buffer.from([...row.flatMap((gray) => [gray, gray, gray]), 0, 0]))]);
}

const yaml = (image: string, more = '', free = 0.196): string =>
  `image: ${image}\nresolution: 0.05\norigin: [-1.0, -2.0, 1.5708]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: ${String(free)}\n${more}`;
const pixels = [0, 128, 205, 254, 254, 254, 0, 0];

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['nav2_util', 'nav2_lifecycle_manager', 'nav2_map_server', 'nav2_msgs', 'nav_msgs', 'rclcpp', 'std_msgs', 'ament_index_cpp',
    'tf2_geometry_msgs'];
  workspace.addPackage('house_maps', { sentry, watcher, driver }, {
    depends: [...libraries, 'nav2_common'],
    cmake: `${[...libraries, 'nav2_common'].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
nav2_package()
ament_target_dependencies(sentry nav2_util rclcpp std_msgs)
ament_target_dependencies(watcher nav_msgs rclcpp tf2_geometry_msgs)
ament_target_dependencies(driver ${libraries.join(' ')})
target_link_libraries(driver nav2_map_server::map_io)
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_maps/${path}`, content);
  file('src/house.hpp', head);
  file('launch/bringup_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/house.pgm', Buffer.concat([Buffer.from('P5\n# CREATOR: a test 0.050 m/pix\n4 2\n255\n'), Buffer.from(pixels)]));
  file('maps/house.yaml', yaml('house.pgm'));
  file('maps/scale.yaml', yaml('house.pgm', 'mode: scale\n'));
  file('maps/loose.yaml', yaml('house.pgm', 'mode: trinary\n', 0.25));
  file('maps/raw.pgm', 'P2 4 2 255\n0 50 100 101\n255 200 1 2\n');
  file('maps/raw.yaml', yaml('raw.pgm', 'mode: Raw\n'));
  file('maps/png.png', png(3, 1, 6, [[255, 255, 255, 255, 0, 0, 0, 128, 255, 0, 0, 255]]));
  file('maps/png.yaml', yaml('png.png').replace('negate: 0', 'negate: true'));
  file('maps/bmp.bmp', bmp([[0, 254], [205, 0]]));
  file('maps/bmp.yaml', yaml('bmp.bmp'));
  file('maps/broken.yaml', 'image: house.pgm\nresolution: [0.05\n');
  file('maps/deep.yaml', `${'['.repeat(100_000)}\n`);
  file('maps/no_image.yaml', yaml('no_such.pgm'));
  file('maps/unknown_mode.yaml', yaml('house.pgm', 'mode: colourful\n'));
  file('maps/huge.pgm', 'P5\n999999 999999\n255\n');
  file('maps/huge.yaml', yaml('huge.pgm'));
  file('maps/short.pgm', 'P5\n5000 5000\n255\n12345');
  file('maps/short.yaml', yaml('short.pgm'));
  file('maps/bomb.png', png(30_000, 30_000, 0, [Array.from({ length: 1000 }, () => 0)]));
  file('maps/bomb.yaml', yaml('bomb.png'));
  workspace.write('workspace.yaml', 'schema: 1\nname: house\npackages: [src/*]\nlaunch: src/house_maps/launch/bringup_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

/** That all of these are in the list, in this order. */
function inOrder(lines: readonly string[], wanted: readonly string[]): void {
  let at = -1;
  for (const line of wanted) {
    at = lines.indexOf(line, at + 1);
    assert.notEqual(at, -1, `not there, or not in its place: ${line}\n${lines.join('\n')}`);
  }
}

/** File name -> content, of all nodes. */
function readFolder(folder: string): Map<string, string> {
  const found = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return new Map(found.map((entry) => [entry.name, readFileSync(join(entry.parentPath, entry.name), 'latin1')]));
}

for (const link of played('port', 'shared')) {
  test(`${link}: maps are served and saved, and the managers lead their nodes`, watchdog, async () => {
    const kept = mkdtempSync(join(tmpdir(), 'ros2wasm-maps-'));
    try {
      const run = await workspace.run(['run', 'site', '--link', link, '--bags', kept, '--for', '240s', '--until', 'driver is over']);
      const output = run.stdout + run.stderr;
      assert.equal(run.code, 0, output);

      assert.deepEqual(said(output, 'watcher'), ['map 4x2: 0 0 100 100 100 -1 -1 0', 'in map at -1.00 -2.00 1.5708 with 0.050 m']);
      const lines = said(output, 'driver');
      inOrder(lines, [
        'info 1 /speed_mask 100.0 -1.0',
        'load scale: 0 4x2: 0 0 100 100 100 67 0 0', // 128: (127/255 - 0.196) / 0.454 = 0.665
        'load loose: 0 4x2: 0 0 100 100 100 -1 0 0', // 205: 50/255 = 0.196 is below 0.25
        'load raw: 0 4x2: -1 -1 1 2 0 50 100 -1',
        'load png: 0 3x1: 100 -1 -1', // white, half transparent, red: 0.299 is between the thresholds
        'load bmp: 0 2x2: 100 0 -1 100',
        'load : 1',
        'load missing: 3',
        'load broken: 3',
        'load deep: 3',
        'load no_image: 2',
        'load unknown_mode: 3',
        'load huge: 2',
        'load short: 2',
        'load bomb: 2',
        'load house: 0 4x2: 0 0 100 100 100 -1 -1 0',
        'get 4x2: 0 0 100 100 100 -1 -1 0',
        'save trinary: 1, here 1, read 0 4x2: 0 0 100 100 100 -1 -1 0',
        'save scale: 1, here 1, read 0 4x2: 0 0 100 100 100 100 0 0',
        'save raw: 1, here 1, read 0 4x2: -1 -1 1 2 0 50 100 -1',
        'pause 1: inactive',
        'paused get 0x0:',
        'resume 1: active',
        'filters inactive',
        'again map_server active, sentry active, filters inactive',
        'reset 1: unconfigured',
        'startup 1: active',
        'shutdown 1: finalized',
        'driver is over',
      ]);
      const down = Number(/down after ([\d.]+) s/.exec(lines.join('\n'))?.[1]);
      assert.ok(down > 3.5 && down < 15, `down after ${String(down)} s`);

      const reasons = said(output, 'map_io');
      for (
        const reason of [
          /YAML file name is empty, can't load!/,
          /Failed processing YAML file \S+missing\.yaml at position \(-1:-1\) for reason: bad file: \S+missing\.yaml/,
          /Failed processing YAML file \S+broken\.yaml at position \(2:0\) for reason: yaml-cpp: error at line 3, column 1: /,
          /Failed processing YAML file \S+deep\.yaml at position /,
          /Failed to load image file \S+no_such\.pgm for reason: Unable to open file \(/,
          /Failed to parse map YAML loaded from file \S+unknown_mode\.yaml for reason: map_mode_name/,
          /Failed to load image file \S+huge\.pgm for reason: the image has 999999 x 999999 pixels, more than 33554432/,
          /Failed to load image file \S+short\.pgm for reason: not a valid portable image: it ends after 5 of 25000000 bytes of pixels/,
          /Failed to load image file \S+bomb\.png for reason: the image has 30000 x 30000 pixels, more than 33554432/,
          /Read map \S+house_maps\/maps\/house\.pgm: 4 X 2 map @ 0\.05 m\/cell/,
        ]
      ) assert.ok(reasons.some((line) => reason.test(line)), `map_io does not log ${String(reason)}\n${reasons.join('\n')}`);

      inOrder(said(output, 'lifecycle_manager_localization'), [
        'Creating and initializing lifecycle service clients',
        'Starting managed nodes bringup...',
        'Configuring sentry',
        'Configuring map_server',
        'Configuring map_saver',
        'Activating sentry',
        'Server sentry connected with bond.',
        'Activating map_server',
        'Server map_server connected with bond.',
        'Activating map_saver',
        'Server map_saver connected with bond.',
        'Managed nodes are active',
        'Creating bond timer...',
        'Terminating bond timer...',
        'Pausing managed nodes...',
        'Deactivating map_saver',
        'Deactivating map_server',
        'Deactivating sentry',
        'Managed nodes have been paused',
        'Resuming managed nodes...',
        'Managed nodes are active',
        'Have not received a heartbeat from sentry.',
        'CRITICAL FAILURE: SERVER sentry IS DOWN after not receiving a heartbeat for 4000 ms. Shutting down related nodes.',
        'Resetting managed nodes...',
        'Deactivating sentry',
        'Failed to change state for node: sentry',
        'Cleaning up map_server',
        'Managed nodes have been reset',
        'Successfully re-established connections from server respawns, starting back up.',
        'Managed nodes are active',
        'Shutting down managed nodes...',
        'Deactivate, cleanup, and shutdown nodes',
        'Shutting down sentry',
        'Managed nodes have been shut down',
      ]);
      inOrder(said(output, 'lifecycle_manager_filters'), [
        'Managed nodes are active',
        'CRITICAL FAILURE: SERVER guard IS DOWN after not receiving a heartbeat for 4000 ms. Shutting down related nodes.',
        'Deactivating costmap_filter_info_server',
        'Deactivating guard',
        'Failed to change state for node: guard. Exception: change_state service is not available!.',
        'Managed nodes have been reset',
      ]);
      inOrder(said(output, 'map_server'), ['Creating', 'Configuring', 'Activating', 'Creating bond (map_server) to lifecycle manager.',
        'Handling LoadMap request', 'Handling GetMap request', 'Deactivating', 'Destroying bond (map_server) to lifecycle manager.', 'Cleaning up',
        'Shutting down']);

      assert.match(output, /\[map_saver\]: Saving map from 'map' topic to 'house' file/);
      assert.match(output, /\[map_saver\]: Map saved successfully/);
      assert.match(output, /\[map_saver\]: Failed to spin map subscription/);
      assert.match(output, /\[map_saver_cli\]: Wrong argument: --size/);
      const ends = output.match(/^\[map_saver_cli-\d+\] process has [^\n]*/gm)?.map((line) => line.replace(/\[map_saver_cli-\d+\] process has /, ''));
      assert.deepEqual(ends?.sort(), ['died [exit code 1]', 'died [exit code 255]', 'finished cleanly']);
      const files = readFolder(kept);
      assert.equal(files.get('house.yaml'),
        'image: house.png\nmode: scale\nresolution: 0.050\norigin: [-1.000, -2.000, 1.5708]\nnegate: 0\noccupied_thresh: 0.650\nfree_thresh: 0.250');
      assert.match(files.get('house.png') ?? '', /^\x89PNG/); // eslint-disable-line no-control-regex
      assert.equal(files.get('trinary.pgm'), `P5\n4 2\n255\n${Buffer.from(pixels.map((one) => (one === 128 ? 205 : one))).toString('latin1')}`);
      assert.equal(files.get('trinary.yaml'),
        'image: trinary.pgm\nmode: trinary\nresolution: 0.050\norigin: [-1.000, -2.000, 1.5708]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196');
    } finally {
      rmSync(kept, { recursive: true });
    }
  });
}
