"""Which action is meant."""
from __future__ import annotations

from . import matches_action

__all__ = ['matches_action']
