"""In place of setuptools while a package is read: notes what setup() is called with, and installs nothing."""
from __future__ import annotations

import fnmatch
import os
import sys
from collections.abc import Iterable
from typing import Any

#: Arguments of each call of setup(), and the line of the call.
CALLS: list[tuple[dict[str, Any], int]] = []


class Command:
    """What packages derive commands of their own from, or wrap. Of these `install` is run, to see where programs go."""

    description = ''
    user_options: list[tuple[str, str | None, str]] = []
    boolean_options: list[str] = []

    def __init__(self, dist: Any = None) -> None:
        self.distribution = dist

    def initialize_options(self) -> None:
        pass

    def finalize_options(self) -> None:
        pass

    def run(self) -> None:
        pass


class Extension:
    """A module in C."""

    def __init__(self, name: str, *_arguments: Any, **_options: Any) -> None:
        self.name = name


class Distribution:
    """For packages that look at it; has nothing."""


def setup(**arguments: Any) -> Distribution:
    CALLS.append((arguments, sys._getframe(1).f_lineno))
    return Distribution()


def _found(where: str, exclude: Iterable[str], include: Iterable[str], needs_init: bool) -> list[str]:
    excluded, included = tuple(exclude), tuple(include)
    result = []
    for parent, folders, files in os.walk(where, followlinks=True):
        name = os.path.relpath(parent, where).replace(os.sep, '.')
        here = os.path.realpath(parent) + os.sep
        folders[:] = [one for one in folders if not here.startswith(os.path.realpath(f'{parent}/{one}') + os.sep)]
        if name == '.':
            folders.sort()
            continue
        if not name.rsplit('.', 1)[-1].isidentifier() or (needs_init and '__init__.py' not in files):
            folders.clear()
            continue
        folders.sort()
        is_wanted, is_not = (any(fnmatch.fnmatch(name, one) for one in some) for some in (included, excluded))
        if is_wanted and not is_not:
            result.append(name)
    return result


def find_packages(where: str = '.', exclude: Iterable[str] = (), include: Iterable[str] = ('*',)) -> list[str]:
    return _found(where, exclude, include, needs_init=True)


def find_namespace_packages(
    where: str = '.', exclude: Iterable[str] = (), include: Iterable[str] = ('*',),
) -> list[str]:
    return _found(where, exclude, include, needs_init=False)
