"""Answers the evaluator: loads launch files, and calls what they hold when it comes to that."""
from __future__ import annotations

import importlib.abc
import importlib.machinery
import importlib.util
import io
import json
import linecache
import logging
import os
import sys
import traceback
import types
from collections.abc import Sequence
from typing import Any

import launch
from launch.launch_description_sources import InvalidLaunchFileError
from launch.substitutions import SubstitutionFailure
from ros2wasm_launch import host
from ros2wasm_launch.configurations import Configurations
from ros2wasm_launch.entities import entities_of, entity
from ros2wasm_launch.named_types import NamedTypesFinder

_ENTRY = 'generate_launch_description'
#: Native modules with other names than what is in them, and where that is here.
_ELSEWHERE = {
    'launch.actions.shutdown_action': 'launch.actions',
    'launch.conditions.evaluate_condition_expression_impl': 'launch.conditions',
    'launch.events.process.process_matchers': 'launch.events.process',
    'launch.frontend.expose': 'launch.frontend',
    'launch.substitutions.boolean_substitution': 'launch.substitutions',
    'launch.utilities.class_tools_impl': 'launch.utilities',
    'launch.utilities.ensure_argument_type_impl': 'launch.utilities',
    'launch.utilities.normalize_to_list_of_entities_impl': 'launch.utilities',
    'launch.utilities.normalize_to_list_of_substitutions_impl': 'launch.utilities',
    'launch.utilities.perform_substitutions_impl': 'launch.utilities',
    'launch.utilities.type_utils': 'launch.typed_values',
    'launch_ros.events.lifecycle.lifecycle_node_matchers': 'launch_ros.events.lifecycle',
    'launch_ros.events.matchers': 'launch_ros.events',
    'nav2_common.launch.has_node_params': 'nav2_common.launch',
    'nav2_common.launch.parse_multirobot_pose': 'nav2_common.launch',
    'nav2_common.launch.replace_string': 'nav2_common.launch',
    'nav2_common.launch.rewritten_yaml': 'nav2_common.launch',
}
#: That an error names.
_MOST_CALLERS = 8
#: Where os.environ is.
_OS = (os.__file__, '<frozen os>')


class SubmoduleFinder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """`launch.actions.execute_process` and its like: native modules of one name each."""

    def find_spec(self, fullname: str, path: Sequence[str] | None, target: types.ModuleType | None = None,
                  ) -> importlib.machinery.ModuleSpec | None:
        parent, _, last = fullname.rpartition('.')
        if fullname in _ELSEWHERE:
            return importlib.util.spec_from_loader(fullname, self)
        wanted = last.replace('_', '').lower()
        if not parent.startswith('launch') or parent not in sys.modules:
            return None
        if not any(name.replace('_', '').lower() == wanted for name in vars(sys.modules[parent])):
            return None
        return importlib.util.spec_from_loader(fullname, self)

    def exec_module(self, module: types.ModuleType) -> None:
        names = vars(importlib.import_module(_ELSEWHERE.get(module.__name__) or module.__name__.rpartition('.')[0]))
        module.__dict__.update({key: thing for key, thing in names.items() if not key.startswith('__')})


class SayingHandler(logging.Handler):
    """Lines of launch.logging become lines of the launch file."""

    def emit(self, record: logging.LogRecord) -> None:
        host.ask('log', level=record.levelname.lower(), text=record.getMessage(), **host.place())


class Printed(io.TextIOBase):
    """What a launch file prints."""

    def __init__(self) -> None:
        self._line = ''

    def write(self, text: str) -> int:
        *lines, self._line = (self._line + text).split('\n')
        for line in lines:
            host.ask('log', level='info', text=line, **host.place())
        return len(text)


def prepare() -> None:
    """Before the first request."""
    sys.meta_path.extend([SubmoduleFinder(), NamedTypesFinder()])
    for name in ('launch_ros', 'launch_xml.launch_description_sources', 'launch_yaml.launch_description_sources',
                 'nav2_common.launch'):
        importlib.import_module(name)
    for name, module in list(sys.modules.items()):
        if name.startswith(('launch', 'nav2_common')):
            module.__path__ = getattr(module, '__path__', [])  # natively a package, whose modules the finder gives
    logging.getLogger().addHandler(SayingHandler())
    logging.getLogger().setLevel(logging.INFO)
    setattr(sys, 'stdout', Printed())


def load(path: str) -> dict[str, Any]:
    with open(path, encoding='utf-8') as stream:
        source = stream.read()
    module = types.ModuleType('python_launch_file')
    module.__file__ = path
    exec(compile(source, path, 'exec', dont_inherit=True), module.__dict__)
    make = getattr(module, _ENTRY, None)
    if make is None:
        raise InvalidLaunchFileError(f'it has no function {_ENTRY}()')
    description = make()
    if not isinstance(description, launch.LaunchDescription):
        raise InvalidLaunchFileError(f'{_ENTRY}() gives back {description!r}, not a LaunchDescription')
    return {'entity': entity('launch', {'file': path, 'line': 1}, {}, entities_of(description))}


def reads_of(context: launch.LaunchContext) -> dict[str, Any]:
    held = context.launch_configurations
    return {'reads': sorted(held.reads)} if isinstance(held, Configurations) and held.reads is not None else {}


def context_after(context: launch.LaunchContext) -> dict[str, Any]:
    """What a function left, and which of what it found it looked at."""
    reads, held = reads_of(context), context.launch_configurations
    plain = held.plain() if isinstance(held, Configurations) else {str(k): str(v) for k, v in held.items()}
    return {'configurations': plain, **reads}


def call(request: dict[str, Any], context: launch.LaunchContext) -> dict[str, Any]:
    result = host.OBJECTS[request['number']](context)
    return {'entity': entity('launch', {'file': '', 'line': 0}, {}, entities_of(result)),
            **context_after(context)}


def perform(request: dict[str, Any], context: launch.LaunchContext) -> dict[str, Any]:
    text = str(host.OBJECTS[request['number']].perform(context))
    return {'text': text, **reads_of(context)}


def failure(error: BaseException, path: str) -> dict[str, Any]:
    """The error, with the deepest line of the user's that had a part in it, and who called, the nearest first."""
    place: dict[str, Any] = {'file': path, 'line': 0}
    frames = traceback.extract_tb(error.__traceback__)
    callers = []
    for frame in frames:
        if frame.filename.startswith('/') and not frame.filename.startswith((host.OURS, '/lib/')):
            place = {'file': frame.filename, 'line': frame.lineno or 0}
            callers.append({**place, 'name': frame.name})
    told = isinstance(error, (InvalidLaunchFileError, SubstitutionFailure, host.HostError))
    kind, message = '' if told else type(error).__name__, str(error)
    if isinstance(error, SyntaxError) and error.filename:
        place, message = {'file': error.filename, 'line': error.lineno or 0}, str(error.msg)
    line = linecache.getline(place['file'], place['line']).rstrip()
    answer = {**place, 'kind': kind, 'message': message, 'text': line, 'callers': callers[-_MOST_CALLERS - 1:-1][::-1]}
    if isinstance(error, ImportError):
        answer['module'] = error.name or ''
    if isinstance(error, KeyError) and frames and frames[-1].filename in _OS:
        answer['variable'] = str(error.args[0])
    return {'error': answer}


def answer(text: str) -> str:
    """JSON to JSON."""
    request = json.loads(text)
    context = launch.LaunchContext()
    context.launch_configurations = Configurations(request.get('configurations', {}))
    before = dict(request['environment'])
    os.environ.clear()
    os.environ.update(before)
    context.environment = os.environ  # type: ignore[assignment]
    try:
        kind = request['do']
        if kind == 'load':
            host.GIVEN = context.launch_configurations
            result = load(request['path'])
        elif kind == 'call':
            result = call(request, context)
        elif kind == 'perform':
            result = perform(request, context)
        else:
            with open(request['path'], encoding='utf-8') as stream:
                result = {'text': stream.read()}
        after = dict(os.environ)
        result['environment'] = {name: value for name, value in after.items() if before.get(name) != value}
        result['unset'] = sorted(set(before) - set(after))
    except (Exception, SystemExit) as error:
        result = failure(error, request.get('path', ''))
    return json.dumps(result, allow_nan=False)
