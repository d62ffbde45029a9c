"""What launch files in Python said is kept, and stands while all that they looked at is as it was.

Whether Python was asked shows in the words: what is kept is changed by hand, so that it says something else.
"""
from __future__ import annotations

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

CLI = Path(os.environ.get('ROS2WASM_CLI', 'build/ros2wasm')).resolve()
PACKAGE = """<package format="3"><name>demo</name><version>1.2.3</version><description>A package of a test</description>
<maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license></package>
"""
LAUNCH = """
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import FileContent, LaunchConfiguration
from launch_ros.actions import Node

here = os.path.dirname(__file__)


def nodes(context):
    print('python speaks of', LaunchConfiguration('robot').perform(context))
    with open(os.path.join(here, 'names.txt')) as names:
        return [Node(package='demo', executable='talker', name=name.strip()) for name in names]


def generate_launch_description():
    said = ', '.join(sorted(os.listdir(here))) + (' and more' if os.path.exists('/workspace/more') else '')
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='one'), OpaqueFunction(function=nodes), LogInfo(msg=said),
        LogInfo(msg=FileContent(os.path.join(here, 'note.txt')))])
"""


class Kept(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        files = {'demo/package.xml': PACKAGE, 'demo/launch/all.launch.py': LAUNCH, 'demo/launch/names.txt': 'n1\n',
                 'demo/launch/note.txt': 'noted', 'elsewhere.txt': 'x'}
        for name, text in files.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text, encoding='utf-8')

    def launch(self, *given: str) -> str:
        environment = {**os.environ, 'XDG_CACHE_HOME': str(self.folder / '.cache')}
        result = subprocess.run([str(CLI), 'launch', 'demo/launch/all.launch.py', *given], cwd=self.folder,
                                env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def pack(self) -> str:
        """What the site says of its launch file."""
        environment = {**os.environ, 'XDG_CACHE_HOME': str(self.folder / '.cache')}
        result = subprocess.run([str(CLI), 'pack', '-o', 'site'], cwd=self.folder, env=environment, capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.dumps(json.loads((self.folder / 'site/site.json').read_bytes())['launch'])

    def kept(self) -> list[Path]:
        return sorted((self.folder / '.cache/ros2wasm/launch').glob('*/*.json'))

    def forge(self) -> None:
        """Makes what is kept tell its reader from Python."""
        for path in self.kept():
            text = path.read_text(encoding='utf-8')
            path.write_text(text.replace('python speaks', 'memory speaks'), encoding='utf-8')

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text, encoding='utf-8')

    def test_stands_until_something_changes_that_was_looked_at(self) -> None:
        first = self.launch()
        self.assertIn('python speaks of one', first)
        self.assertEqual(len(self.kept()), 1)
        self.forge()
        self.assertEqual(self.launch(), first.replace('python', 'memory'))
        # Nobody looked at that.
        self.write('elsewhere.txt', 'y')
        self.write('demo/notes.txt', 'new')
        self.assertIn('memory speaks', self.launch())
        changes = (
            ('demo/launch/names.txt', 'n2\n', 'n2'),  # read
            ('demo/launch/added.txt', '', 'added.txt'),  # in a folder that was listed
            ('more', '', 'and more'),  # looked for in vain
            ('demo/launch/all.launch.py', LAUNCH.replace("'talker'", "'other'"), 'demo/other'),
        )
        for name, text, expected in changes:
            with self.subTest(name):
                self.forge()
                self.write(name, text)
                now = self.launch()
                self.assertIn('python speaks', now)
                self.assertIn(expected, now)
                self.forge()
                self.assertEqual(self.launch(), now.replace('python', 'memory'))

    def test_what_others_say_in_between_counts(self) -> None:
        self.launch()
        self.forge()
        # Read by the evaluation, not by Python, which saw its name and size only.
        self.write('demo/launch/note.txt', 'Noted')
        now = self.launch()
        self.assertIn('memory speaks', now)
        self.assertIn('Noted', now)

    def test_arguments_have_memories_of_their_own(self) -> None:
        self.launch()
        self.assertIn('python speaks of two', self.launch('robot:=two'))
        self.assertEqual(len(self.kept()), 2)
        self.forge()
        self.assertIn('memory speaks of one', self.launch())
        self.assertIn('memory speaks of two', self.launch('robot:=two'))

    def test_prune_takes_what_nobody_asked_for_in_a_month(self) -> None:
        self.launch()
        [used] = self.kept()
        self.launch('robot:=two')
        long_ago = used.stat().st_mtime - 40 * 24 * 3600
        for path in self.kept():
            os.utime(path, (long_ago, long_ago))
        self.launch()
        environment = {**os.environ, 'XDG_CACHE_HOME': str(self.folder / '.cache')}
        subprocess.run([str(CLI), 'cache', 'prune'], env=environment, capture_output=True, check=True)
        self.assertEqual(self.kept(), [used])

    def test_what_is_damaged_is_made_again(self) -> None:
        first = self.launch()
        [path] = self.kept()
        whole = path.read_text(encoding='utf-8')
        for text in ('', whole[:200], whole.replace('"asked"', '"questions"')):
            path.write_text(text, encoding='utf-8')
            self.assertEqual(self.launch(), first)
            self.assertEqual(path.read_text(encoding='utf-8'), whole)

    def test_a_rebuild_of_what_nobody_looked_at_changes_nothing(self) -> None:
        for name, text in {
            'workspace.yaml': 'schema: 1\nname: kept\nversion: 1.0.0\nlicense: Apache-2.0\ndistro: jazzy\n'
                              'packages: [demo]\nlaunch: demo/launch/all.launch.py\n',
            'demo/package.xml': PACKAGE.replace(
                '</package>', '<exec_depend>rclpy</exec_depend>'
                              '<export><build_type>ament_python</build_type></export></package>'),
            'demo/setup.py': "from setuptools import setup\nsetup(name='demo', version='1.2.3', packages=['demo'], "
                             "data_files=[('share/demo', ['package.xml'])], "
                             "entry_points={'console_scripts': ['talker = demo.talker:main']})\n",
            'demo/setup.cfg': '[develop]\nscript_dir=$base/lib/demo\n[install]\ninstall_scripts=$base/lib/demo\n',
            'demo/demo/__init__.py': '', 'demo/demo/talker.py': 'def main():\n    pass\n',
        }.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            self.write(name, text)
        self.assertIn('python speaks', self.pack())
        first = self.kept()
        self.assertEqual(len(first), 1)
        self.forge()
        # It is built anew, in another folder.
        self.write('demo/demo/talker.py', 'def main():\n    print("more")\n')
        self.assertIn('memory speaks', self.pack())
        self.assertEqual(self.kept(), first)
        self.write('demo/launch/names.txt', 'n2\n')
        self.assertIn('python speaks', self.pack())
        self.assertEqual(self.kept(), first)


if __name__ == '__main__':
    unittest.main()
