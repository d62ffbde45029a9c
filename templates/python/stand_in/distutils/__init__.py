"""The older name of setuptools."""
from __future__ import annotations

import os
import sys
from types import ModuleType


def convert_path(pathname: str) -> str:
    return os.path.join(*pathname.split('/')) if pathname and not pathname.startswith('/') else pathname


def strtobool(val: str) -> int:
    word = val.lower()
    if word in ('y', 'yes', 't', 'true', 'on', '1'):
        return 1
    if word in ('n', 'no', 'f', 'false', 'off', '0'):
        return 0
    raise ValueError(f'invalid truth value {word!r}')


#: `from distutils.util import convert_path`.
util = ModuleType(f'{__name__}.util')
for _function in (convert_path, strtobool):
    setattr(util, _function.__name__, _function)
sys.modules[util.__name__] = util
