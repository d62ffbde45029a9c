"""What users' own actions and substitutions bring for XML and YAML, where only the built-in ones are known."""
from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from .launch_description_sources import InvalidFrontendLaunchFileError

__all__ = ['Entity', 'InvalidFrontendLaunchFileError', 'Parser', 'expose_action', 'expose_substitution']

T = TypeVar('T')


class Entity:
    """An element of a file. Only `parse` methods see one, which are never called."""


class Parser:
    """What reads a file. Only `parse` methods see one, which are never called."""


def expose_action(name: str) -> Callable[[type[T]], type[T]]:
    return lambda of: of


def expose_substitution(name: str) -> Callable[[type[T]], type[T]]:
    return lambda of: of
