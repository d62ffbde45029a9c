"""What starts other programs natively: none can be started here, which is said where Python itself would be silent."""
from __future__ import annotations

import errno
import os
import sys
from typing import Any, NoReturn

#: What a shell's exit status is when it does not know the command, as os.system gives it.
NOT_FOUND = 127 << 8
#: Commands that only clear a screen: a console has none, and nothing is lost.
CLEARING = {'clear', 'cls', 'reset', 'tput'}
WHY = 'a program of a page cannot start another one'

_told: set[str] = set()


def system(command: Any) -> int:
    """In place of os.system."""
    text = os.fsdecode(command)
    words = {part.split()[0] for part in text.replace('&&', ';').replace('||', ';').split(';') if part.strip()}
    if words <= CLEARING:
        return 0
    if text not in _told:
        _told.add(text)
        print(f'os.system({text!r}): {WHY}: nothing was run', file=sys.stderr)
    return NOT_FOUND


def refused(name: str) -> Any:
    def refuse(*_: Any, **__: Any) -> NoReturn:
        raise OSError(errno.ENOSYS, f'os.{name}: {WHY}')
    refuse.__name__ = name
    return refuse


def install() -> None:
    """`subprocess`, `os.popen` and `multiprocessing` fail by themselves, the last by os.fork."""
    setattr(os, 'system', system)
    for name in ('fork', 'forkpty', 'execv', 'execve', 'posix_spawn', 'posix_spawnp'):
        setattr(os, name, refused(name))
