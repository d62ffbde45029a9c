"""Starts a Python program of a site and tells how it ended. What blocks natively waits on the link here."""
from __future__ import annotations

import atexit
import builtins
import contextlib
import gc
import importlib
import io
import os
import runpy
import signal
import sys
import threading
import time
import traceback
from types import TracebackType
from typing import Any

from ros2wasm import event_loop, host, import_hook, processes, signals, terminal, threads, window_hook
from ros2wasm.codec import find_numpy

NS = 1_000_000_000
STDERR = 2
INTERRUPTED = -int(signal.SIGINT)
#: What the image of a started interpreter has imported.
PREPARED_MODULES = (
    'argparse', 'copy', 'dataclasses', 'datetime', 'enum', 'json', 'math', 'pkgutil', 'random', 'rclpy', 'rclpy.action',
    'rclpy.executors', 'rclpy.lifecycle', 'rclpy.parameter', 'rclpy.qos', 'typing',
)
#: What it can write and read at once, where the site has them.
PREPARED_MESSAGES = (
    'builtin_interfaces/msg/Time', 'geometry_msgs/msg/Twist', 'rcl_interfaces/msg/Log',
    'rcl_interfaces/msg/ParameterEvent', 'std_msgs/msg/Bool', 'std_msgs/msg/Float64', 'std_msgs/msg/Int32',
    'std_msgs/msg/String',
)
#: Of every node.
PREPARED_SERVICES = (
    *(f'rcl_interfaces/srv/{name}' for name in (
        'DescribeParameters', 'GetParameterTypes', 'GetParameters', 'ListParameters', 'SetParameters',
        'SetParametersAtomically')),
    'type_description_interfaces/srv/GetTypeDescription',
)
#: Frames of these are ours: a traceback begins with the user's.
OWN_FILES = (
    __file__, importlib.import_module.__code__.co_filename, runpy.run_path.__code__.co_filename, '<frozen importlib',
    '<frozen runpy')


def sleep(seconds: float, /) -> None:
    """In place of time.sleep."""
    if seconds < 0:
        raise ValueError('sleep length must be non-negative')
    end = time.monotonic_ns() + int(seconds * NS)
    # A stop ends it by raising; when its handler does not raise, or has run before, the rest is slept.
    host.sleep(max(0, end - time.monotonic_ns()))
    while (left := end - time.monotonic_ns()) > 0:
        host.sleep(left)


def ask(prompt: object = '', /) -> str:
    """In place of input."""
    sys.stdout.write(str(prompt))
    sys.stdout.flush()
    line = sys.stdin.readline()
    if not line:
        raise EOFError('EOF when reading a line')
    return line.rstrip('\n')


installed = False
#: The memory was taken over from an image.
from_image = False


def install() -> None:
    """Put what waits on the link in place of what would block the worker or fail; once."""
    global installed
    if installed:
        return
    installed = True
    setattr(time, 'sleep', sleep)
    threads.install()
    signals.install()
    processes.install()
    event_loop.install()
    terminal.install()
    builtins.input = ask
    sys.dont_write_bytecode = True
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(line_buffering=True)
    import_hook.install()
    window_hook.install()


def prepare() -> None:
    """Have ready what all programs use, for an image of the memory. Nothing of one node may get into it."""
    install()
    for module in PREPARED_MODULES:
        importlib.import_module(module)
    types = importlib.import_module('ros2wasm.types')
    for name in PREPARED_MESSAGES:
        with contextlib.suppress(KeyError):
            codec = types.codec_of(name)
            types.type_hash(name), codec.write, codec.read
    for name in PREPARED_SERVICES:
        with contextlib.suppress(KeyError):
            service = types.find_service(name)
            types.type_hash(name), service.Request, service.Response, service.Event
    host.js.forget()
    gc.collect()
    # Nobody looks among it for what is no longer used.
    gc.freeze()


def renew(environment: Any) -> None:
    """After the memory was taken over from an image: what belongs to a node is its own."""
    global from_image
    from_image = True
    os.environ.update((str(name), str(value)) for name, value in environment.items())
    if hasattr(time, 'tzset'):
        time.tzset()
    # Drawn from the run's random numbers, as at a first import.
    if 'random' in sys.modules:
        sys.modules['random'].seed()
    if 'logging' in sys.modules:
        setattr(sys.modules['logging'], '_startTime', time.time())
    # There may be more modules now.
    for place in [one for one in sys.path_importer_cache if not one.endswith('.zip')]:
        del sys.path_importer_cache[place]
    find_numpy.cache_clear()


def run_entry(entry: str, prefix: str) -> None:
    """As the script of an entry point, or as `python3 FILE`."""
    module, _, function = entry.partition(':')
    if function:
        main: Any = importlib.import_module(module)
        for name in function.split('.'):
            main = getattr(main, name)
        sys.exit(main())
    path = f'{prefix}/{entry}'
    sys.path.insert(0, os.path.dirname(path))
    runpy.run_path(path, run_name='__main__')


def exit_code(reason: object) -> int:
    """What SystemExit means."""
    if reason is None:
        return 0
    if isinstance(reason, int):
        return reason & 0xFF
    print(reason, file=sys.stderr)
    return 1


def users_part(whole: TracebackType | None) -> TracebackType | None:
    """Without our frames at its begin; all of it when there is nothing else."""
    part = whole
    while part is not None and part.tb_frame.f_code.co_filename.startswith(OWN_FILES):
        part = part.tb_next
    return part or whole


def wait_for_threads() -> None:
    """Those that are no daemons go on to their end, as natively."""
    try:
        getattr(threading, '_shutdown')()
    except KeyboardInterrupt as error:
        sys.stderr.write(f'Exception ignored in: {threading!r}\n')
        traceback.print_exception(error)


def close_files() -> None:
    """As at the interpreter's end: what was written and not closed is in its file."""
    kinds = io.TextIOWrapper, io.BufferedWriter, io.BufferedRandom
    found = [one for one in gc.get_objects() if isinstance(one, kinds)]
    # Texts first: they are written to the others.
    for one in sorted(found, key=lambda file: not isinstance(file, io.TextIOWrapper)):
        with contextlib.suppress(OSError, ValueError):
            if one.fileno() > STDERR:
                one.close()


def run(entry: str, prefix: str, arguments: Any) -> int:
    """Run to the end. `arguments`: sys.argv, the executable's name first."""
    install()
    sys.argv = [str(one) for one in arguments]
    code = 0
    try:
        run_entry(entry, prefix)
    except SystemExit as reason:
        code = exit_code(reason.code)
    except BaseException as error:
        sys.excepthook(type(error), error, users_part(error.__traceback__))
        code = INTERRUPTED if isinstance(error, KeyboardInterrupt) else 1
    wait_for_threads()
    atexit._run_exitfuncs()
    close_files()
    sys.stdout.flush()
    sys.stderr.flush()
    return code
