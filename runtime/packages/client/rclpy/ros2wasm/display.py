"""What a value looks like in a notebook: its forms by MIME type, and the names of IPython.display that make some."""
from __future__ import annotations

import base64
import json
import pprint
from collections.abc import Callable
from pathlib import Path
from typing import Any

#: Method of a value -> what it returns.
METHODS = {
    '_repr_html_': 'text/html',
    '_repr_markdown_': 'text/markdown',
    '_repr_svg_': 'image/svg+xml',
    '_repr_png_': 'image/png',
    '_repr_jpeg_': 'image/jpeg',
    '_repr_latex_': 'text/latex',
    '_repr_json_': 'application/json',
}
#: Characters of one form; a longer text is cut, another form is skipped.
MOST = 4 << 20
WIDE = 79

Bundle = dict[str, Any]
#: Shows a bundle: its forms, metadata, and the name under which it can be shown anew.
Shower = Callable[[Bundle, Bundle, 'str | None', bool], None]
Clearer = Callable[[bool], None]


def text_of(value: object) -> str:
    """As the console shows it; what is long goes below each other."""
    try:
        text = repr(value)
        if len(text) > WIDE and type(value) in (dict, list, tuple, set):
            text = pprint.pformat(value, width=WIDE, sort_dicts=False)
    except Exception as error:
        text = f'<{type(value).__name__} whose repr() fails: {error}>'
    return text if len(text) <= MOST else text[:MOST] + '...'


def plain(form: object) -> object:
    """Bytes as base64, which nbformat wants."""
    return base64.b64encode(bytes(form)).decode() if isinstance(form, (bytes, bytearray, memoryview)) else form


def fits(mime: str, form: object) -> bool:
    """A text, or what JSON can say, and not too long."""
    try:
        said = form if isinstance(form, str) else json.dumps(form, allow_nan=False) if mime.endswith('json') else None
    except (TypeError, ValueError, RecursionError):
        return False
    return said is not None and len(said) <= MOST


def bundle_of(value: Any) -> tuple[Bundle, Bundle]:
    """All forms of a value, and what is said of them."""
    data: Bundle = {'text/plain': text_of(value)}
    about: Bundle = {}
    if isinstance(value, type):
        return data, about

    def add(mime: str, form: Any) -> None:
        if isinstance(form, tuple) and len(form) == 2 and isinstance(form[1], dict):
            form, said = form
            if fits('json', said):
                about[mime] = said
        form = plain(form)
        if isinstance(mime, str) and fits(mime, form):
            data[mime] = form

    def call(name: str) -> Any:
        method = getattr(value, name, None)
        try:
            return method() if callable(method) else None
        except Exception:  # it shows itself in its other forms
            return None
    whole = call('_repr_mimebundle_')
    if isinstance(whole, tuple) and len(whole) == 2:
        whole = whole[0]
    if isinstance(whole, dict):
        for mime, form in whole.items():
            add(mime, form)
    for name, mime in METHODS.items():
        if mime not in data and (form := call(name)) is not None:
            add(mime, form)
    return data, about


class DisplayObject:
    """A text or bytes with a form of its own."""

    mime = 'text/plain'
    binary = False

    def __init__(self, data: Any = None, url: str | None = None, filename: str | None = None, **about: Any) -> None:
        if url is not None:
            raise ValueError('a notebook in a page loads nothing from elsewhere: give the data, or a file')
        if isinstance(data, Path):
            data, filename = None, str(data)
        if filename is not None:
            data = Path(filename).read_bytes() if self.binary else Path(filename).read_text()
        self.data = data
        self.filename = filename
        self.about = about

    def __repr__(self) -> str:
        return f'<IPython.display.{type(self).__name__} object>'

    def _repr_mimebundle_(self, **_: Any) -> Bundle:
        return {} if self.data is None else {self.mime: self.data}


class HTML(DisplayObject):
    mime = 'text/html'


class Markdown(DisplayObject):
    mime = 'text/markdown'


class Latex(DisplayObject):
    mime = 'text/latex'


class Math(DisplayObject):
    def _repr_mimebundle_(self, **_: Any) -> Bundle:
        return {'text/latex': f'$\\displaystyle {str(self.data).strip("$")}$'}


class SVG(DisplayObject):
    mime = 'image/svg+xml'


class JSON(DisplayObject):
    mime = 'application/json'


class Pretty(DisplayObject):
    def __repr__(self) -> str:
        return str(self.data)


class Image(DisplayObject):
    """PNG or JPEG."""

    binary = True

    def _repr_mimebundle_(self, **_: Any) -> Any:
        if not isinstance(self.data, (bytes, bytearray)):
            return {}
        mime = 'image/jpeg' if self.data[:2] == b'\xff\xd8' else 'image/png'
        size = {name: int(self.about[name]) for name in ('width', 'height') if self.about.get(name) is not None}
        return {mime: (plain(self.data), size)}


class DisplayHandle:
    """Something that is shown, and can be shown anew in its place."""

    def __init__(self, display_id: str) -> None:
        self.display_id = display_id

    def display(self, value: Any, **options: Any) -> None:
        display(value, display_id=self.display_id, **options)

    def update(self, value: Any, **options: Any) -> None:
        update_display(value, display_id=self.display_id, **options)


class _Notebook:
    """Where things are shown; none outside a notebook, where they are printed."""

    show: Shower | None = None
    clear: Clearer | None = None
    count = 0


_notebook = _Notebook()
#: Called at the end of each cell.
after_cell: list[Callable[[], None]] = []


def attach(show: Shower, clear: Clearer) -> None:
    _notebook.show, _notebook.clear = show, clear


def is_in_notebook() -> bool:
    return _notebook.show is not None


def display(
    *values: Any, raw: bool = False, metadata: Bundle | None = None, display_id: str | bool | None = None,
    update: bool = False, **_: Any
) -> DisplayHandle | None:
    """Show values below the cell. `raw`: each is a dict of forms. With `display_id` it can be shown anew."""
    if display_id is True:
        _notebook.count += 1
        display_id = f'shown-{_notebook.count}'
    name = display_id if isinstance(display_id, str) else None
    for value in values:
        if raw and isinstance(value, dict):
            data = {mime: plain(form) for mime, form in value.items() if fits(mime, plain(form))}
            about: Bundle = {}
        else:
            data, about = bundle_of(value)
        if _notebook.show is None:
            print(data.get('text/plain', ''))
        else:
            said = metadata if metadata and fits('json', metadata) else {}
            _notebook.show(data, {**about, **said}, name, update)
    return None if name is None else DisplayHandle(name)


def update_display(value: Any, *, display_id: str, **options: Any) -> None:
    """Show a value in place of what has that name."""
    display(value, display_id=display_id, update=True, **options)


def clear_output(wait: bool = False) -> None:
    """Take away what the cell has shown so far. `wait`: when something new comes."""
    if _notebook.clear is not None:
        _notebook.clear(bool(wait))


def _shows(kind: type[DisplayObject]) -> Callable[..., None]:
    def show(*values: Any, **options: Any) -> None:
        display(*(kind(value) for value in values), **options)
    return show


def names() -> dict[str, Any]:
    """Of the module IPython.display."""
    kinds = (HTML, Markdown, Latex, Math, SVG, JSON, Pretty, Image)
    found: dict[str, Any] = {kind.__name__: kind for kind in kinds}
    found |= {f'display_{kind.__name__.lower()}': _shows(kind) for kind in kinds if kind is not Image}
    return found | {
        'DisplayHandle': DisplayHandle, 'DisplayObject': DisplayObject, 'display': display,
        'update_display': update_display, 'clear_output': clear_output,
    }
