"""The kernel of a notebook: a program that runs cells, one after the other, in one namespace.

Orders come as lines of JSON on standard input, what cells do goes out as events
(runtime/site/contract/notebook.ts has the types of both). A stop is an interrupt: it ends the cell, not the program.
"""
from __future__ import annotations

import ast
import asyncio
import builtins
import contextlib
import inspect
import io
import json
import linecache
import re
import sys
import traceback
import weakref
from collections import deque
from collections.abc import Callable, Coroutine, Iterator
from types import CodeType, ModuleType, TracebackType
from typing import Any

import rclpy
from rclpy.node import Node
from ros2wasm import display, host

MOST_INPUT = 1 << 16
NS = 1_000_000_000
#: Characters that one cell may print; no more is shown.
MOST_PRINTED = 1 << 20
#: Of a cell, so many pieces of text go out as they are printed, others together.
MOST_AT_ONCE = 500
PIECE = 1 << 13
#: When the page is so many events behind, the cell waits a little.
MOST_AHEAD = 100
REST_NS = 20_000_000
#: While a cell awaits, its nodes are looked after so often.
ATTEND_S = 0.002
MOST_CALLBACKS = 50
OWN_FILES = (__file__, asyncio.__path__[0])
FLAGS = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
#: `%name` and `!command`; not the rest of an expression, such as `% n)` or `!= n`.
MAGIC = re.compile(r'\s*(?:%[A-Za-z%]|![^=])')
#: Accepted silently: figures are always shown below the cell.
USUAL = re.compile(r'\s*%matplotlib\s+inline\s*$')

Event = dict[str, Any]


class Printed(io.TextIOBase):
    """stdout or stderr of the cells."""

    encoding = 'utf-8'

    def __init__(self, name: str, kernel: Kernel) -> None:
        self.name = name
        self.kernel = kernel
        self.waiting: list[str] = []
        self.length = 0

    def writable(self) -> bool:
        return True

    def write(self, text: str, /) -> int:
        if not isinstance(text, str):
            raise TypeError(f'write() argument must be str, not {type(text).__name__}')
        self.waiting.append(text)
        self.length += len(text)
        if self.kernel.sends_at_once() and '\n' in text or self.length >= PIECE:
            self.flush()
        return len(text)

    def flush(self) -> None:
        if not self.waiting:
            return
        text, self.waiting, self.length = ''.join(self.waiting), [], 0
        self.kernel.printed(self.name, text)


class Asked(io.TextIOBase):
    """stdin of the cells: the page asks whoever reads."""

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel

    def readable(self) -> bool:
        return True

    def readline(self, size: int | None = -1, /) -> str:  # type: ignore[override]
        line = self.kernel.ask('') + '\n'
        return line if size is None or size < 0 else line[:size]

    def __next__(self) -> str:  # type: ignore[override]
        return self.readline()


class Stopped(Exception):
    """There will be no more orders."""


class Kernel:
    def __init__(self) -> None:
        self.space: dict[str, Any] = {}
        self.count = 0
        self.cell = ''
        self.pieces = 0
        self.length = 0
        self.rest = b''
        self.orders: deque[Event] = deque()
        self.over = False
        self.out, self.err = Printed('stdout', self), Printed('stderr', self)
        self.loop = asyncio.new_event_loop()
        #: Nodes of the notebook, which are looked after while a cell awaits.
        self.nodes: weakref.WeakSet[Any] = weakref.WeakSet()

    # ---- events

    def tell(self, event: str, **what: Any) -> None:
        ahead = host.tell(json.dumps({'event': event, 'cell': self.cell, **what}))
        if ahead > MOST_AHEAD:
            host.sleep(REST_NS)

    def flush(self) -> None:
        self.out.flush()
        self.err.flush()

    def sends_at_once(self) -> bool:
        return self.pieces < MOST_AT_ONCE

    def printed(self, name: str, text: str) -> None:
        left = MOST_PRINTED - self.length
        if left < 0:
            return
        self.length += len(text)
        self.pieces += 1
        if len(text) > left:
            text = f'{text[:left]}\n... the cell prints more than {MOST_PRINTED >> 20} MiB: the rest is not shown\n'
        self.tell('stream', name=name, text=text)

    def show(self, data: display.Bundle, metadata: display.Bundle, name: str | None, update: bool) -> None:
        self.flush()
        extra = {} if name is None else {'display_id': name}
        self.tell('update' if update else 'display', data=data, metadata=metadata, **extra)

    def clear(self, wait: bool) -> None:
        self.flush()
        self.pieces = self.length = 0
        self.tell('clear', wait=wait)

    # ---- orders

    def arrived(self) -> bool:
        """Take what has come of standard input. Is there an order?"""
        while not self.over and host.input_arrives(0):
            data = host.read_input(MOST_INPUT)
            if data is None:
                break
            self.over = not data
            *lines, self.rest = (self.rest + data).split(b'\n')
            self.orders.extend(json.loads(line) for line in lines if line)
        return bool(self.orders)

    def next_order(self) -> Event:
        """Wait for one. Tasks of earlier cells go on meanwhile."""
        while True:
            token = host.wake_token()
            if self.arrived():
                return self.orders.popleft()
            if self.over:
                raise Stopped
            ready, due = self.work()
            if ready or due == 0:
                self.loop.call_soon(self.loop.stop)
                self.loop.run_forever()
            else:
                host.wait(token, due)

    def work(self) -> tuple[bool, int]:
        """Is something to do in the loop, and when something will be: ns, negative for never."""
        loop: Any = self.loop
        times = [timer._when for timer in loop._scheduled if not timer._cancelled]
        due = max(0, int((min(times) - loop.time()) * NS)) if times else -1
        return bool(loop._ready), due

    def ask(self, prompt: object = '', /) -> str:
        """In place of input."""
        self.flush()
        self.tell('input', prompt=str(prompt))
        while True:
            token = host.wake_token()
            if self.arrived():
                for order in [one for one in self.orders if 'input' in one]:
                    self.orders.remove(order)
                    text = str(order['input'])
                    self.tell('stream', name='stdout', text=f'{prompt}{text}\n')
                    return text
            if self.over:
                raise EOFError('EOF when reading a line')
            host.wait(token, -1)

    # ---- cells

    def parts(self, source: str, file: str) -> Iterator[tuple[CodeType, bool]]:
        """The code of a cell, and whether its value is its result."""
        try:
            tree = compile(source, file, 'exec', ast.PyCF_ONLY_AST | FLAGS, dont_inherit=True)
        except SyntaxError:
            without = self.without_magics(source)
            if without is None:
                raise
            tree = compile(without, file, 'exec', ast.PyCF_ONLY_AST | FLAGS, dont_inherit=True)
        assert isinstance(tree, ast.Module)
        last = tree.body[-1] if tree.body else None
        shown = isinstance(last, ast.Expr) and not source.rstrip().endswith(';')
        body = tree.body[:-1] if shown else tree.body
        yield compile(ast.Module(body, []), file, 'exec', FLAGS, dont_inherit=True), False
        if shown and isinstance(last, ast.Expr):
            yield compile(ast.Expression(last.value), file, 'eval', FLAGS, dont_inherit=True), True

    def without_magics(self, source: str) -> str | None:
        """Lines that IPython reads and Python does not are skipped; None: there are none."""
        lines = source.split('\n')
        magics = [at for at, line in enumerate(lines) if MAGIC.match(line)]
        if not magics or lines[magics[0]].startswith('%%'):
            return None
        for at in magics:
            if USUAL.match(lines[at]):
                lines[at] = ''
                continue
            print(f'line {at + 1} does nothing here: `{lines[at].strip()}` is for IPython', file=sys.stderr)
            lines[at] = ''
        return '\n'.join(lines)

    def value_of(self, code: CodeType) -> Any:
        value = eval(code, self.space)
        return self.awaited(value) if code.co_flags & inspect.CO_COROUTINE else value

    def awaited(self, steps: Coroutine[Any, Any, Any]) -> Any:
        """Run to the end; the nodes of the notebook are looked after meanwhile."""
        main = self.loop.create_task(steps)
        try:
            return self.loop.run_until_complete(self.attended(main))
        except BaseException:
            main.cancel()
            # It may have something to do before it gives up.
            self.loop.run_until_complete(asyncio.wait([main]))
            raise

    async def attended(self, main: asyncio.Task[Any]) -> Any:
        attend = asyncio.ensure_future(self.attend())
        try:
            await asyncio.wait([main, attend], return_when=asyncio.FIRST_COMPLETED)
            # attend() never returns: if it is done, awaiting it raises its exception.
            return await (main if main.done() else attend)
        finally:
            attend.cancel()

    async def attend(self) -> None:
        """Call back for nodes that nobody spins."""
        while True:
            for node in list(self.nodes):
                for _ in range(MOST_CALLBACKS):
                    if is_spun(node) or not node.context.ok() or rclpy.get_global_executor()._is_spinning:
                        break
                    rclpy.spin_once(node, timeout_sec=0)
                    if not host.ready():
                        break
            await asyncio.sleep(ATTEND_S)

    def run(self, source: str) -> None:
        self.count += 1
        self.pieces = self.length = 0
        file = f'Cell [{self.count}]'
        linecache.cache[file] = (len(source), None, [f'{line}\n' for line in source.split('\n')], file)
        self.tell('begin', count=self.count)
        try:
            for code, is_result in self.parts(source, file):
                value = self.value_of(code)
                if is_result and value is not None:
                    self.space['_'] = value
                    data, metadata = display.bundle_of(value)
                    self.flush()
                    self.tell('result', count=self.count, data=data, metadata=metadata)
            self.flush()
            good = True
        except BaseException as error:
            self.flush()
            self.failed(error)
            good = False
        self.tell('end', good=self.finished() and good)

    def finished(self) -> bool:
        """Run the callbacks for the end of a cell, such as showing figures."""
        try:
            for call in display.after_cell:
                call()
        except BaseException as error:
            self.flush()
            self.failed(error)
            return False
        return True

    def failed(self, error: BaseException) -> None:
        part = own_part_gone(error.__traceback__)
        lines = traceback.format_exception(type(error), error, part)
        try:
            said = str(error)
        except Exception:
            said = f'<{type(error).__name__} whose str() fails>'
        self.tell('error', ename=type(error).__name__, evalue=said, traceback=''.join(lines).splitlines())

    def serve(self) -> None:
        """Until there are no more orders."""
        self.tell('idle')
        while True:
            try:
                order = self.next_order()
            except KeyboardInterrupt:
                # It came when the cell that it was meant for was over.
                host.forget_stop()
                continue
            if 'code' not in order:
                continue
            host.forget_stop()
            self.cell = str(order.get('cell', ''))
            try:
                self.run(str(order['code']))
            except KeyboardInterrupt:
                # Between the end of the cell and the word of it.
                self.tell('end', good=False)


def own_part_gone(whole: TracebackType | None) -> TracebackType | None:
    """Without the kernel's frames at its begin."""
    part = whole
    while part is not None and part.tb_frame.f_code.co_filename.startswith(OWN_FILES):
        part = part.tb_next
    return part


def is_spun(node: Any) -> bool:
    """Does somebody call back for it already?"""
    return node.executor is not None and node in node.executor.get_nodes()


def follow_nodes(nodes: weakref.WeakSet[Any]) -> None:
    """Have each node that is made from now on among these."""
    make: Callable[..., None] = Node.__init__

    def made(self: Any, *arguments: Any, **options: Any) -> None:
        make(self, *arguments, **options)
        nodes.add(self)
    setattr(Node, '__init__', made)


def module(name: str, names: dict[str, Any]) -> ModuleType:
    made = ModuleType(name)
    made.__dict__.update(names)
    sys.modules[name] = made
    return made


def main() -> int:
    kernel = Kernel()
    asyncio.set_event_loop(kernel.loop)
    display.attach(kernel.show, kernel.clear)
    shown = module('IPython.display', display.names())
    module('IPython', {'display': shown, 'get_ipython': lambda: None, 'version_info': (8, 0, 0), '__path__': []})
    follow_nodes(kernel.nodes)
    # As in a program of its own, for pickle and dataclasses.
    own = module('__main__', {'__builtins__': builtins, 'display': display.display, 'get_ipython': lambda: None})
    kernel.space = own.__dict__
    streams: tuple[Any, Any, Any] = (kernel.out, kernel.err, Asked(kernel))
    sys.stdout, sys.stderr, sys.stdin = streams
    setattr(builtins, 'input', kernel.ask)
    sys.argv = ['notebook']
    with contextlib.closing(kernel.loop), contextlib.suppress(Stopped):
        kernel.serve()
    return 0
