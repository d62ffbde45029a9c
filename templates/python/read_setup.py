"""Runs a package's setup.py against a stand-in of setuptools, and says what it would install.

The result is JSON. `modules`, `data`: pairs of a file of the package and its place below the folder of modules or below
the prefix; `scripts`: the same for programs; `entry_points`: group -> lines; or only `error`.
"""
from __future__ import annotations

import configparser
import fnmatch
import glob
import json
import os
import posixpath
import runpy
import sys
import traceback
from typing import Any

SETUP = 'setup.py'
CONFIG = 'setup.cfg'
BASE = '$base'
DEFAULT_SCRIPTS = 'bin'


class SetupError(Exception):
    """What setuptools would refuse."""


def read_config(path: str) -> dict[str, dict[str, str]]:
    """setup.cfg, with options named as setup() names them."""
    parser = configparser.ConfigParser(interpolation=None)
    if os.path.exists(path):
        parser.read(path, encoding='utf-8')
    return {name: {key.replace('-', '_'): value for key, value in parser[name].items()} for name in parser.sections()}


def lines_of(value: Any) -> list[str]:
    """A list in setup.cfg, or one given by setup()."""
    if isinstance(value, str):
        return [line.strip() for line in value.replace(',', '\n').splitlines() if line.strip()]
    return [str(one) for one in value or ()]


def declared(config: dict[str, dict[str, str]]) -> dict[str, Any]:
    """What setup.cfg says in place of arguments of setup()."""
    import setuptools

    metadata = config.get('metadata', {})
    result: dict[str, Any] = {key: metadata[key] for key in ('name', 'version') if key in metadata}
    options = config.get('options', {})
    if options.get('packages', '').strip() in ('find:', 'find_namespace:'):
        find = config.get('options.packages.find', {})
        result['packages'] = setuptools.find_packages(
            find.get('where', '.'), lines_of(find.get('exclude')), lines_of(find.get('include')) or ('*',))
    elif 'packages' in options:
        result['packages'] = lines_of(options['packages'])
    for key in ('py_modules', 'scripts', 'install_requires'):
        if key in options:
            result[key] = lines_of(options[key])
    if 'package_dir' in options:
        pairs = (line.partition('=') for line in lines_of(options['package_dir']))
        result['package_dir'] = {key.strip(): value.strip() for key, _, value in pairs}
    if 'options.package_data' in config:
        result['package_data'] = {
            '' if key == '*' else key: lines_of(value) for key, value in config['options.package_data'].items()}
    if 'options.data_files' in config:
        result['data_files'] = [(key, lines_of(value)) for key, value in config['options.data_files'].items()]
    if 'options.entry_points' in config:
        result['entry_points'] = {
            key: [line.strip() for line in value.splitlines() if line.strip()]
            for key, value in config['options.entry_points'].items()}
    return result


def entry_points_of(value: Any) -> dict[str, list[str]]:
    """Group -> lines `name = module:function`."""
    if not value:
        return {}
    if isinstance(value, str):
        parser = configparser.ConfigParser(delimiters=('=',), interpolation=None)
        parser.optionxform = str  # type: ignore[assignment]
        parser.read_string(value)
        return {group: [f'{name} = {target}' for name, target in parser[group].items()] for group in parser.sections()}
    return {
        str(group): [line.strip() for line in (lines.splitlines() if isinstance(lines, str) else lines) if line.strip()]
        for group, lines in value.items()}


def folder_of(package: str, package_dir: dict[str, str]) -> str:
    """Where the modules of a package lie: the longest part that package_dir names, then the rest of the name."""
    parts = package.split('.') if package else []
    for count in range(len(parts), -1, -1):
        name = '.'.join(parts[:count])
        if name in package_dir:
            return posixpath.normpath(posixpath.join(package_dir[name], *parts[count:]))
    return posixpath.join(*parts) if parts else '.'


def placed(package: str) -> str:
    return package.replace('.', '/')


def modules_of(arguments: dict[str, Any]) -> list[tuple[str, str]]:
    """Every module, and the data that stands among modules."""
    result: list[tuple[str, str]] = []
    package_dir = {key: str(value) for key, value in (arguments.get('package_dir') or {}).items()}
    package_data = arguments.get('package_data') or {}
    for package in lines_of(arguments.get('packages')):
        folder = folder_of(package, package_dir)
        if not os.path.isdir(folder):
            raise SetupError(f"package directory '{folder}' does not exist")
        wanted = sorted(glob.glob(f'{glob.escape(folder)}/*.py'))
        for pattern in [one for key in ('', '*', package) for one in lines_of(package_data.get(key))]:
            wanted += sorted(glob.glob(posixpath.join(glob.escape(folder), pattern), recursive=True))
        if arguments.get('include_package_data'):
            wanted += [path for path in in_manifest() if path.startswith(f'{folder}/')]
        for path in wanted:
            if os.path.isfile(path) and path != SETUP:
                result.append((path, posixpath.join(placed(package), posixpath.relpath(path, folder))))
    root = package_dir.get('', '.')
    for module in lines_of(arguments.get('py_modules')):
        path = posixpath.normpath(posixpath.join(root, placed(module) + '.py'))
        if not os.path.isfile(path):
            raise SetupError(f"file '{path}' (for module {module}) not found")
        result.append((path, placed(module) + '.py'))
    return sorted(set(result))


def in_manifest() -> list[str]:
    """Files that MANIFEST.in names: `include`, `recursive-include`, `graft`."""
    if not os.path.exists('MANIFEST.in'):
        return []
    files = sorted(posixpath.normpath(f'{parent}/{name}') for parent, _, names in os.walk('.') for name in names)
    found: list[str] = []
    with open('MANIFEST.in', encoding='utf-8') as stream:
        rows = [line.split() for line in stream if line.strip() and not line.startswith('#')]
    for command, *words in rows:
        if command == 'include':
            found += [path for path in files for word in words if fnmatch.fnmatch(path, word)]
        elif command == 'recursive-include' and words:
            below = [path for path in files if path.startswith(words[0].rstrip('/') + '/')]
            found += [path for path in below for word in words[1:] if fnmatch.fnmatch(posixpath.basename(path), word)]
        elif command == 'graft' and words:
            found += [path for path in files if path.startswith(words[0].rstrip('/') + '/')]
    return found


def data_of(arguments: dict[str, Any]) -> list[tuple[str, str]]:
    """Files that go below the prefix."""
    result: list[tuple[str, str]] = []
    for item in arguments.get('data_files') or ():
        folder, files = ('', [item]) if isinstance(item, str) else item
        if isinstance(files, str):
            raise SetupError(f"data_files: the files of '{folder}' must be a list, not the text '{files}'")
        for file in files:
            path = posixpath.normpath(str(file))
            if not os.path.isfile(path):
                raise SetupError(f"can't copy '{file}': doesn't exist or not a regular file")
            result.append((path, posixpath.join(str(folder), posixpath.basename(path))))
    return result


def script_folder(config: dict[str, dict[str, str]]) -> str:
    """Where programs go, below the prefix."""
    given = config.get('install', {}).get('install_scripts') or config.get('develop', {}).get('script_dir')
    folder = given or DEFAULT_SCRIPTS
    return folder.removeprefix(BASE).strip('/')


def planned(arguments: dict[str, Any], config: dict[str, dict[str, str]]) -> dict[str, Any]:
    arguments = {**declared(config), **arguments}
    if arguments.get('ext_modules'):
        raise SetupError('modules in C (ext_modules) cannot be built for sites')
    folder = script_folder(config)
    scripts = []
    for script in lines_of(arguments.get('scripts')):
        if not os.path.isfile(script):
            raise SetupError(f"can't copy '{script}': doesn't exist or not a regular file")
        scripts.append((posixpath.normpath(script), posixpath.join(folder, posixpath.basename(script))))
    return {
        'name': str(arguments.get('name') or ''),
        'version': str(arguments.get('version') or '0.0.0'),
        'modules': modules_of(arguments),
        'data': data_of(arguments),
        'scripts': scripts,
        'script_folder': folder,
        'entry_points': entry_points_of(arguments.get('entry_points')),
    }


def failure(error: BaseException, line: int) -> dict[str, Any]:
    """The error with the deepest line of the package that had a part in it."""
    place = {'file': SETUP, 'line': line}
    for frame in traceback.extract_tb(error.__traceback__):
        path = os.path.relpath(frame.filename, os.getcwd()) if os.path.isabs(frame.filename) else frame.filename
        if not path.startswith(('..', '<')) and os.path.exists(path):
            place = {'file': path, 'line': frame.lineno or 0}
    if isinstance(error, SyntaxError) and error.filename:
        place = {'file': os.path.relpath(error.filename, os.getcwd()), 'line': error.lineno or 0}
    kind = '' if isinstance(error, SetupError) else f'{type(error).__name__}: '
    return {'error': {**place, 'message': f'{kind}{error.msg if isinstance(error, SyntaxError) else error}'}}


def read(root: str) -> str:
    """Run `root`/setup.py; return JSON."""
    import setuptools

    os.chdir(root)
    sys.path.insert(0, root)
    sys.argv = [SETUP, 'install']
    line = 1
    try:
        try:
            runpy.run_path(f'{root}/{SETUP}', run_name='__main__')
        except SystemExit:
            pass
        if not setuptools.CALLS:
            raise SetupError('it does not call setup()')
        arguments, line = setuptools.CALLS[-1]
        result = planned(arguments, read_config(CONFIG))
    except BaseException as error:
        result = failure(error, line)
    return json.dumps(result, sort_keys=True)
