"""Filters that messages pass, and synchronizers that put together what belongs together."""
from message_filters.cache import Cache
from message_filters.chain import Chain
from message_filters.simple_filter import SimpleFilter, Subscriber
from message_filters.synchronizers import ApproximateTimeSynchronizer, TimeSynchronizer
from message_filters.time_sequencer import TimeSequencer

__all__ = [
    'ApproximateTimeSynchronizer', 'Cache', 'Chain', 'SimpleFilter', 'Subscriber', 'TimeSequencer',
    'TimeSynchronizer',
]
