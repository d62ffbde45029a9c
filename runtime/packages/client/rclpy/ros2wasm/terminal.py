"""Standard input as a terminal: its modes (`termios`, and `tty` on it), waiting for keys (`select`), reading.

The page is told the mode, and sends lines or keys by it. Where a line comes all the same, a terminal without lines
gives the characters before the line's end, one at a time; an empty line is the Enter key.
"""
from __future__ import annotations

import io
import os
import select
import sys
from types import ModuleType
from typing import Any

from ros2wasm import host
from ros2wasm.constants import TerminalMode

STDIN, STDERR = 0, 2
NS = 1_000_000_000
MOST = 1 << 16
#: Places in a list of attributes.
IFLAG, LFLAG, CC = 0, 3, 6
ICRNL, ISIG, ICANON = 0o400, 0o1, 0o2
VMIN, VTIME = 6, 5
CONTROL_CHARACTERS = b'\x03\x1c\x7f\x15\x04\x00\x01\x00\x11\x13\x1a\x00\x12\x0f\x17\x16'.ljust(32, b'\0')

#: As Linux numbers them.
CONSTANTS = {
    'IGNBRK': 0o1, 'BRKINT': 0o2, 'IGNPAR': 0o4, 'PARMRK': 0o10, 'INPCK': 0o20, 'ISTRIP': 0o40, 'INLCR': 0o100,
    'IGNCR': 0o200, 'ICRNL': ICRNL, 'IUCLC': 0o1000, 'IXON': 0o2000, 'IXANY': 0o4000, 'IXOFF': 0o10000,
    'IMAXBEL': 0o20000, 'IUTF8': 0o40000,
    'OPOST': 0o1, 'OLCUC': 0o2, 'ONLCR': 0o4, 'OCRNL': 0o10, 'ONOCR': 0o20, 'ONLRET': 0o40, 'OFILL': 0o100,
    'OFDEL': 0o200,
    'CSIZE': 0o60, 'CS5': 0, 'CS6': 0o20, 'CS7': 0o40, 'CS8': 0o60, 'CSTOPB': 0o100, 'CREAD': 0o200, 'PARENB': 0o400,
    'PARODD': 0o1000, 'HUPCL': 0o2000, 'CLOCAL': 0o4000,
    'ISIG': ISIG, 'ICANON': ICANON, 'XCASE': 0o4, 'ECHO': 0o10, 'ECHOE': 0o20, 'ECHOK': 0o40, 'ECHONL': 0o100,
    'NOFLSH': 0o200, 'TOSTOP': 0o400, 'ECHOCTL': 0o1000, 'ECHOPRT': 0o2000, 'ECHOKE': 0o4000, 'IEXTEN': 0o100000,
    'VINTR': 0, 'VQUIT': 1, 'VERASE': 2, 'VKILL': 3, 'VEOF': 4, 'VTIME': VTIME, 'VMIN': VMIN, 'VSTART': 8, 'VSTOP': 9,
    'VSUSP': 10, 'VEOL': 11, 'VREPRINT': 12, 'VDISCARD': 13, 'VWERASE': 14, 'VLNEXT': 15, 'VEOL2': 16, 'NCCS': 32,
    'TCSANOW': 0, 'TCSADRAIN': 1, 'TCSAFLUSH': 2, 'TCIFLUSH': 0, 'TCOFLUSH': 1, 'TCIOFLUSH': 2, 'TCOOFF': 0,
    'TCOON': 1, 'TCIOFF': 2, 'TCION': 3, 'B9600': 13, 'B38400': 15, 'B57600': 4097, 'B115200': 4098,
    'TIOCGWINSZ': 0x5413, 'FIONREAD': 0x541B,
}


class TerminalError(Exception):
    """termios.error."""


class Terminal:
    """The modes, and what was typed and not yet read."""

    def __init__(self) -> None:
        controls: list[Any] = [bytes((one,)) for one in CONTROL_CHARACTERS]
        self.modes: list[Any] = [0o2400, 0o5, 0o277, 0o105073, 15, 15, controls]
        self.typed = b''

    @property
    def lines(self) -> bool:
        return bool(self.modes[LFLAG] & ICANON)

    def control(self, which: int) -> int:
        """VMIN or VTIME."""
        value = self.modes[CC][which]
        return int(value if isinstance(value, int) else value[0])

    def _keys(self, data: bytes) -> bytes:
        """What keys make of a line that was typed."""
        if data == b'\n':
            return data if self.modes[IFLAG] & ICRNL else b'\r'
        return data[:-1] if data.endswith(b'\n') else data

    def read(self, capacity: int) -> bytes | None:
        """As the file: waits for input. Empty: there is none any more, or not in time; None: a stop."""
        if not self.typed:
            if not self.lines and self.control(VMIN) == 0 and not self.waits(self.control(VTIME) * NS // 10):
                return b''
            data = host.read_input(MOST)
            if not data:
                return data
            self.typed = data if self.lines else self._keys(data)
        count = capacity if self.lines else 1
        data, self.typed = self.typed[:count], self.typed[count:]
        return data

    def waits(self, timeout_ns: int) -> bool:
        """Whether there is something to read, now or within that time. Negative: without end."""
        return bool(self.typed) or host.input_arrives(timeout_ns)

    def forget(self) -> None:
        """Drop what was typed and not read."""
        self.typed = b''
        while host.input_arrives(0) and host.read_input(MOST):
            pass


terminal = Terminal()


class StandardInput(io.RawIOBase):
    """The node's stdin, which the page writes."""

    name = '<stdin>'

    def readable(self) -> bool:
        return True

    def fileno(self) -> int:
        return STDIN

    def isatty(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int:
        data = terminal.read(len(buffer))
        if data is None:
            raise InterruptedError('stopped')
        buffer[:len(data)] = data
        return len(data)


def file_number(file: Any) -> int:
    """Of a number, or of what has one."""
    if isinstance(file, int):
        return file
    number = file.fileno()
    if not isinstance(number, int):
        raise TypeError('argument must be an int, or have a fileno() method.')
    return number


# ---- termios

def tcgetattr(fd: Any, /) -> list[Any]:
    _checked(fd)
    modes = terminal.modes[:CC] + [list(terminal.modes[CC])]
    if not terminal.lines:
        for which in (VMIN, VTIME):
            modes[CC][which] = terminal.control(which)
    return modes


def tcsetattr(fd: Any, when: int, attributes: list[Any], /) -> None:
    _checked(fd)
    if not isinstance(attributes, list) or len(attributes) != CC + 1:
        raise TypeError('tcsetattr, arg 3: must be 7 element list')
    if not isinstance(attributes[CC], list) or len(attributes[CC]) != len(CONTROL_CHARACTERS):
        raise TypeError('tcsetattr: attributes[6] must be 32 element list')
    # TCSAFLUSH does not drop input: a program that sets modes before each key, as tty does, gets all the keys.
    terminal.modes = attributes[:CC] + [list(attributes[CC])]
    signals = terminal.modes[LFLAG] & ISIG
    host.terminal_mode(TerminalMode.COOKED if terminal.lines else TerminalMode.CBREAK if signals else TerminalMode.RAW)


def tcflush(fd: Any, queue: int, /) -> None:
    _checked(fd)
    if queue != CONSTANTS['TCOFLUSH']:
        terminal.forget()


def tcgetwinsize(fd: Any, /) -> tuple[int, int]:
    _checked(fd)
    return 24, 80


def nothing_to_do(fd: Any, _: int = 0, /) -> None:
    _checked(fd)


def _checked(fd: Any) -> None:
    if not STDIN <= file_number(fd) <= STDERR:
        raise TerminalError(25, 'Inappropriate ioctl for device')


def termios_module() -> ModuleType:
    made = ModuleType('termios', 'Terminal modes of standard input.')
    made.__dict__.update(
        CONSTANTS, error=TerminalError, tcgetattr=tcgetattr, tcsetattr=tcsetattr, tcflush=tcflush,
        tcgetwinsize=tcgetwinsize, tcdrain=nothing_to_do, tcflow=nothing_to_do, tcsendbreak=nothing_to_do)
    return made


# ---- select

def wait_for_files(reads: Any, writes: Any, fails: Any, timeout: float | None = None, /) -> tuple[list[Any], ...]:
    """In place of select.select. Output is never full; only standard input is waited for."""
    reads, writes, fails = list(reads), list(writes), list(fails)
    if timeout is not None and timeout < 0:
        raise ValueError('timeout must be non-negative')
    for file in (*reads, *writes, *fails):
        if not STDIN <= file_number(file) <= STDERR:
            raise OSError(9, 'Bad file descriptor')
    stdin = [file for file in reads if file_number(file) == STDIN]
    outputs = [file for file in writes if file_number(file) != STDIN]
    limit = 0 if outputs else -1 if timeout is None else int(timeout * NS)
    if stdin:
        found = terminal.waits(limit)
    else:
        found = False
        while limit:
            host.sleep(limit if limit > 0 else NS)
            limit = min(limit, 0)
    return stdin if found else [], outputs, []


class Poll:
    """In place of select.poll()."""

    def __init__(self) -> None:
        self._files: dict[int, int] = {}

    def register(self, fd: Any, eventmask: int = select.POLLIN | select.POLLPRI | select.POLLOUT, /) -> None:
        self._files[file_number(fd)] = eventmask

    modify = register

    def unregister(self, fd: Any, /) -> None:
        del self._files[file_number(fd)]

    def poll(self, timeout: float | None = None, /) -> list[tuple[int, int]]:
        """`timeout` in ms."""
        reads = [fd for fd, mask in self._files.items() if fd == STDIN and mask & select.POLLIN]
        writes = [fd for fd, mask in self._files.items() if STDIN < fd <= STDERR and mask & select.POLLOUT]
        unknown = [(fd, select.POLLNVAL) for fd in self._files if not STDIN <= fd <= STDERR]
        ends = None if timeout is None or timeout < 0 else timeout / 1000
        can_read, can_write, _ = wait_for_files(reads, writes, [], 0 if unknown else ends)
        return [*unknown, *((fd, select.POLLIN) for fd in can_read), *((fd, select.POLLOUT) for fd in can_write)]


def install() -> None:
    """Put these in place of what knows nothing of the page."""
    os_read, os_isatty = os.read, os.isatty

    def read(fd: int, length: int, /) -> bytes:
        if fd != STDIN:
            return os_read(fd, length)
        data = terminal.read(length)
        if data is None:
            raise InterruptedError('stopped')
        return data

    def isatty(fd: int, /) -> bool:
        return fd == STDIN or os_isatty(fd)
    setattr(os, 'read', read)
    setattr(os, 'isatty', isatty)
    setattr(select, 'select', wait_for_files)
    setattr(select, 'poll', Poll)
    sys.modules['termios'] = termios_module()
    sys.stdin = io.TextIOWrapper(io.BufferedReader(StandardInput()), encoding='utf-8', newline='\n')
