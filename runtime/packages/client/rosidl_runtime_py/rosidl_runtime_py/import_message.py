"""From the type of a field to its class."""
from __future__ import annotations

import importlib
import warnings
from typing import Any


def import_message_from_namespaced_type(message_type: Any) -> Any:
    if hasattr(message_type, 'value_type'):
        message_type = message_type.value_type
        warnings.warn('a sequence is deprecated here: pass the type of its elements', DeprecationWarning, stacklevel=2)
    module = importlib.import_module('.'.join(message_type.namespaces))
    if message_type.name.endswith('_FeedbackMessage'):
        action, name = message_type.name.rsplit('_', 1)
        return getattr(getattr(module, action).Impl, name)
    return getattr(module, message_type.name)
