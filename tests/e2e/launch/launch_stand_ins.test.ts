// A launch file that starts rviz2 and joint_state_publisher_gui: the site opens its own panels in their place.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
  ws.addPackage('arm', { hello: 'int main() {}\n' }, { cmake: 'install(DIRECTORY launch rviz DESTINATION share/${PROJECT_NAME})\n' });
  ws.write('src/arm/rviz/view.rviz', 'Visualization Manager:\n  Displays:\n    - {Class: rviz_default_plugins/TF, Enabled: true, Name: TF}\n');
  ws.write('src/arm/launch/view.launch.xml', `<launch>
  <node pkg="arm" exec="hello"/>
  <node pkg="joint_state_publisher_gui" exec="joint_state_publisher_gui"/>
  <node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share arm)/rviz/view.rviz"/>
  <node pkg="rviz2" exec="rviz2" name="again" args="-d /nowhere/else.rviz"/>
</launch>
`);
  ws.write('workspace.yaml', 'schema: 1\nname: arm\npackages: [src/*]\nlaunch: src/arm/launch/view.launch.xml\n');
});

after(() => ws.close());

// Compatibility, works: a launch file's rviz2 opens the 3D view with its `-d` file, joint_state_publisher_gui the panel Joints
test('rviz2 and joint_state_publisher_gui become panels of the usual layout', async () => {
  const packed = await ws.run(['pack', 'workspace.yaml', '-o', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr,
    /note\[R2W0415\]: `joint_state_publisher_gui\/joint_state_publisher_gui` is not started: the panel Joints of the page replaces it/);
  const { ui } = JSON.parse(ws.read('site/site.json').toString()) as { ui: { opens: unknown; }; };
  assert.deepEqual(ui.opens, [{ panel: 'joints' }, { panel: 'scene', file: 'share/arm/rviz/view.rviz' }]);
  assert.ok(ws.files('site').has('share/arm/rviz/view.rviz'));
});

// Compatibility, works: a launch file that starts rviz2 alone: a site with the 3D view
test('a launch file with only rviz2 is a site that shows the 3D view', async () => {
  ws.write('src/arm/launch/look.launch.xml', '<launch>\n  <node pkg="rviz2" exec="rviz2" args="-d $(find-pkg-share arm)/rviz/view.rviz"/>\n</launch>\n');
  ws.write('look.yaml', 'schema: 1\nname: look\npackages: [src/*]\nlaunch: src/arm/launch/look.launch.xml\n');
  const packed = await ws.run(['pack', 'look.yaml', '-o', 'look']);
  assert.equal(packed.code, 0, packed.stderr);
  const { ui, nodes } = JSON.parse(ws.read('look/site.json').toString()) as { ui: { opens: unknown; }; nodes: unknown[]; };
  assert.deepEqual(nodes, []);
  assert.deepEqual(ui.opens, [{ panel: 'scene', file: 'share/arm/rviz/view.rviz' }]);
  const ran = await ws.run(['run', 'look', '--for', '1s']);
  assert.equal(ran.code, 0, ran.stderr);
  // One that starts only what nothing stands in for is still refused.
  ws.write('src/arm/launch/nothing.launch.xml', '<launch>\n  <node pkg="rplidar_ros" exec="rplidar_node"/>\n</launch>\n');
  ws.write('nothing.yaml', 'schema: 1\nname: nothing\npackages: [src/*]\nlaunch: src/arm/launch/nothing.launch.xml\n');
  const refused = await ws.run(['pack', 'nothing.yaml', '-o', 'nothing']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0406\]/);
});

// Compatibility, works: `urdf_launch` (display.launch.py, description.launch.py), which packages of robots include
test("display.launch.py of urdf_launch shows a package's robot", async () => {
  const shown = new PackWorkspace();
  try {
    shown.addPackage('leg', { hello: 'int main() {}\n' }, { cmake: 'install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\n' });
    shown.write('src/leg/urdf/leg.urdf', '<robot name="leg"><link name="base_link"/></robot>\n');
    shown.write('src/leg/launch/display.launch.py', `from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([IncludeLaunchDescription(
        PathJoinSubstitution([FindPackageShare('urdf_launch'), 'launch', 'display.launch.py']),
        launch_arguments={'urdf_package': 'leg', 'urdf_package_path': 'urdf/leg.urdf'}.items())])
`);
    shown.write('workspace.yaml', 'schema: 1\nname: leg\npackages: [src/*]\nlaunch: src/leg/launch/display.launch.py\n');
    const packed = await shown.run(['pack', 'workspace.yaml', '-o', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    const { ui, nodes } = JSON.parse(shown.read('site/site.json').toString()) as {
      ui: { opens: unknown; };
      nodes: { executable: string; arguments: string[]; }[];
    };
    assert.deepEqual(ui.opens, [{ panel: 'joints' }, { panel: 'scene', file: 'share/urdf_launch/config/urdf.rviz' }]);
    assert.deepEqual(nodes.map(({ executable }) => executable), ['robot_state_publisher']);
    assert.ok(nodes[0]?.arguments.some((one) => one.includes('base_link')), 'the description');
  } finally {
    shown.close();
  }
});
