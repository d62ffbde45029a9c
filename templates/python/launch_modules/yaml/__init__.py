"""YAML as launch files use it: read by the evaluator, written as JSON, which is YAML."""
from __future__ import annotations

import json
from typing import Any

from ros2wasm_launch import host


class YAMLError(Exception):
    """A text that is not a YAML."""


class SafeLoader:
    """The one way there is."""


FullLoader = Loader = SafeLoader


def safe_load(stream: Any) -> Any:
    text = stream if isinstance(stream, (str, bytes)) else stream.read()
    try:
        return host.ask('yaml', text=text.decode() if isinstance(text, bytes) else text)['value']
    except host.HostError as error:
        raise YAMLError(str(error)) from error


def safe_load_all(stream: Any) -> list[Any]:
    text = stream if isinstance(stream, str) else stream.read()
    return [safe_load(part) for part in text.split('\n---') if part.strip()]


def load(stream: Any, Loader: Any = None) -> Any:
    return safe_load(stream)


def full_load(stream: Any) -> Any:
    return safe_load(stream)


def safe_dump(data: Any, stream: Any = None, **_style: Any) -> str | None:
    text = json.dumps(data, ensure_ascii=False, indent=2) + '\n'
    if stream is None:
        return text
    stream.write(text)
    return None


def dump(data: Any, stream: Any = None, **style: Any) -> str | None:
    return safe_dump(data, stream, **style)
