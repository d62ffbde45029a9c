"""Why a transform cannot be had. Tracebacks name the module tf2, as upstream's do."""
from __future__ import annotations


class TransformException(Exception):
    """Any of these."""


class ConnectivityException(TransformException):
    """The two frames are in different trees."""


class LookupException(TransformException):
    """A frame does not exist."""


class ExtrapolationException(TransformException):
    """The time is outside of what the buffer has."""


class InvalidArgumentException(TransformException):
    """A name that no frame can have."""


class TimeoutException(TransformException):
    """It did not come in time."""


for _cls in (TransformException, ConnectivityException, LookupException, ExtrapolationException,
             InvalidArgumentException, TimeoutException):
    _cls.__module__ = 'tf2'
