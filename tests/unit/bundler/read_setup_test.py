"""What setup.py and setup.cfg say, as templates/python/read_setup.py reads them; here in the Python of the tests."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

TEMPLATES = Path(__file__).resolve().parents[3] / 'templates/python'
SETUP = 'from setuptools import setup\nsetup()\n'


class ReadSetupTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.package = Path(folder.name, 'package')
        self.write('setup.py', SETUP)

    def write(self, path: str, text: str = '') -> None:
        file = self.package / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def read(self) -> dict[str, Any]:
        program = 'import sys, read_setup; read_setup.WORKSPACE = sys.argv[2]; print(read_setup.read(sys.argv[1]))'
        path = os.pathsep.join([str(TEMPLATES / 'stand_in'), str(TEMPLATES)])
        done = subprocess.run(
            [sys.executable, '-B', '-c', program, str(self.package), str(self.package.parent / 'workspace')],
            capture_output=True, text=True, check=True, env={'PYTHONPATH': path})
        result: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
        return result

    def failure(self) -> tuple[str, int, str]:
        error = self.read()['error']
        return error['file'], error['line'], error['message']

    def version(self, value: str, package_dir: str = '') -> str:
        self.write('setup.cfg', f'[metadata]\nname = demo\nversion = {value}\n[options]\n{package_dir}')
        return str(self.read()['version'])

    def test_a_version_of_a_file_is_what_the_file_says(self) -> None:
        self.write('VERSION', '1.4.2\n')
        self.assertEqual(self.version('file: VERSION'), '1.4.2')
        self.write('setup.cfg', '[metadata]\nversion = file: GONE\n')
        self.assertEqual(self.failure()[2], "can't copy 'GONE': doesn't exist or not a regular file")

    def test_a_keyword_that_setup_does_not_have_is_named_with_its_line(self) -> None:
        self.write('setup.py', 'from setuptools import setup\nsetup(name="demo", zip_safe=True,\n'
                               '      entry_pints={},\n      **{"install_require": []})\n')
        self.assertEqual(self.read()['unknown'], [
            {'keyword': 'entry_pints', 'line': 3}, {'keyword': 'install_require', 'line': 4}])
        self.write('setup.py', SETUP)
        self.assertEqual(self.read()['unknown'], [])

    def test_a_version_of_an_attribute_is_read_off_the_module(self) -> None:
        self.write('demo/__init__.py', 'import rclpy\n__version__ = "0.1"\n__version__: str = "2.5"\n')
        self.assertEqual(self.version('attr: demo.__version__'), '2.5')  # rclpy is not there to be imported
        self.write('src/demo/facts.py', 'VERSION = (3, 1)\n')
        self.assertEqual(self.version('attr: demo.facts.VERSION', 'package_dir =\n  = src\n'), '3.1')

    def test_a_version_that_is_computed_is_asked_for_by_importing(self) -> None:
        self.write('demo/__init__.py', '__version__ = ".".join(["4", "2"])\n')
        self.assertEqual(self.version('attr: demo.__version__'), '4.2')
        self.write('demo/__init__.py', 'import never_there\n__version__ = ".".join(["4", "2"])\n')
        self.assertEqual(self.failure(), (
            'demo/__init__.py', 1, "ModuleNotFoundError: No module named 'never_there'"))

    def test_setup_cfg_keeps_the_names_of_folders_and_packages(self) -> None:
        self.write('demo_nodes/Data-Set.txt')
        self.write('Maps/Room-1.yaml')
        self.write('demo_nodes/__init__.py')
        self.write('setup.cfg', """[metadata]
Name = demo
[options]
packages = demo_nodes
[options.package_data]
demo_nodes = *.txt
[options.data_files]
share/Demo-Maps = Maps/Room-1.yaml
[options.entry_points]
demo-Group = a = demo.a
[develop]
script-dir=$base/lib/demo
""")
        plan = self.read()
        self.assertEqual(plan['data'], [['Maps/Room-1.yaml', 'share/Demo-Maps/Room-1.yaml']])
        self.assertIn(['demo_nodes/Data-Set.txt', 'demo_nodes/Data-Set.txt'], plan['modules'])
        self.assertEqual(plan['entry_points'], {'demo-Group': ['a = demo.a']})
        self.assertEqual((plan['name'], plan['script_folder']), ('demo', 'lib/demo'))

    def test_paths_made_from_the_place_of_setup_py_are_of_the_package(self) -> None:
        for path in ('launch/all.launch.py', 'tools/run', 'demo/__init__.py', 'demo/table.csv'):
            self.write(path)
        self.write('setup.py', """import glob, os
from setuptools import setup
here = os.path.dirname(os.path.abspath(__file__))
setup(name='demo', packages=['demo'], package_dir={'demo': os.path.join(here, 'demo')},
      package_data={'demo': [os.path.join(here, 'demo', '*.csv')]},
      data_files=[('share/demo', glob.glob(os.path.join(here, 'launch', '*')))], scripts=[here + '/tools/run'])
""")
        plan = self.read()
        self.assertEqual(plan['data'], [['launch/all.launch.py', 'share/demo/all.launch.py']])
        self.assertEqual(plan['scripts'], [['tools/run', 'bin/run']])
        self.assertEqual(plan['modules'], [[path, path] for path in ('demo/__init__.py', 'demo/table.csv')])

    def test_what_setup_py_installs_by_itself_is_part_of_the_plan(self) -> None:
        self.write('setup.py', """import os, sys
from setuptools import setup
build = sys.argv[sys.argv.index('--build-base') + 1]
workspace, last, package, own = build.rsplit('/', 3)
assert (last, own) == ('build', 'build')
for name, text in {'lib/a.py': b'a = 1\\n', 'share/b/c.txt': 'é'.encode()}.items():
    path = os.path.join(workspace, 'install', package, name)
    os.makedirs(os.path.dirname(path))
    with open(path, 'wb') as stream:
        stream.write(text)
setup(name='demo')
""")
        self.assertEqual(self.read()['written'], [['lib/a.py', 'a = 1\n'], ['share/b/c.txt', 'é']])
        self.write('setup.py', (self.package / 'setup.py').read_text().replace("'é'.encode()", "b'\\xff'"))
        shutil.rmtree(self.package.parent / 'workspace')
        self.assertEqual(self.failure()[2], "it installs 'share/b/c.txt', which is not text")

    def selected(self, *lines: str) -> list[str]:
        """Files that are installed because MANIFEST.in says so."""
        self.write('MANIFEST.in', '\n'.join(lines) + '\n')
        return sorted(path for path, _ in self.read()['modules'] if path != 'demo/__init__.py')

    def test_each_command_of_manifest_in_selects_what_setuptools_selects(self) -> None:
        for path in ('demo/__init__.py', 'demo/a.csv', 'demo/b.txt', 'demo/.hidden', 'demo/maps/a.csv',
                     'demo/maps/old/b.csv', 'demo/maps/old/c.pgm', 'demo/.svn/entries', 'tests/a.csv'):
            self.write(path)
        self.write('setup.py', 'from setuptools import setup\n'
                   "setup(name='demo', packages=['demo'], include_package_data=True)\n")
        maps = ['demo/maps/a.csv', 'demo/maps/old/b.csv']
        # Right values are those of setuptools 65.5.
        self.assertEqual(self.selected('include demo/*.csv'), ['demo/a.csv'])
        self.assertEqual(self.selected('include demo/[a-b].*'), ['demo/a.csv', 'demo/b.txt'])
        self.assertEqual(self.selected('recursive-include demo *.csv'), ['demo/a.csv', *maps])
        self.assertEqual(self.selected('global-include *.csv'), ['demo/a.csv', *maps])
        self.assertEqual(self.selected('graft demo/maps/'), [*maps, 'demo/maps/old/c.pgm'])
        self.assertEqual(self.selected('graft demo', 'exclude demo/*.csv'),
                         ['demo/.hidden', 'demo/b.txt', *maps, 'demo/maps/old/c.pgm'])
        self.assertEqual(self.selected('graft demo/maps', 'recursive-exclude demo *.csv'), ['demo/maps/old/c.pgm'])
        self.assertEqual(self.selected('graft demo', 'global-exclude *.csv .*'), ['demo/b.txt', 'demo/maps/old/c.pgm'])
        self.assertEqual(self.selected('graft demo/maps', 'prune demo/maps/old'), ['demo/maps/a.csv'])
        # The order counts, comments and joined lines are as in setuptools.
        self.assertEqual(self.selected('prune demo/maps/old', 'graft demo/maps'), [*maps, 'demo/maps/old/c.pgm'])
        self.assertEqual(self.selected('# maps', 'recursive-include demo \\', '  *.pgm  # those', ''),
                         ['demo/maps/old/c.pgm'])
        self.assertEqual(self.read()['warnings'], [])

    def test_a_line_of_manifest_in_that_is_not_followed_is_named(self) -> None:
        self.write('demo/__init__.py')
        self.write('demo/a.csv')
        self.write('setup.py', 'from setuptools import setup\n'
                   "setup(name='demo', packages=['demo'], include_package_data=True)\n")
        selected = self.selected('include demo/*.csv', 'includes demo/*.txt', 'graft', 'prune a b')
        self.assertEqual(selected, ['demo/a.csv'])
        warnings = self.read()['warnings']
        self.assertEqual({one['file'] for one in warnings}, {'MANIFEST.in'})
        self.assertEqual([one['line'] for one in warnings], [2, 3, 4])
        self.assertIn('`includes` is not a command of MANIFEST.in', warnings[0]['message'])
        self.assertEqual(warnings[1]['message'], '`graft` expects one folder')

    def test_package_data_that_is_excluded_is_not_installed(self) -> None:
        for path in ('demo/__init__.py', 'demo/a.csv', 'demo/b.csv'):
            self.write(path)
        self.write('setup.py', "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
                   "      package_data={'demo': ['*.csv']}, exclude_package_data={'demo': ['b.*']})\n")
        self.assertEqual(self.read()['modules'], [[path, path] for path in ('demo/__init__.py', 'demo/a.csv')])

    def test_the_path_of_modules_is_as_before_whatever_an_imported_one_does_to_it(self) -> None:
        self.write('demo/__init__.py',
                   'import sys\nsys.path.insert(0, "/put/in/front")\n__version__ = ".".join(["4", "2"])\n')
        self.assertEqual(self.version('attr: demo.__version__'), '4.2')
        program = ('import os, sys; from read_setup import attribute; os.chdir(sys.argv[1]); before = list(sys.path); '
                   'attribute("demo.__version__", {}); print(sys.path == before)')
        done = subprocess.run([sys.executable, '-B', '-c', program, str(self.package)], capture_output=True, text=True,
                              check=True, env={'PYTHONPATH': str(TEMPLATES)})
        self.assertEqual(done.stdout, 'True\n')

    def test_an_end_by_sys_exit_is_told(self) -> None:
        self.write('setup.py', 'import sys\nsys.exit("needs a newer setuptools")\n')
        self.assertEqual(self.failure(), ('setup.py', 2, 'it ends itself: needs a newer setuptools'))
        self.write('setup.py', SETUP + 'import sys\nsys.exit(3)\n')
        self.assertEqual(self.failure(), ('setup.py', 4, 'it ends itself: exit code 3'))
        self.write('setup.py', SETUP + 'raise SystemExit(0)\n')
        self.assertEqual(self.read()['version'], '0.0.0')

    def test_commands_that_a_package_wraps_and_what_is_left_of_distutils(self) -> None:
        self.write('demo/__init__.py')
        self.write('setup.py', """import distutils.cmd
from distutils import log
from distutils.command.build_py import build_py
from distutils.core import setup
from distutils.util import convert_path, strtobool
from setuptools.command.develop import develop
from setuptools.command.install import install


def told(command):
    before = command.run

    def run(self):
        log.info('installs %s', self)
        before(self)

    command.run = run
    return command


@told
class Install(install):
    user_options = install.user_options + [('fast', None, 'at once')]


class Build(build_py):
    def finalize_options(self):
        build_py.finalize_options(self)


class Clean(distutils.cmd.Command):
    pass


if strtobool('yes'):
    setup(name='demo', packages=[convert_path('demo')],
          cmdclass={'install': Install, 'develop': told(develop), 'build_py': Build, 'clean': Clean})
""")
        self.assertEqual(self.read().get('modules'), [['demo/__init__.py', 'demo/__init__.py']])

    def test_what_is_imported_and_not_used_need_not_be_there(self) -> None:
        self.write('demo/__init__.py')
        self.write('setup.py', """
from nobody.has.this import depends
import nobody_either as short
from setuptools import setup
try:
    import nobody_at_all
    name = 'found'
except ImportError:
    name = 'demo'
setup(name=name, packages=['demo'])
""")
        self.assertEqual(self.read()['name'], 'demo')

    def test_what_is_used_and_not_there_is_named_where_it_is_used(self) -> None:
        self.write('demo/__init__.py')
        self.write('setup.py', """
from nobody.has.this import made
from setuptools import setup
setup(name='demo',
      packages=made(['demo']))
""")
        self.assertEqual(self.failure(), ('setup.py', 5, "ModuleNotFoundError: No module named 'nobody'"))

    def test_an_install_command_says_where_programs_go(self) -> None:
        self.write('demo/__init__.py')
        self.write('setup.py', """
import os
from setuptools import setup
from setuptools.command.install import install

def redirected(command):
    run = command.run
    def changed(self):
        self.install_scripts = os.path.abspath(os.path.join(self.install_scripts, os.pardir, 'lib', 'demo'))
        run(self)
    command.run = changed
    return command

@redirected
class Install(install):
    pass

setup(name='demo', packages=['demo'], cmdclass={'install': Install},
      entry_points={'console_scripts': ['talk = demo:main']})
""")
        self.assertEqual(self.read()['script_folder'], 'lib/demo')

    def test_an_install_command_that_fails_changes_nothing(self) -> None:
        self.write('demo/__init__.py')
        self.write('setup.cfg', '[install]\ninstall_scripts=$base/lib/demo\n')
        self.write('setup.py', """
from setuptools import setup
from setuptools.command.install import install

class Install(install):
    def run(self):
        self.install_scripts = '/elsewhere'
        raise OSError('no such thing here')

setup(name='demo', packages=['demo'], cmdclass={'install': Install})
""")
        self.assertEqual(self.read()['script_folder'], 'lib/demo')

    def test_folders_are_followed_by_links_and_end(self) -> None:
        self.write('real/demo/__init__.py')
        (self.package / 'demo').symlink_to('real/demo')
        (self.package / 'real/demo/demo').symlink_to('..')
        self.write('setup.py', 'from setuptools import find_packages, setup\nsetup(packages=find_packages())\n')
        self.assertEqual(self.read()['modules'], [['demo/__init__.py', 'demo/__init__.py']])

    def test_a_link_out_of_the_workspace_is_named(self) -> None:
        (self.package / 'notes').symlink_to('out of the workspace')
        self.write('setup.py', "from setuptools import setup\nsetup(data_files=[('share', ['notes'])])\n")
        self.assertEqual(self.failure(), ('setup.py', 2, "'notes' is a link that leads out of the workspace"))


if __name__ == '__main__':
    unittest.main()
