"""What lies between rotations."""
from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform._rotation import Rotation


class Slerp:
    """Turns at a constant rate from each rotation to the next one."""

    def __init__(self, times: Any, rotations: Rotation) -> None:
        if not isinstance(rotations, Rotation):
            raise TypeError(f'{type(rotations)!r} is not a Rotation')
        if rotations.single or len(rotations) < 2:
            raise ValueError('`rotations` are not two or more')
        self.times = np.asarray(times)
        if self.times.shape != (len(rotations),):
            raise ValueError(f'{len(rotations)} rotations and {self.times.size} times are no pairs')
        self.timedelta = np.diff(self.times)
        if np.any(self.timedelta <= 0):
            raise ValueError('each of `times` must be later than the one before')
        self.rotations = rotations[:-1]
        self.rotvecs = (self.rotations.inv() * rotations[1:]).as_rotvec()

    def __call__(self, times: Any) -> Rotation:
        at = np.asarray(times)
        if at.ndim > 1:
            raise ValueError(f'`times` has {at.ndim} dimensions, not 0 or 1')
        single = at.ndim == 0
        at = np.atleast_1d(at)
        if np.any(at < self.times[0]) or np.any(at > self.times[-1]):
            raise ValueError(f'`times` has some outside of {self.times[0]} to {self.times[-1]}')
        steps = np.clip(np.searchsorted(self.times, at, side='left') - 1, 0, len(self.timedelta) - 1)
        shares = (at - self.times[steps]) / self.timedelta[steps]
        made = self.rotations[steps] * Rotation.from_rotvec(shares[:, None] * self.rotvecs[steps])
        return made[0] if single else made
