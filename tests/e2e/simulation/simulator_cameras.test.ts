// Cameras of both simulators: a node looks at a red box, 20 cm wide and 2 m away, whose place, size, distance and brightness
// follow from the formulas of a pinhole camera and of Lambert's law. The pictures have the same bytes in Node.js and Chromium.

// Compatibility, works: simulated cameras: colour, depth and RGB-D, `camera_info`, point clouds, JPEG (`image_raw/compressed` of
// Gazebo Classic), several cameras of a sensor, noise, lights, textures (PNG, JPEG, BMP, TGA), colours of COLLADA and OBJ files

// Compatibility, differs: pictures of simulated cameras -> drawn without shadows, reflections and lens distortion; the same bytes
// on every machine

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const camera = (more = ''): string =>
  `<camera name="eye">${more}<horizontal_fov>1.047</horizontal_fov>
  <image><width>640</width><height>480</height><format>R8G8B8</format></image><clip><near>0.1</near><far>50</far></clip></camera>`;
const visual = (geometry: string, material: string): string =>
  `<link name="l"><visual name="v"><geometry>${geometry}</geometry>
  <material>${material}</material></visual></link>`;
const still = (name: string, pose: string, inner: string): string => `<model name="${name}"><static>true</static><pose>${pose}</pose>${inner}</model>`;
const cube = (size: string): string => `<box><size>${size}</size></box>`;
const colors = (color: string): string => `<ambient>${color}</ambient><diffuse>${color}</diffuse>`;

/** A wall of 0.5 grey 4 m ahead, a red box 2 m ahead, and a picture on the floor. */
const scene = `
  <light name="sun" type="directional"><pose>0 0 10 0 0 0</pose><diffuse>0.8 0.8 0.8 1</diffuse><direction>0.6 0 -0.8</direction></light>
  ${still('wall', '4.1 0 0 0 0 0', visual(cube('0.2 20 20'), colors('0.5 0.5 0.5 1')))}
  ${still('cube', '2 0 1 0 0 0', visual(cube('0.2 0.2 0.2'), colors('1 0 0 1')))}
  ${
  still('floor', '0 0 0 0 0 0',
    visual('<plane><normal>0 0 1</normal><size>4 4</size></plane>', '<pbr><metal><albedo_map>model://eyes/four.bmp</albedo_map></metal></pbr>'))
}`;

const classic = `<sdf version="1.6"><world name="room">${scene}
  ${
  still('eyes', '0 0 1 0 0 0', `<link name="head">
    <sensor name="one" type="camera"><update_rate>10</update_rate>${camera()}<plugin name="one" filename="libgazebo_ros_camera.so">
      <camera_name>front</camera_name><frame_name>front_optical</frame_name></plugin></sensor>
    <sensor name="deep" type="depth"><update_rate>10</update_rate>${camera()}<plugin name="deep" filename="libgazebo_ros_camera.so">
      <ros><namespace>robot</namespace></ros><frame_name>deep_optical</frame_name></plugin></sensor>
    <sensor name="pair" type="multicamera"><update_rate>10</update_rate>${camera()}${
    camera('<pose>0 -0.1 0 0 0 0</pose>')
      .replace('eye', 'right')
  }<plugin name="pair" filename="libgazebo_ros_camera.so"/></sensor></link>`)
}
</world></sdf>
`;
const systems = ['Physics', 'Sensors', 'SceneBroadcaster']
  .map((name) => `<plugin filename="gz-sim-${name.toLowerCase()}-system" name="gz::sim::systems::${name}"/>`).join('');
const sim = `<sdf version="1.9"><world name="room">${systems}${scene}
  ${
  still('eyes', '0 0 1 0 0 0', `<link name="head">
    <sensor name="one" type="camera"><topic>front/image_raw</topic><update_rate>10</update_rate>
      ${camera('<optical_frame_id>front_optical</optical_frame_id>')}</sensor>
    <sensor name="deep" type="rgbd_camera"><topic>robot/deep</topic><update_rate>10</update_rate>${camera()}</sensor></link>`)
}
</world></sdf>
`;

/** Describes the first message of each topic, in a line. */
const looker = `
import struct
import sys
import zlib

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2


class Looker(Node):
    def __init__(self, topics):
        super().__init__('looker')
        self.left = set(topics)
        self.kept = [self.create_subscription(kind, topic, lambda m, t=topic: self.seen(t, m), qos_profile_sensor_data)
                     for topic, kind in topics.items()]

    def seen(self, topic, message):
        if topic not in self.left:
            return
        self.left.discard(topic)
        self.get_logger().info(f'{topic} ({message.header.frame_id}): {self.describe(message)}')
        if not self.left:
            self.get_logger().info('seen all')

    def describe(self, m):
        if isinstance(m, CameraInfo):
            return f'{m.width} x {m.height}, f {m.k[0]:.1f}, c {m.k[2]} {m.k[5]}, {m.distortion_model} {list(m.d)}'
        if isinstance(m, CompressedImage):
            return f'{m.format}, {bytes(m.data[:2]).hex()}'
        data = bytes(m.data)
        if isinstance(m, PointCloud2):
            x, y, z = struct.unpack_from('<fff', data, 240 * m.row_step + 320 * m.point_step)
            return f'{m.width} x {m.height}, {[f.name for f in m.fields]}, {m.point_step}, middle {x:.3f} {y:.3f} {z:.3f}'
        if m.encoding == '32FC1':
            middle, corner = (struct.unpack_from('<f', data, row * m.step + 4 * column)[0] for row, column in ((240, 320), (5, 5)))
            return f'{m.width} x {m.height}, middle {middle:.3f}, corner {corner:.3f}, crc {zlib.crc32(data):08x}'
        pixel = [tuple(data[row * m.step + 3 * column:row * m.step + 3 * column + 3]) for row, column in ((240, 320), (5, 5))]
        red = [i for i in range(0, len(data), 3) if data[i] > 4 * data[i + 1] and data[i + 2] == 0 and i < 300 * m.step]
        columns = [i % m.step // 3 for i in red]
        return (f'{m.encoding}, middle {pixel[0]}, corner {pixel[1]}, red from {min(columns)} to {max(columns)}, '
                f'crc {zlib.crc32(data):08x}')


rclpy.init(args=sys.argv)
rclpy.spin(Looker(TOPICS))
`;
const topics = {
  classic: `{'/front/image_raw': Image, '/front/camera_info': CameraInfo, '/front/image_raw/compressed': CompressedImage,
          '/robot/deep/depth/image_raw': Image, '/robot/deep/points': PointCloud2, '/pair/right/image_raw': Image}`,
  sim: "{'/front/image_raw': Image, '/front/camera_info': CameraInfo, '/robot/deep/depth_image': Image, '/robot/deep/points': PointCloud2}",
};

const launch = (simulator: string): string => `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('eyes')
    return LaunchDescription([
        ${simulator}
        Node(package='eyes', executable='looker.py', output='screen'),
    ])
`;
const launches = {
  classic: launch(`IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gzserver.launch.py')),
            launch_arguments={'world': os.path.join(share, 'room.world')}.items()),`),
  sim: launch(`IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_sim.launch.py')),
            launch_arguments={'gz_args': '-r -s ' + os.path.join(share, 'room.world')}.items()),
        Node(package='ros_gz_image', executable='image_bridge', arguments=['/front/image_raw']),
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/front/camera_info@sensor_msgs/msg/CameraInfo[gz.msgs.CameraInfo',
            '/robot/deep/depth_image@sensor_msgs/msg/Image[gz.msgs.Image',
            '/robot/deep/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked']),`),
};

/** A file of the BMP format: red and green above, blue and white below. */
function fourColors(): Buffer {
  const file = Buffer.alloc(70);
  file.write('BM');
  for (const [at, value] of [[2, 70], [10, 54], [14, 40], [18, 2], [22, 2], [34, 16]] as const) file.writeUInt32LE(value, at);
  file.writeUInt16LE(1, 26);
  file.writeUInt16LE(24, 28);
  Buffer.from('ff0000ffffff00000000ff00ff000000', 'hex').copy(file, 54); // from below, blue first
  return file;
}

// The wall and the box look along -x, so Lambert's factor is 0.6: 255 (0.4 ambient + 0.8 diffuse * 0.6). The box is seen 55 or 56
// pixels wide: 554.4 * 0.2 / (2 - 0.1) = 58.4.
const front = String.raw`rgb8, middle \(224, 0, 0\), corner \(112, 112, 112\), red from 291 to 348, crc (\w+)`;
const said: Record<'classic' | 'sim', readonly RegExp[]> = {
  classic: [
    new RegExp(String.raw`/front/image_raw \(front_optical\): ${front}$`, 'm'),
    /\/front\/camera_info \(front_optical\): 640 x 480, f 554\.4, c 320\.5 240\.5, plumb_bob \[0\.0, 0\.0, 0\.0, 0\.0, 0\.0\]$/m,
    /\/front\/image_raw\/compressed \(front_optical\): rgb8; jpeg compressed bgr8, ffd8$/m,
    /\/robot\/deep\/depth\/image_raw \(deep_optical\): 640 x 480, middle 1\.900, corner 4\.000, crc (\w+)$/m,
    // Right and down are half a pixel: 1.9 / (2 * 554.4).
    /\/robot\/deep\/points \(deep_optical\): 640 x 480, \['x', 'y', 'z', 'rgb'\], 32, middle 0\.002 0\.002 1\.900$/m,
    // From 10 cm to the right the box is 554.4 * 0.1 / 1.9 = 29 pixels further to the left.
    /\/pair\/right\/image_raw \(head\): rgb8, middle .*, red from 262 to 319, crc (\w+)$/m,
  ],
  sim: [
    new RegExp(String.raw`/front/image_raw \(front_optical\): ${front}$`, 'm'),
    /\/front\/camera_info \(front_optical\): 640 x 480, f 554\.4, c 320\.0 240\.0, plumb_bob \[0\.0, 0\.0, 0\.0, 0\.0, 0\.0\]$/m,
    /\/robot\/deep\/depth_image \(eyes\/head\/deep\): 640 x 480, middle 1\.900, corner 4\.000, crc (\w+)$/m,
    /\/robot\/deep\/points \(eyes\/head\/deep\): 640 x 480, \['x', 'y', 'z', 'rgb'\], 24, middle 1\.900 -0\.002 -0\.002$/m,
  ],
};

const kinds = ['classic', 'sim'] as const;
const workspaces = new Map<string, PackWorkspace>();
/** The checksums of pictures by kind: the same wherever the site runs. */
const pictures = new Map<string, string>();

before(async () => {
  for (const kind of kinds) {
    const workspace = new PackWorkspace('shared');
    workspaces.set(kind, workspace);
    workspace.addPackage('eyes', {}, {
      cmake: `install(PROGRAMS looker.py DESTINATION lib/\${PROJECT_NAME})
install(FILES room.world four.bmp sim.launch.py DESTINATION share/\${PROJECT_NAME})
`,
      depends: ['rclpy', 'sensor_msgs', ...(kind === 'classic' ? ['gazebo_ros'] : ['ros_gz_sim', 'ros_gz_bridge', 'ros_gz_image'])],
    });
    workspace.write('src/eyes/looker.py', `#!/usr/bin/env python3${looker.replace('TOPICS', topics[kind])}`);
    workspace.write('src/eyes/room.world', kind === 'classic' ? classic : sim);
    workspace.write('src/eyes/four.bmp', fourColors());
    workspace.write('src/eyes/sim.launch.py', launches[kind]);
    workspace.write('workspace.yaml', 'schema: 1\nname: eyes\npackages: [src/*]\nlaunch: src/eyes/sim.launch.py\n');
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => {
  for (const workspace of workspaces.values()) workspace.close();
});

function check(kind: 'classic' | 'sim', output: string): void {
  const sums = said[kind].map((line) => (line.exec(output) ?? assert.fail(`${line}\n${output}`))[1] ?? '').join(' ');
  assert.equal(sums, pictures.get(kind) ?? sums);
  pictures.set(kind, sums);
}

for (const [index, kind] of kinds.entries()) {
  const workspace = (): PackWorkspace => workspaces.get(kind) ?? assert.fail();
  for (const link of index === 0 ? played('shared', 'port') : played('port', 'shared'))
    test(`${kind}, Node.js, ${link}: a camera sees what its formulas say`, watchdog, async () => {
      const run = await workspace().run(['run', 'site', '--link', link, '--for', '120s', '--until', 'seen all']);
      assert.equal(run.code, 0, run.stdout + run.stderr);
      check(kind, run.stdout);
    });

  test(`${kind}, Chromium: the pictures have the same bytes`, watchdog, async () => {
    const browser = await chromium.launch(chromiumOptions());
    const server = await serveFolder(join(workspace().root, 'site'), { isolated: true });
    try {
      const page = await browser.newPage();
      await page.goto(server.url);
      await page.getByText('seen all').first().waitFor({ timeout: 120_000 });
      check(kind, await page.locator('body').innerText());
    } finally {
      await browser.close();
      server.close();
    }
  });
}
