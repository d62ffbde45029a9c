"""The states of a managed life and the steps between them, as lifecycle_msgs numbers them."""
from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from lifecycle_msgs.msg import State, Transition


class TransitionCallbackReturn(IntEnum):
    """What a callback says of its transition."""

    SUCCESS = Transition.TRANSITION_CALLBACK_SUCCESS
    FAILURE = Transition.TRANSITION_CALLBACK_FAILURE
    ERROR = Transition.TRANSITION_CALLBACK_ERROR


class LifecycleState(NamedTuple):
    """A state."""

    label: str
    state_id: int


class Step(NamedTuple):
    """From one state to another."""

    id: int
    label: str
    start: int
    goal: int


SHUTDOWN = 'shutdown'
LABELS = {
    TransitionCallbackReturn.SUCCESS: 'transition_success',
    TransitionCallbackReturn.FAILURE: 'transition_failure',
    TransitionCallbackReturn.ERROR: 'transition_error',
}
UNCONFIGURED, INACTIVE = int(State.PRIMARY_STATE_UNCONFIGURED), int(State.PRIMARY_STATE_INACTIVE)
ACTIVE, FINALIZED = int(State.PRIMARY_STATE_ACTIVE), int(State.PRIMARY_STATE_FINALIZED)
CONFIGURING, CLEANINGUP = int(State.TRANSITION_STATE_CONFIGURING), int(State.TRANSITION_STATE_CLEANINGUP)
SHUTTINGDOWN, ACTIVATING = int(State.TRANSITION_STATE_SHUTTINGDOWN), int(State.TRANSITION_STATE_ACTIVATING)
DEACTIVATING = int(State.TRANSITION_STATE_DEACTIVATING)
ERRORPROCESSING = int(State.TRANSITION_STATE_ERRORPROCESSING)

#: In the order in which tools list them.
STATES = {
    int(State.PRIMARY_STATE_UNKNOWN): 'unknown', UNCONFIGURED: 'unconfigured', INACTIVE: 'inactive', ACTIVE: 'active',
    FINALIZED: 'finalized', CONFIGURING: 'configuring', CLEANINGUP: 'cleaningup', SHUTTINGDOWN: 'shuttingdown',
    ACTIVATING: 'activating', DEACTIVATING: 'deactivating', ERRORPROCESSING: 'errorprocessing',
}


def _through(first: int, state: int, success: int, failure: int, error: int) -> list[Step]:
    """The ways out of a state in which a callback runs; their numbers follow each other."""
    goals = zip(LABELS.values(), (success, failure, error))
    return [Step(first + i, label, state, goal) for i, (label, goal) in enumerate(goals)]


_T = Transition
STEPS = [
    Step(_T.TRANSITION_CONFIGURE, 'configure', UNCONFIGURED, CONFIGURING),
    *_through(_T.TRANSITION_ON_CONFIGURE_SUCCESS, CONFIGURING, INACTIVE, UNCONFIGURED, ERRORPROCESSING),
    Step(_T.TRANSITION_CLEANUP, 'cleanup', INACTIVE, CLEANINGUP),
    *_through(_T.TRANSITION_ON_CLEANUP_SUCCESS, CLEANINGUP, UNCONFIGURED, INACTIVE, ERRORPROCESSING),
    Step(_T.TRANSITION_ACTIVATE, 'activate', INACTIVE, ACTIVATING),
    *_through(_T.TRANSITION_ON_ACTIVATE_SUCCESS, ACTIVATING, ACTIVE, INACTIVE, ERRORPROCESSING),
    Step(_T.TRANSITION_DEACTIVATE, 'deactivate', ACTIVE, DEACTIVATING),
    *_through(_T.TRANSITION_ON_DEACTIVATE_SUCCESS, DEACTIVATING, INACTIVE, ACTIVE, ERRORPROCESSING),
    Step(_T.TRANSITION_UNCONFIGURED_SHUTDOWN, SHUTDOWN, UNCONFIGURED, SHUTTINGDOWN),
    Step(_T.TRANSITION_INACTIVE_SHUTDOWN, SHUTDOWN, INACTIVE, SHUTTINGDOWN),
    Step(_T.TRANSITION_ACTIVE_SHUTDOWN, SHUTDOWN, ACTIVE, SHUTTINGDOWN),
    *_through(_T.TRANSITION_ON_SHUTDOWN_SUCCESS, SHUTTINGDOWN, FINALIZED, FINALIZED, ERRORPROCESSING),
    *_through(_T.TRANSITION_ON_ERROR_SUCCESS, ERRORPROCESSING, UNCONFIGURED, FINALIZED, FINALIZED),
]


class StateMachine:
    """Where a managed life is."""

    def __init__(self) -> None:
        self.state = UNCONFIGURED

    @property
    def current(self) -> LifecycleState:
        return LifecycleState(STATES[self.state], self.state)

    def available(self) -> list[Step]:
        return [one for one in STEPS if one.start == self.state]

    def find(self, key: int | str) -> Step | None:
        """The step from here with a number or a label."""
        for one in self.available():
            if key in (one.id, one.label):
                return one
        return None
