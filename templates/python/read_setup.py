"""Runs a package's setup.py against a stand-in of setuptools, and says what it would install.

The result is JSON. `modules`, `data`: pairs of a file of the package and its place below the folder of modules or below
the prefix; `scripts`: the same for programs; `written`: pairs of a place below the prefix and a text, of files that
setup.py itself installed; `entry_points`: group -> lines; `warnings`: lines that are not followed; or only `error`.
"""
from __future__ import annotations

import ast
import configparser
import fnmatch
import glob
import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import posixpath
import re
import runpy
import sys
import traceback
import types
from typing import Any

import manifest_in

SETUP = 'setup.py'
CONFIG = 'setup.cfg'
BASE = '$base'
DEFAULT_SCRIPTS = 'bin'
#: Where a command of a package sees itself install; nothing is there.
PREFIX = '/installed'
#: What setup.py sees as the workspace that colcon builds.
WORKSPACE = '/workspace'
MOST_WRITTEN = 4_000_000  # characters
#: Sections whose keys are folders, packages and groups, not options.
OWN_NAMES = ('options.data_files', 'options.entry_points', 'options.extras_require', 'options.package_data')


#: What setup() takes: the metadata of distutils and setuptools, and their options.
KEYWORDS = frozenset((
    'author', 'author_email', 'classifiers', 'cmdclass', 'command_options', 'command_packages',
    'convert_2to3_doctests', 'data_files', 'dependency_links', 'description', 'distclass', 'download_url',
    'eager_resources', 'entry_points', 'exclude_package_data', 'ext_modules', 'ext_package', 'extra_path',
    'extras_require', 'features', 'headers', 'include_dirs', 'include_package_data', 'install_requires', 'keywords',
    'libraries', 'license', 'license_expression', 'license_file', 'license_files', 'licence', 'long_description',
    'long_description_content_type', 'maintainer', 'maintainer_email', 'message_extractors', 'name',
    'namespace_packages', 'obsoletes', 'options', 'package_data', 'package_dir', 'packages', 'password',
    'platforms', 'project_urls', 'provides', 'provides_extras', 'py_modules', 'python_requires', 'requires',
    'script_args', 'script_name', 'scripts', 'setup_requires', 'src_root', 'test_loader', 'test_suite',
    'tests_require', 'url', 'use_2to3', 'use_2to3_exclude_fixers', 'use_2to3_fixers', 'use_scm_version', 'version',
    'zip_safe'))


class SetupError(Exception):
    """What setuptools would refuse."""


def read_config(path: str) -> dict[str, dict[str, str]]:
    """setup.cfg, with options named as setup() names them. What a package names itself stays as it is."""
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str  # type: ignore[assignment]
    if os.path.exists(path):
        parser.read(path, encoding='utf-8')
    result = {name: dict(parser[name]) for name in parser.sections()}
    for name in set(result) - set(OWN_NAMES):
        result[name] = {key.lower().replace('-', '_'): value for key, value in result[name].items()}
    return result


def lines_of(value: Any) -> list[str]:
    """A list in setup.cfg, or one given by setup()."""
    if isinstance(value, str):
        return [line.strip() for line in value.replace(',', '\n').splitlines() if line.strip()]
    return [str(one) for one in value or ()]


def text_of_files(names: str) -> str:
    """`file: A, B` of setup.cfg, without `file:`."""
    texts = []
    for name in lines_of(names):
        if not os.path.isfile(name):
            raise SetupError(missing(name))
        with open(name, encoding='utf-8') as stream:
            texts.append(stream.read())
    return '\n'.join(texts)


def attribute(name: str, package_dir: dict[str, str]) -> Any:
    """`attr: package.module.NAME` of setup.cfg, without `attr:`: read off the module's text, else by importing it."""
    module, _, wanted = name.rpartition('.')
    place = folder_of(module, package_dir) if module else package_dir.get('', '.')
    for path in (f'{place}.py', f'{place}/__init__.py'):
        if not os.path.isfile(path):
            continue
        with open(path, encoding='utf-8') as stream:
            tree = ast.parse(stream.read(), path)
        for statement in reversed(tree.body):
            targets = statement.targets if isinstance(statement, ast.Assign) else (
                [statement.target] if isinstance(statement, ast.AnnAssign) and statement.value else [])
            if any(isinstance(target, ast.Name) and target.id == wanted for target in targets):
                try:
                    return ast.literal_eval(statement.value)  # type: ignore[attr-defined]
                except (TypeError, ValueError):
                    break
    # The module may change the path itself, so what it had before is what it has after.
    before = list(sys.path)
    sys.path.insert(0, os.path.abspath(package_dir.get('', '.')))
    try:
        return getattr(importlib.import_module(module or '__init__'), wanted)
    finally:
        sys.path[:] = before


def version_of(value: str, package_dir: dict[str, str]) -> str:
    """What setup.cfg says of the version."""
    kind, _, rest = value.partition(':')
    if kind.strip() == 'file':
        return text_of_files(rest.strip()).strip()
    if kind.strip() != 'attr':
        return value
    found = attribute(rest.strip(), package_dir)
    found = found() if callable(found) else found
    return '.'.join(map(str, found)) if isinstance(found, (list, tuple)) else str(found)


def declared(config: dict[str, dict[str, str]], given: dict[str, Any]) -> dict[str, Any]:
    """What setup.cfg says in place of arguments of setup(), which was given some."""
    import setuptools

    metadata = config.get('metadata', {})
    result: dict[str, Any] = {key: metadata[key] for key in ('name', 'version') if key in metadata}
    options = config.get('options', {})
    if 'package_dir' in options:
        pairs = (line.partition('=') for line in lines_of(options['package_dir']))
        result['package_dir'] = {key.strip(): value.strip() for key, _, value in pairs}
    if 'version' in result:
        package_dir: dict[str, str] = given.get('package_dir') or result.get('package_dir') or {}
        result['version'] = version_of(result['version'], package_dir)
    wanted = options.get('packages', '').strip()
    if wanted in ('find:', 'find_namespace:'):
        find = config.get('options.packages.find', {})
        finder = setuptools.find_packages if wanted == 'find:' else setuptools.find_namespace_packages
        result['packages'] = finder(
            find.get('where', '.'), lines_of(find.get('exclude')), lines_of(find.get('include')) or ('*',))
    elif 'packages' in options:
        result['packages'] = lines_of(options['packages'])
    for key in ('py_modules', 'scripts', 'install_requires'):
        if key in options:
            result[key] = lines_of(options[key])
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


def below_root(path: str) -> str:
    """A path of the package, relative to it, which is where setup.py runs."""
    path = posixpath.normpath(path)
    return posixpath.relpath(path, os.getcwd()) if posixpath.isabs(path) else path


def missing(path: str) -> str:
    if os.path.islink(path):
        return f"'{path}' is a link that leads out of the workspace"
    return f"can't copy '{path}': doesn't exist or not a regular file"


def folder_of(package: str, package_dir: dict[str, str]) -> str:
    """Where the modules of a package lie: the longest part that package_dir names, then the rest of the name."""
    parts = package.split('.') if package else []
    for count in range(len(parts), -1, -1):
        name = '.'.join(parts[:count])
        if name in package_dir:
            return below_root(posixpath.join(package_dir[name], *parts[count:]))
    return posixpath.join(*parts) if parts else '.'


def placed(package: str) -> str:
    return package.replace('.', '/')


def modules_of(arguments: dict[str, Any], manifest: manifest_in.Selection) -> list[tuple[str, str]]:
    """Every module, and the data that stands among modules."""
    result: list[tuple[str, str]] = []
    excluded = arguments.get('exclude_package_data') or {}
    package_dir = {key: str(value) for key, value in (arguments.get('package_dir') or {}).items()}
    package_data = arguments.get('package_data') or {}
    for package in lines_of(arguments.get('packages')):
        folder = folder_of(package, package_dir)
        if not os.path.isdir(folder):
            raise SetupError(f"package directory '{folder}' does not exist")
        modules = sorted(glob.glob(f'{glob.escape(folder)}/*.py'))
        wanted = []
        for pattern in [one for key in ('', '*', package) for one in lines_of(package_data.get(key))]:
            wanted += sorted(glob.glob(posixpath.join(glob.escape(folder), pattern), recursive=True))
        if arguments.get('include_package_data'):
            wanted += [path for path in manifest.files if path.startswith(f'{folder}/')]
        for pattern in [one for key in ('', '*', package) for one in lines_of(excluded.get(key))]:
            wanted = [path for path in wanted if not fnmatch.fnmatchcase(path, posixpath.join(folder, pattern))]
        for path in modules + wanted:
            if os.path.isfile(path) and path != SETUP:
                result.append((below_root(path), posixpath.join(placed(package), posixpath.relpath(path, folder))))
    root = below_root(package_dir.get('', '.'))
    for module in lines_of(arguments.get('py_modules')):
        path = posixpath.normpath(posixpath.join(root, placed(module) + '.py'))
        if not os.path.isfile(path):
            raise SetupError(f"file '{path}' (for module {module}) not found")
        result.append((path, placed(module) + '.py'))
    return sorted(set(result))


def data_of(arguments: dict[str, Any]) -> list[tuple[str, str]]:
    """Files that go below the prefix."""
    result: list[tuple[str, str]] = []
    for item in arguments.get('data_files') or ():
        folder, files = ('', [item]) if isinstance(item, str) else item
        if isinstance(files, str):
            raise SetupError(f"data_files: the files of '{folder}' must be a list, not the text '{files}'")
        for file in files:
            path = below_root(str(file))
            if not os.path.isfile(path):
                raise SetupError(missing(str(file)))
            result.append((path, posixpath.join(str(folder), posixpath.basename(path))))
    return result


def script_folder(config: dict[str, dict[str, str]]) -> str:
    """Where programs go, below the prefix."""
    given = config.get('install', {}).get('install_scripts') or config.get('develop', {}).get('script_dir')
    folder = given or DEFAULT_SCRIPTS
    return folder.removeprefix(BASE).strip('/')


def redirected(arguments: dict[str, Any], folder: str) -> str:
    """Where an `install` command of the package's own puts programs. It is run for that alone, and may fail."""
    made = (arguments.get('cmdclass') or {}).get('install')
    if made is None:
        return folder
    try:
        command = made()
        command.install_scripts = posixpath.join(PREFIX, folder)
        command.run()
        changed = posixpath.normpath(command.install_scripts)
    except Exception:
        return folder
    return posixpath.relpath(changed, PREFIX) if changed.startswith(PREFIX + '/') else folder


def colcon_arguments(package: str) -> list[str]:
    """As colcon calls setup.py."""
    build = f'{WORKSPACE}/build/{package}'
    return [SETUP, 'egg_info', '--egg-base', build, 'build', '--build-base', f'{build}/build',
            'install', '--prefix', f'{WORKSPACE}/install/{package}']


def written(package: str) -> list[tuple[str, str]]:
    """The files that setup.py put where the package is installed."""
    prefix = f'{WORKSPACE}/install/{package}'
    result = []
    for folder, _, names in sorted(os.walk(prefix)):
        for name in sorted(names):
            path = posixpath.join(folder, name)
            try:
                with open(path, encoding='utf-8', newline='') as stream:
                    result.append((posixpath.relpath(path, prefix), stream.read()))
            except UnicodeDecodeError:
                raise SetupError(f"it installs '{posixpath.relpath(path, prefix)}', which is not text") from None
    if sum(len(text) for _, text in result) > MOST_WRITTEN:
        raise SetupError(f'it installs files of more than {MOST_WRITTEN} characters, which are not in the package')
    return result


def planned(arguments: dict[str, Any], config: dict[str, dict[str, str]]) -> dict[str, Any]:
    arguments = {**declared(config, arguments), **arguments}
    if arguments.get('ext_modules'):
        raise SetupError('modules in C (ext_modules) cannot be built for sites')
    folder = redirected(arguments, script_folder(config))
    manifest = manifest_in.selection(arguments.get('include_package_data'))
    scripts = []
    for script in lines_of(arguments.get('scripts')):
        if not os.path.isfile(script):
            raise SetupError(missing(script))
        scripts.append((below_root(script), posixpath.join(folder, posixpath.basename(script))))
    return {
        'name': str(arguments.get('name') or 'UNKNOWN'),
        'version': str(arguments.get('version') or '0.0.0'),
        'modules': modules_of(arguments, manifest),
        'data': data_of(arguments),
        'scripts': scripts,
        'script_folder': folder,
        'entry_points': entry_points_of(arguments.get('entry_points')),
        'warnings': [
            {'file': manifest_in.NAME, 'line': line, 'message': message} for line, message in manifest.warnings],
        'unknown': [{'keyword': keyword, 'line': line_of(keyword)} for keyword in sorted(set(arguments) - KEYWORDS)],
    }


def line_of(keyword: str) -> int:
    """The line of setup.py where a keyword is given, or 0."""
    with open(SETUP, encoding='utf-8') as stream:
        for number, line in enumerate(stream, 1):
            if re.search(rf'(?<!\w)["\']?{re.escape(keyword)}["\']?\s*[=:]', line):
                return number
    return 0


class Absent:
    """A name of a module that is not there. Editors import such by themselves, and nobody uses them."""

    def __init__(self, module: str) -> None:
        self._module = module

    def _used(self, *_arguments: Any, **_named: Any) -> Any:
        raise ModuleNotFoundError(f"No module named '{self._module}'", name=self._module)

    __call__ = __getattr__ = __iter__ = __enter__ = __str__ = __add__ = __radd__ = _used


class AbsentModules(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Gives modules that are not there, below the top-level names that it holds."""

    def __init__(self) -> None:
        self.names: set[str] = set()

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> importlib.machinery.ModuleSpec | None:
        is_ours = fullname.partition('.')[0] in self.names
        return importlib.util.spec_from_loader(fullname, self, is_package=True) if is_ours else None

    def exec_module(self, module: types.ModuleType) -> None:
        top = module.__name__.partition('.')[0]
        setattr(module, '__getattr__', lambda _name: Absent(top))


def run_setup(path: str) -> None:
    """
    Run setup.py, once more with each module that it imports and that is not there.

    One that it uses fails where it is used. The first run is without them, as a file may do without what it tries.
    """
    import setuptools

    absent = AbsentModules()
    sys.meta_path.append(absent)
    while True:
        try:
            runpy.run_path(path, run_name='__main__')
            return
        except ModuleNotFoundError as error:
            name = (error.name or '').partition('.')[0]
            if not name or name in absent.names:
                raise
            absent.names.add(name)
            setuptools.CALLS.clear()


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


def read(root: str, package: str = 'package') -> str:
    """Run `root`/setup.py of a package; return JSON."""
    import setuptools

    os.chdir(root)
    sys.path.insert(0, root)
    sys.argv = colcon_arguments(package)
    line = 1
    try:
        try:
            run_setup(f'{root}/{SETUP}')
        except SystemExit as end:
            if end.code not in (None, 0):
                what = f'exit code {end.code}' if isinstance(end.code, int) else str(end.code)
                raise SetupError(f'it ends itself: {what}').with_traceback(end.__traceback__) from None
        if not setuptools.CALLS:
            raise SetupError('it does not call setup()')
        arguments, line = setuptools.CALLS[-1]
        result = {**planned(arguments, read_config(CONFIG)), 'written': written(package)}
    except BaseException as error:
        result = failure(error, line)
    return json.dumps(result, sort_keys=True)
