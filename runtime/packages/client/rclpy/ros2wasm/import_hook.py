"""Lets `import std_msgs.msg` find what the definitions in share/ describe: no generated files."""
from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from ros2wasm import types


class InterfaceModule(ModuleType):
    """pkg.msg, pkg.srv or pkg.action: classes are made at first use."""

    def __getattr__(self, name: str) -> Any:
        if name == '__all__':
            package, kind = self.__name__.split('.')
            return types.names_in(package, kind)
        if name.startswith('_'):
            raise AttributeError(f"module '{self.__name__}' has no attribute '{name}'")
        try:
            value = types.find_interface(f"{self.__name__.replace('.', '/')}/{name}")
        except KeyError:
            raise AttributeError(f"module '{self.__name__}' has no attribute '{name}'") from None
        setattr(self, name, value)
        return value

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.__getattr__('__all__')]


class InterfaceLoader:
    """Also the loader of pkg.msg._name, a module with the classes of one file, and of a bare pkg."""

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return InterfaceModule(spec.name) if spec.name.count('.') == 1 else None

    def exec_module(self, module: ModuleType) -> None:
        parts = module.__name__.split('.')
        if len(parts) != 3:
            return
        package, kind, file = parts
        for short in types.names_in(package, kind):
            if f'_{types.snake(short)}' != file:
                continue
            for name in types.names_of(f'{package}/{kind}/{short}'):
                setattr(module, name.split('/')[-1], types.find_interface(name))


class InterfaceFinder:
    """Comes after all other finders: a Python package of the same name has its own files."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        parts = name.split('.')
        if len(parts) == 1:
            found = any(types.folder_of(name, kind) for kind in types.KINDS)
        elif len(parts) == 2:
            found = parts[1] in types.KINDS and types.folder_of(parts[0], parts[1]) is not None
        else:
            found = len(parts) == 3 and parts[1] in types.KINDS and any(
                f'_{types.snake(short)}' == parts[2] for short in types.names_in(parts[0], parts[1]))
        if not found:
            return None
        return ModuleSpec(name, InterfaceLoader(), is_package=len(parts) < 3)  # type: ignore[arg-type]


def install() -> None:
    if not any(isinstance(finder, InterfaceFinder) for finder in sys.meta_path):
        sys.meta_path.append(InterfaceFinder())
