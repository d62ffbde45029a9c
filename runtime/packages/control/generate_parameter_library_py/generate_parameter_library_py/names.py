"""Names that can be names in generated code."""
from __future__ import annotations

import keyword
import re

IDENTIFIER = re.compile(r'[A-Za-z_][A-Za-z0-9_]*')
#: A function of the user's: names, with `::` between them, and `<>` for the type of the parameter.
FUNCTION = re.compile(r'(?:::)?[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*(?:<(?:[A-Za-z_][\w:]*)?>)?', re.ASCII)

CPP_KEYWORDS = frozenset("""
alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await
co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete do
double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace
new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires return
short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef
typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq
""".split())


def is_name(text: str, language: str) -> bool:
    if not IDENTIFIER.fullmatch(text):
        return False
    return text not in CPP_KEYWORDS if language == 'cpp' else not keyword.iskeyword(text)


def type_name(name: str) -> str:
    """The name of the structure for a group: `pid_gains` -> `PidGains`."""
    return ''.join(word.title() for word in name.split('_'))


def suggestion(text: str) -> str:
    """A name near to `text` that can be one in C++ and Python."""
    name = re.sub(r'\W', '_', text, flags=re.ASCII).lstrip('_') or 'name'
    if name[0].isdigit():
        name = f'_{name}'
    return name if name not in CPP_KEYWORDS and not keyword.iskeyword(name) else f'{name}_'
