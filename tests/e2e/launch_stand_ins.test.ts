// A launch file that starts rviz2 and joint_state_publisher_gui: the site opens its own panels in their place.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from './pack_workspace.ts';

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
  assert.match(packed.stderr, /warning\[R2W0415\]: `joint_state_publisher_gui\/joint_state_publisher_gui` is left out of the site\n(?:.*\n)*?.*= why: the panel Joints of the page stands in for it/);
  const { ui } = JSON.parse(ws.read('site/site.json').toString()) as { ui: { opens: unknown } };
  assert.deepEqual(ui.opens, [{ panel: 'joints' }, { panel: 'scene', file: 'share/arm/rviz/view.rviz' }]);
  assert.ok(ws.files('site').has('share/arm/rviz/view.rviz'));
});
