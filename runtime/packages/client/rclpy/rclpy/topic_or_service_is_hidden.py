"""Names that tools leave out when nobody asks for all."""
from __future__ import annotations

HIDDEN_TOPIC_PREFIX = '_'


def topic_or_service_is_hidden(name: str) -> bool:
    """Does one of its parts begin with an underscore?"""
    return f'/{HIDDEN_TOPIC_PREFIX}' in f'/{name}'
