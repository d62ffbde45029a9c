"""launch_ros, as far as launch files use it."""
from __future__ import annotations

import launch  # noqa: F401  first: what it imports needs it

from . import actions, descriptions, event_handlers, events, parameter_descriptions, substitutions

__all__ = ['actions', 'descriptions', 'event_handlers', 'events', 'parameter_descriptions', 'substitutions']
