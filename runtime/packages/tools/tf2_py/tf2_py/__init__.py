"""The tree of frames: where one frame stands in another, now or a while ago."""
from tf2_py.buffer_core import BufferCore
from tf2_py.exceptions import (
    ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException, TimeoutException,
    TransformException,
)

__all__ = [
    'BufferCore', 'ConnectivityException', 'ExtrapolationException', 'InvalidArgumentException', 'LookupException',
    'TimeoutException', 'TransformException',
]
