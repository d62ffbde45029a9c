// Sensors of Gazebo Classic and Gazebo Sim other than lidars, cameras and IMUs: contacts, forces, positions on the earth, heights,
// pressure, magnetic field and distance, each against its formula. Headless in Node.js.

// Compatibility, works: sensors of a simulated robot besides lidar and IMU: contact (`libgazebo_ros_bumper.so`), force and torque
// (`libgazebo_ros_ft_sensor.so`), satellite receiver (`libgazebo_ros_gps_sensor.so`), and in Gazebo Sim altimeter, magnetometer and
// air pressure too

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };
const rad = Math.PI / 180;
const origin = { latitude: 47.4, longitude: 8.5, elevation: 400 };
const station = { east: 300, north: 400, up: 20 };

/** Metres from the centre of the earth, by the definition of WGS84. */
function earthPoint(latitude: number, longitude: number, altitude: number): [number, number, number] {
  const a = 6378137;
  const f = 1 / 298.257223563;
  const e2 = f * (2 - f);
  const n = a / Math.sqrt(1 - e2 * Math.sin(latitude * rad) ** 2);
  const out = (n + altitude) * Math.cos(latitude * rad);
  return [out * Math.cos(longitude * rad), out * Math.sin(longitude * rad), (n * (1 - e2) + altitude) * Math.sin(latitude * rad)];
}

/** Latitude and longitude of the station: the ones whose point is where the tangent plane has it, by Newton's method. */
function stationOnEarth(): [number, number] {
  const [sp, cp, sl, cl] = [Math.sin(origin.latitude * rad), Math.cos(origin.latitude * rad), Math.sin(origin.longitude * rad),
    Math.cos(origin.longitude * rad)];
  const home = earthPoint(origin.latitude, origin.longitude, origin.elevation);
  const { east, north, up } = station;
  const target = [home[0] - sl * east - sp * cl * north + cp * cl * up, home[1] + cl * east - sp * sl * north + cp * sl * up, home[2] + cp * north + sp * up];
  let [latitude, longitude, altitude] = [origin.latitude, origin.longitude, origin.elevation];
  for (let i = 0; i < 20; i++) {
    const at = earthPoint(latitude, longitude, altitude);
    const [dx, dy, dz] = [0, 1, 2].map((axis) => (target[axis] ?? NaN) - (at[axis as 0 | 1 | 2])) as [number, number, number];
    longitude += (-sl * dx + cl * dy) / (6.378e6 * cp) / rad;
    latitude += (-sp * cl * dx - sp * sl * dy + cp * dz) / 6.378e6 / rad;
    altitude += cp * cl * dx + cp * sl * dy + sp * dz;
  }
  return [latitude, longitude];
}

const box = (size: string): string => `<geometry><box><size>${size}</size></box></geometry>`;
const sphere = '<collision name="shell"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>';
const fan = '<scan><horizontal><samples>11</samples><min_angle>-0.1</min_angle><max_angle>0.1</max_angle></horizontal></scan>'
  + '<range><min>0.1</min><max>5</max></range>';

/** A box of 2 kg on the floor and one in the air, an arm of 3 kg on a joint, a station on a tower with a wall 2 m before it, and a
 * stone that falls. Classic has the sensors in the form `[plugin]`. */
interface Sensors {
  readonly bumper: string;
  readonly hover: string;
  readonly joint: string;
  readonly arm: string;
  readonly station: string;
  readonly stone: string;
}
const world = (systems: string, sensors: Sensors): string =>
  `<sdf version="1.7"><world name="yard">${systems}
  <magnetic_field>1e-6 2e-6 -4e-5</magnetic_field>
  <model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>
  <model name="crate"><pose>0 0 0.1 0 0 0</pose><link name="body"><inertial><mass>2</mass></inertial>
    <collision name="shell">${box('0.4 0.4 0.2')}</collision>${sensors.bumper}</link></model>
  <model name="balloon"><pose>5 0 3 0 0 0</pose><link name="body"><gravity>false</gravity>${sphere}${sensors.hover}</link></model>
  <model name="arm"><pose>0 5 1 0 0 0</pose>
    <link name="boom"><inertial><pose>0.5 0 0 0 0 0</pose><mass>3</mass></inertial>${sphere}</link>
    <joint name="mount" type="fixed"><parent>world</parent><child>boom</child>${sensors.joint}</joint>${sensors.arm}</model>
  <model name="station"><static>true</static><pose>${station.east} ${station.north} ${station.up} 0 0 1.5707963267948966</pose>
    <link name="top">${sensors.station}</link></model>
  <model name="wall"><static>true</static><pose>${station.east} ${station.north + 2.1} ${station.up} 0 0 0</pose>
    <link name="l"><collision name="c">${box('4 0.2 4')}</collision><visual name="v">${box('4 0.2 4')}</visual></link></model>
  <model name="stone"><pose>50 0 2000 0 0 0</pose><link name="body">${sphere}${sensors.stone}</link></model>
</world></sdf>
`;

const bumper = (namespace: string, collisions: string): string =>
  `<sensor name="bumper" type="contact"><update_rate>20</update_rate>
  <contact>${collisions}</contact><plugin name="${namespace}_bumper" filename="libgazebo_ros_bumper.so">
  <ros><namespace>${namespace}</namespace></ros><frame_name>floor</frame_name></plugin></sensor>`;
const shell = '<collision>shell</collision>';
const onEarth = (heading: number): string =>
  `<spherical_coordinates><surface_model>EARTH_WGS84</surface_model>
  <latitude_deg>${origin.latitude}</latitude_deg><longitude_deg>${origin.longitude}</longitude_deg>
  <elevation>${origin.elevation}</elevation><heading_deg>${heading}</heading_deg></spherical_coordinates>`;
const classicWorld = world(onEarth(180), {
  bumper: bumper('crate', `${shell}<collision>shel</collision>`),
  hover: bumper('balloon', shell),
  joint: '',
  arm: `<plugin name="cell" filename="libgazebo_ros_ft_sensor.so"><joint_name>mount</joint_name><update_rate>20</update_rate></plugin>
    <plugin name="lost" filename="libgazebo_ros_ft_sensor.so"><joint_name>moun</joint_name></plugin>
    <plugin name="astray" filename="libgazebo_ros_gps_sensor.so"/>`,
  station: `<sensor name="gps" type="gps"><update_rate>10</update_rate><plugin name="gps" filename="libgazebo_ros_gps_sensor.so">
      <ros><remapping>~/out:=fix</remapping><remapping>~/vel:=fix_velocity</remapping></ros></plugin></sensor>
    <sensor name="sonar" type="ray"><update_rate>10</update_rate><ray>${fan}</ray><plugin name="sonar" filename="libgazebo_ros_ray_sensor.so">
      <ros><remapping>~/out:=sonar</remapping></ros><output_type>sensor_msgs/Range</output_type>
      <radiation_type>ultrasound</radiation_type></plugin></sensor>`,
  stone: `<sensor name="gps" type="gps"><update_rate>10</update_rate><plugin name="falling" filename="libgazebo_ros_gps_sensor.so"/></sensor>`,
});

const simSensors: Sensors = {
  bumper: `<sensor name="bumper" type="contact"><contact>${shell}<collision>shel</collision><topic>bumper</topic></contact></sensor>`,
  hover: `<sensor name="bumper" type="contact"><topic>hover</topic><contact>${shell}</contact></sensor>`,
  joint: '<sensor name="cell" type="force_torque"><update_rate>20</update_rate></sensor>',
  arm: '',
  station: `<sensor name="gps" type="navsat"><topic>fix</topic><update_rate>10</update_rate></sensor>
    <sensor name="sonar" type="gpu_lidar"><topic>sonar</topic><update_rate>10</update_rate><lidar>${fan}</lidar></sensor>
    <sensor name="compass" type="magnetometer"><topic>magnetic</topic><update_rate>10</update_rate></sensor>
    <sensor name="barometer" type="air_pressure"><topic>pressure</topic><update_rate>10</update_rate>
      <air_pressure><reference_altitude>980</reference_altitude></air_pressure></sensor>`,
  stone: `<sensor name="height" type="altimeter"><topic>height</topic><update_rate>10</update_rate><altimeter>
    <vertical_velocity><noise type="gaussian"><stddev>0.01</stddev></noise></vertical_velocity></altimeter></sensor>`,
};
const system = (name: string, library: string): string => `<plugin filename="gz-sim-${library}-system" name="gz::sim::systems::${name}"/>`;
const needed: readonly (readonly [string, string, string])[] = [
  ['contact', 'Contact', 'contact'],
  ['force_torque', 'ForceTorque', 'forcetorque'],
  ['navsat', 'NavSat', 'navsat'],
  ['altimeter', 'Altimeter', 'altimeter'],
  ['magnetometer', 'Magnetometer', 'magnetometer'],
  ['air_pressure', 'AirPressure', 'air-pressure'],
];
const simWorld = world(system('Physics', 'physics') + system('Sensors', 'sensors')
  + needed.map(([, name, library]) => system(name, library)).join('') + onEarth(0), simSensors);
/** It is nowhere on the earth, and no other system brings sensors to life. */
const bareWorld = world(system('Physics', 'physics') + system('NavSat', 'navsat'), simSensors);

const listener = `
#include <cmath>
#include <gazebo_msgs/msg/contacts_state.hpp>
#include <geometry_msgs/msg/vector3_stamped.hpp>
#include <geometry_msgs/msg/wrench_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <ros_gz_interfaces/msg/altimeter.hpp>
#include <ros_gz_interfaces/msg/contacts.hpp>
#include <sensor_msgs/msg/fluid_pressure.hpp>
#include <sensor_msgs/msg/magnetic_field.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <sensor_msgs/msg/range.hpp>
#include <set>

/** Says what each sensor measures two seconds after the start, when the crate has come to rest. */
class Listener : public rclcpp::Node {
 public:
  Listener() : Node("listener") {
    const size_t kinds = declare_parameter("kinds", 0);
    hear<gazebo_msgs::msg::ContactsState>("crate/bumper_states", [this](const auto& m) {
      const auto& s = m.states.at(0);
      RCLCPP_INFO(get_logger(), "contact in %s: %zu, %s on %s, %zu points, normal %.0f, %.2f N", m.header.frame_id.c_str(), m.states.size(),
                  s.collision1_name.c_str(), s.collision2_name.c_str(), s.contact_positions.size(), s.contact_normals.at(0).z, s.total_wrench.force.z);
    });
    hear<gazebo_msgs::msg::ContactsState>("balloon/bumper_states", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "the balloon touches %zu", m.states.size());
    });
    hear<ros_gz_interfaces::msg::Contacts>("bumper", [this](const auto& m) {
      const auto& c = m.contacts.at(0);
      double force = 0;
      for (const auto& w : c.wrenches) force += w.body_1_wrench.force.z;
      RCLCPP_INFO(get_logger(), "contact in %s: %zu, %s on %s, %zu points, normal %.0f, %.2f N", m.header.frame_id.c_str(), m.contacts.size(),
                  c.collision1.name.c_str(), c.collision2.name.c_str(), c.positions.size(), c.normals.at(0).z, force);
    });
    hovers_ = create_subscription<ros_gz_interfaces::msg::Contacts>("hover", 10, [this](const ros_gz_interfaces::msg::Contacts&) {
      RCLCPP_ERROR(get_logger(), "nothing touches the balloon");
    });
    hear<geometry_msgs::msg::WrenchStamped>("wrench", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "wrench in %s: %.2f N, %.2f N m", m.header.frame_id.c_str(), m.wrench.force.z, m.wrench.torque.y);
    });
    hear<sensor_msgs::msg::NavSatFix>("fix", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "fix in %s: %d %.7f %.7f %.2f", m.header.frame_id.c_str(), m.status.status, m.latitude, m.longitude, m.altitude);
    });
    hear<geometry_msgs::msg::Vector3Stamped>("falling/vel", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "the stone falls %.2f times as it should", m.vector.z / (-9.8 * rclcpp::Time(m.header.stamp).seconds()));
    });
    hear<ros_gz_interfaces::msg::Altimeter>("height", [this](const auto& m) {
      const double t = rclcpp::Time(m.header.stamp).seconds();
      RCLCPP_INFO(get_logger(), "height in %s: %.2f and %.2f times as it should, from %.0f", m.header.frame_id.c_str(),
                  m.vertical_position / (-4.9 * t * t), m.vertical_velocity / (-9.8 * t), m.vertical_reference);
    });
    hear<sensor_msgs::msg::MagneticField>("magnetic", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "field: %.1f %.1f %.1f uT", 1e6 * m.magnetic_field.x, 1e6 * m.magnetic_field.y, 1e6 * m.magnetic_field.z);
    });
    hear<sensor_msgs::msg::FluidPressure>("pressure", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "pressure: %.1f hPa", m.fluid_pressure / 100);
    });
    hear<sensor_msgs::msg::Range>("sonar", [this](const auto& m) {
      RCLCPP_INFO(get_logger(), "sonar in %s: %d, %.2f rad, %.3f m", m.header.frame_id.c_str(), m.radiation_type, m.field_of_view, m.range);
    });
    timer_ = create_timer(std::chrono::milliseconds(100), [this, kinds] {
      if (heard_.size() != kinds) return;
      RCLCPP_INFO(get_logger(), "%zu sensors were heard", kinds);
      timer_->cancel();
    });
  }

 private:
  template <typename Message, typename Say>
  void hear(const std::string& topic, Say say) {
    kept_.push_back(create_subscription<Message>(topic, 10, [this, topic, say](const Message& message) {
      if (rclcpp::Time(message.header.stamp).seconds() >= 2 && heard_.insert(topic).second) say(message);
    }));
  }

  std::set<std::string> heard_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> kept_;
  rclcpp::SubscriptionBase::SharedPtr hovers_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Listener>());
  rclcpp::shutdown();
}
`;

const bridged = [
  '/bumper@ros_gz_interfaces/msg/Contacts[gz.msgs.Contacts',
  '/hover@ros_gz_interfaces/msg/Contacts[gz.msgs.Contacts',
  '/world/yard/model/arm/joint/mount/sensor/cell/forcetorque@geometry_msgs/msg/WrenchStamped[gz.msgs.Wrench',
  '/fix@sensor_msgs/msg/NavSatFix[gz.msgs.NavSat',
  '/sonar@sensor_msgs/msg/Range[gz.msgs.LaserScan',
  '/magnetic@sensor_msgs/msg/MagneticField[gz.msgs.Magnetometer',
  '/pressure@sensor_msgs/msg/FluidPressure[gz.msgs.FluidPressure',
  '/height@ros_gz_interfaces/msg/Altimeter[gz.msgs.Altimeter',
  '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock',
];
const launch = (simulator: string, world: string, kinds: number, more = ''): string => `
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    world = PathJoinSubstitution([get_package_share_directory('yard'), LaunchConfiguration('world')])
    return LaunchDescription([
        DeclareLaunchArgument('world', default_value='${world}'),
        ExecuteProcess(cmd=[${simulator}, world], output='screen'),
        Node(package='yard', executable='listener', parameters=[{'use_sim_time': True, 'kinds': ${kinds}}], output='screen'),${more}
    ])
`;
const classicLaunch = launch(`'gzserver', '-s', 'libgazebo_ros_init.so'`, 'classic.world', 6);
const simLaunch = launch(`'gz', 'sim', '-r', '-s'`, 'sim.world', 7, `
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=${JSON.stringify(bridged)},
             remappings=[('/world/yard/model/arm/joint/mount/sensor/cell/forcetorque', '/wrench')]),`);

const messages = ['gazebo_msgs', 'geometry_msgs', 'ros_gz_interfaces', 'sensor_msgs'];
const cmake = `find_package(rclcpp REQUIRED)
${messages.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(listener rclcpp ${messages.join(' ')})
install(FILES classic.world sim.world bare.world classic.launch.py sim.launch.py DESTINATION share/\${PROJECT_NAME})
`;

const workspace = new PackWorkspace('shared');
before(async () => {
  workspace.addPackage('yard', { listener }, { cmake, depends: ['rclcpp', ...messages, 'gazebo_ros', 'ros_gz_sim', 'ros_gz_bridge'] });
  for (
    const [name, text] of Object.entries({
      'classic.world': classicWorld,
      'sim.world': simWorld,
      'bare.world': bareWorld,
      'classic.launch.py': classicLaunch,
      'sim.launch.py': simLaunch,
    })
  ) workspace.write(`src/yard/${name}`, text);
  for (const kind of ['classic', 'sim']) {
    workspace.write(`${kind}.yaml`, `schema: 1\nname: yard\npackages: [src/*]\nlaunch: src/yard/${kind}.launch.py\n`);
    const packed = await workspace.run(['pack', `${kind}.yaml`, '-o', kind]);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => {
  workspace.close();
});

async function consoleOf(site: string, end: string, ...more: readonly string[]): Promise<string> {
  const run = await workspace.run(['run', site, ...more, '--for', '60s', '--until', end]);
  assert.equal(run.code, 0, run.stdout + run.stderr);
  return run.stdout + run.stderr;
}

const [latitude, longitude] = stationOnEarth();
const fix = (frame: string): RegExp => {
  const number = (value: number): string => value.toFixed(7).replace('.', '\\.');
  return new RegExp(`fix in ${frame}: 0 ${number(latitude)} ${number(longitude)} 420\\.02$`, 'm');
};

test('Gazebo Classic: contacts, wrench, position and distance', watchdog, async () => {
  const said = await consoleOf('classic', 'sensors were heard');
  for (
    const line of [
      // 2 kg on four corners; the weight of 3 kg at 0.5 m.
      /contact in floor: 1, crate::body::shell on floor::l::c, 4 points, normal 1, 19\.60 N$/m,
      /the balloon touches 0$/m,
      /wrench in boom: -29\.40 N, 14\.70 N m$/m,
      fix('top'),
      /the stone falls 1\.00 times as it should$/m,
      /sonar in top: 0, 0\.20 rad, 2\.000 m$/m,
      /WARN.*\[crate\.crate_bumper\]: contact sensor \[bumper\]: the link \[body\] has no collision \[shel\]: did you mean \[shell\]\?$/m,
      /ERROR.*\[lost\]: Joint \[moun\] does not exist\. Aborting; did you mean \[mount\]\?$/m,
      /ERROR.*plugin \[astray\] \(libgazebo_ros_gps_sensor\.so\) does not work here: it must be inside a <sensor> of a link$/m,
    ]
  ) assert.match(said, line);
});

test('Gazebo Sim: contacts, wrench, position, height, field, pressure and distance', watchdog, async () => {
  const said = await consoleOf('sim', 'sensors were heard');
  for (
    const line of [
      /contact in : 1, crate::body::shell on floor::l::c, 4 points, normal 1, 19\.60 N$/m,
      /wrench in arm\/mount\/cell: -29\.40 N, 14\.70 N m$/m,
      fix('station/top/gps'),
      /height in stone\/body\/height: 1\.00 and 1\.00 times as it should, from 2000$/m,
      /field: 2\.0 -1\.0 -40\.0 uT$/m,
      /pressure: 898\.8 hPa$/m, // at 1000 m
      /sonar in station\/top\/sonar: 0, 0\.20 rad, 2\.000 m$/m,
      /WARN.*contact sensor \[bumper\]: the link \[body\] has no collision \[shel\]: did you mean \[shell\]\?$/m,
    ]
  ) assert.match(said, line);
  assert.doesNotMatch(said, /nothing touches|is skipped|is silent/);
});

test('Gazebo Sim: without its system a sensor is silent, and the line that the world lacks is printed', watchdog, async () => {
  const said = await consoleOf('sim', 'type \\[altimeter\\] is silent', 'world:=bare.world');
  assert.match(said, /sensor \[gps\] of type \[navsat\] is silent: the world lacks <spherical_coordinates>/);
  for (const [type, name, library] of needed.filter(([kind]) => kind !== 'navsat'))
    assert.match(said, new RegExp(
      `sensor \\[\\w+\\] of type \\[${type}\\] is silent: the world lacks <plugin filename="gz-sim-${library}-system" name="gz::sim::systems::${name}"/>$`,
      'm',
    ));
});

test('two stepped runs of a seed sense the same', watchdog, async () => {
  const traces = [];
  for (const name of ['first.trace', 'second.trace']) {
    const run = await workspace.run(['run', 'sim', '--stepped', '--seed', '7', '--for', '3s', '--trace', name]);
    traces.push(/^trace: \d+ messages, sha256 \w+$/m.exec(run.stderr)?.[0] ?? assert.fail(run.stdout + run.stderr));
  }
  assert.equal(traces[0], traces[1]);
});
