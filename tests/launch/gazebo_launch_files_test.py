"""The launch files of gazebo_ros and ros_gz_sim: their arguments become those of the simulator, and paths that packages
export become its environment."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Any

CLI = Path(os.environ.get('ROS2WASM_CLI', 'build/ros2wasm')).resolve()
PACKAGES = Path('runtime/packages/sim')
PACKAGE = """<package format="3"><name>demo</name><version>1.2.3</version><description>A package of a test</description>
<maintainer email="someone@example.org">S\xf8ren</maintainer><license>Apache-2.0</license><export>
<gazebo_ros
  gazebo_model_path="${prefix}/models"/></export></package>
"""
TEXT = '<sdf version="1.9"><world name="a"/></sdf>'


class GazeboLaunchFiles(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name in ('gazebo_ros', 'ros_gz_sim'):
            shutil.copytree(PACKAGES / name, self.folder / name)
        (self.folder / 'demo').mkdir()
        (self.folder / 'demo/package.xml').write_text(PACKAGE, encoding='utf-8')

    def processes(self, file: str, *given: str) -> list[dict[str, Any]]:
        environment = {**os.environ, 'XDG_CACHE_HOME': str(self.folder / '.cache')}
        result = subprocess.run([str(CLI), '--json', 'launch', file, *given], cwd=self.folder, env=environment,
                                capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        found: list[dict[str, Any]] = json.loads(result.stdout.splitlines()[0])['processes']
        return found

    def test_the_server_of_classic_has_the_factory_and_the_paths(self) -> None:
        found = self.processes('gazebo_ros/launch/gazebo.launch.py', 'world:=a.world', 'force_system:=no', 'seed:=3')
        self.assertEqual([one['executable'] for one in found], ['gzserver'])
        self.assertEqual(found[0]['arguments'], ['a.world', '-s', 'libgazebo_ros_init.so',
                                                 '-s', 'libgazebo_ros_factory.so', '--seed', '3'])
        self.assertTrue(found[0]['environment']['GAZEBO_MODEL_PATH'].endswith('/share/demo/models'))

    def test_arguments_of_sim_may_have_quotes(self) -> None:
        for name in ('gz_args', 'ign_args'):
            found = self.processes('ros_gz_sim/launch/gz_sim.launch.py', f'{name}:=-r "my world.sdf"')
            self.assertEqual([one['arguments'] for one in found], [['-r', 'my world.sdf', '--force-version', '8']])
            self.assertTrue(found[0]['environment']['GZ_SIM_RESOURCE_PATH'].endswith('/share/demo/models'))

    def test_a_client_is_no_process(self) -> None:
        self.assertEqual(self.processes('ros_gz_sim/launch/gz_sim.launch.py', 'gz_args:=-g -v2'), [])

    def test_a_server_has_a_file_or_a_text(self) -> None:
        file = 'ros_gz_sim/launch/gz_server.launch.py'
        for given, world in ((['world_sdf_file:=a b.sdf'], ['a b.sdf']),
                             ([f'world_sdf_string:={TEXT}'], ['--sdf-string', TEXT]),
                             (['world_sdf_file:=a.sdf', f'world_sdf_string:={TEXT}'], ['a.sdf'])):
            found = self.processes(file, *given)
            self.assertEqual([one['arguments'] for one in found],
                             [['-r', '-s', '-v', '4', '--simulation-interfaces', '--initial-sim-time', '0.0', *world]])
        self.assertEqual(self.processes(file), [])


if __name__ == '__main__':
    unittest.main()
