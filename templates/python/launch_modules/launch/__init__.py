"""launch, as far as launch files use it: what they describe is recorded, and evaluated elsewhere."""
from __future__ import annotations

from . import (actions, conditions, descriptions, event_handlers, events, frontend, launch_description_sources, logging,
               substitutions, utilities)
from .action import Action
from .conditions import Condition
from .event_handlers import BaseEventHandler, EventHandler
from .events import Event
from .launch_context import LaunchContext
from .launch_description import LaunchDescription, LaunchDescriptionEntity
from .launch_description_sources import InvalidLaunchFileError, LaunchDescriptionSource
from .launch_service import LaunchIntrospector, LaunchService
from .substitution import Substitution

SomeSubstitutionsType = object
SomeSubstitutionsType_types_tuple = (str, Substitution, list, tuple)
SomeEntitiesType = object
SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, list, tuple)

__all__ = [
    'Action', 'BaseEventHandler', 'Condition', 'Event', 'EventHandler', 'InvalidLaunchFileError', 'LaunchContext',
    'LaunchDescription', 'LaunchDescriptionEntity', 'LaunchDescriptionSource', 'LaunchIntrospector', 'LaunchService',
    'SomeEntitiesType', 'SomeEntitiesType_types_tuple', 'SomeSubstitutionsType', 'SomeSubstitutionsType_types_tuple',
    'Substitution', 'actions', 'conditions', 'descriptions', 'event_handlers', 'events', 'frontend',
    'launch_description_sources', 'logging', 'substitutions', 'utilities',
]
