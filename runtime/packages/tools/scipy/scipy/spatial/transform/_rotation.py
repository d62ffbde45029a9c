"""One rotation, or an array of them."""
from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from scipy.spatial.transform import _quaternions as quaternions


def _many(values: Any, shape: tuple[int, ...], name: str) -> tuple[Any, bool]:
    """An array with one more dimension than one value has, and whether one was given."""
    array = np.asarray(values, dtype=float)
    if array.shape == shape:
        return array[None], True
    if array.ndim == len(shape) + 1 and array.shape[1:] == shape:
        return array, False
    wanted = ', '.join(map(str, shape))
    one = f'({wanted},)' if len(shape) == 1 else f'({wanted})'
    raise ValueError(f'`{name}` has the shape {array.shape}, not {one} or (N, {wanted})')


def _sequence(seq: str, lengths: Sequence[int]) -> tuple[str, bool]:
    """The axes in small letters, and whether they stand still."""
    if len(seq) not in lengths:
        raise ValueError(f'`{seq}` has {len(seq)} axes, not {" or ".join(map(str, lengths))}')
    extrinsic = re.fullmatch('[xyz]+', seq) is not None
    if not extrinsic and re.fullmatch('[XYZ]+', seq) is None:
        raise ValueError(f'`{seq}` has other axes than x, y and z that stand still, or X, Y and Z that turn too')
    if any(one == other for one, other in zip(seq, seq[1:])):
        raise ValueError(f'`{seq}` has an axis twice in a row')
    return seq.lower(), extrinsic


def _weights(given: Any, count: int) -> Any:
    weights = np.ones(count) if given is None else np.asarray(given, dtype=float)
    if weights.shape != (count,) or np.any(weights < 0):
        raise ValueError(f'`weights` are not {count} numbers of 0 or more')
    return weights


def _paired(rotations: int, others: int, name: str) -> int:
    """How many pairs there are: of each with each, or of one with all."""
    if rotations != others and 1 not in (rotations, others):
        raise ValueError(f'{rotations} rotations and {others} {name} are no pairs')
    return max(rotations, others)


class Rotation:
    """Rotations that stand behind one another turn from right to left: (a * b).apply(v) is a.apply(b.apply(v))."""

    def __init__(self, quat: Any, normalize: bool = True, copy: bool = True, scalar_first: bool = False) -> None:
        array, self._single = _many(quat, (4,), 'quat')
        array = np.roll(array, -1, axis=1) if scalar_first else array
        self._quat = quaternions.normalized(array) if normalize else np.array(array) if copy else array

    # ---- from other forms

    @classmethod
    def _of(cls, quat: Any, single: bool) -> Rotation:
        return cls(quat[0] if single else quat, normalize=False)

    @classmethod
    def from_quat(cls, quat: Any, *, scalar_first: bool = False) -> Rotation:
        return cls(quat, scalar_first=scalar_first)

    @classmethod
    def from_matrix(cls, matrix: Any) -> Rotation:
        matrices, single = _many(matrix, (3, 3), 'matrix')
        return cls._of(quaternions.from_matrices(matrices), single)

    @classmethod
    def from_rotvec(cls, rotvec: Any, degrees: bool = False) -> Rotation:
        vectors, single = _many(rotvec, (3,), 'rot_vec')
        return cls._of(quaternions.from_vectors(np.radians(vectors) if degrees else vectors), single)

    @classmethod
    def from_euler(cls, seq: str, angles: Any, degrees: bool = False) -> Rotation:
        axes, extrinsic = _sequence(seq, (1, 2, 3))
        given = np.asarray(angles, dtype=float)
        given = np.radians(given) if degrees else given
        single = given.ndim == 0 or (given.ndim == 1 and len(axes) > 1)
        rows = given.reshape(1, -1) if single else given[:, None] if given.ndim == 1 else given
        if rows.ndim != 2 or rows.shape[1] != len(axes):
            raise ValueError(f'`angles` has the shape {given.shape}; each rotation takes {len(axes)}')
        made = quaternions.about_axis(axes[0], rows[:, 0])
        for axis, column in zip(axes[1:], rows.T[1:]):
            turn = quaternions.about_axis(axis, column)
            made = quaternions.product(turn, made) if extrinsic else quaternions.product(made, turn)
        return cls._of(made, single)

    @classmethod
    def from_mrp(cls, mrp: Any) -> Rotation:
        """Of modified Rodrigues parameters."""
        vectors, single = _many(mrp, (3,), 'mrp')
        squares = np.sum(vectors ** 2, axis=1, keepdims=True)
        return cls._of(np.hstack((2 * vectors, 1 - squares)) / (1 + squares), single)

    @classmethod
    def identity(cls, num: int | None = None) -> Rotation:
        made = np.zeros((1 if num is None else num, 4))
        made[:, quaternions.W] = 1
        return cls._of(made, num is None)

    @classmethod
    def random(cls, num: int | None = None, random_state: Any = None) -> Rotation:
        source: Any = np.random if random_state is None else random_state
        if isinstance(random_state, (int, np.integer)):
            source = np.random.RandomState(random_state)
        return cls(source.normal(size=4 if num is None else (num, 4)))

    @classmethod
    def concatenate(cls, rotations: Iterable[Rotation]) -> Rotation:
        return cls._of(np.concatenate([one._quat for one in rotations]), False)

    @classmethod
    def align_vectors(
        cls, a: Any, b: Any, weights: Any = None, return_sensitivity: bool = False
    ) -> tuple[Rotation, float] | tuple[Rotation, float, Any]:
        """That turns the vectors b best onto a, and the root of the weighted squares that are left."""
        to, of = np.atleast_2d(np.asarray(a, dtype=float)), np.atleast_2d(np.asarray(b, dtype=float))
        if to.shape != of.shape or to.shape[1] != 3:
            raise ValueError(f'`a` and `b` have the shapes {to.shape} and {of.shape}, not the same (N, 3)')
        weight = _weights(weights, len(of))
        shares = np.einsum('n,ni,nj->ij', weight, to, of)
        left, sizes, right = np.linalg.svd(shares)
        if np.linalg.det(left @ right) < 0:
            sizes[-1], left[:, -1] = -sizes[-1], -left[:, -1]
        rest = np.sum(weight * np.sum(to ** 2 + of ** 2, axis=1)) - 2 * sizes.sum()
        made, rssd = cls.from_matrix(left @ right), float(np.sqrt(max(rest, 0)))
        if not return_sensitivity:
            return made, rssd
        zeta = (sizes[0] + sizes[1]) * (sizes[1] + sizes[2]) * (sizes[2] + sizes[0])
        kappa = sizes[0] * sizes[1] + sizes[1] * sizes[2] + sizes[2] * sizes[0]
        moment = left @ np.diag(sizes) @ left.T
        return made, rssd, np.mean(weight) / zeta * (kappa * np.eye(3) + moment @ moment.T)

    # ---- to other forms

    def _shown(self, values: Any) -> Any:
        return values[0] if self._single else values

    def as_quat(self, canonical: bool = False, *, scalar_first: bool = False) -> Any:
        """`canonical`: of the two that mean the same the one whose first of w, x, y, z that is not 0 is positive."""
        quat = self._quat.copy()
        if canonical:
            ordered = np.roll(quat, 1, axis=1)
            leading = ordered[np.arange(len(quat)), np.argmax(ordered != 0, axis=1)]
            quat[leading < 0] *= -1
        return self._shown(np.roll(quat, 1, axis=1) if scalar_first else quat)

    def as_matrix(self) -> Any:
        return self._shown(quaternions.to_matrices(self._quat))

    def as_rotvec(self, degrees: bool = False) -> Any:
        vectors = quaternions.to_vectors(self._quat)
        return self._shown(np.degrees(vectors) if degrees else vectors)

    def as_euler(self, seq: str, degrees: bool = False) -> Any:
        axes, extrinsic = _sequence(seq, (3,))
        angles = quaternions.to_angles(self._quat, axes, extrinsic)
        return self._shown(np.degrees(angles) if degrees else angles)

    def as_mrp(self) -> Any:
        shorter = np.where(self._quat[:, quaternions.W:] < 0, -self._quat, self._quat)
        return self._shown(shorter[:, :quaternions.W] / (1 + shorter[:, quaternions.W:]))

    # ---- what they do

    def apply(self, vectors: Any, inverse: bool = False) -> Any:
        """Turn one vector or several."""
        given, one = _many(vectors, (3,), 'vectors')
        matrices = quaternions.to_matrices(self._quat)
        count = _paired(len(matrices), len(given), 'vectors')
        turned = np.einsum('nji,nj->ni' if inverse else 'nij,nj->ni',
                           np.broadcast_to(matrices, (count, 3, 3)), np.broadcast_to(given, (count, 3)))
        return turned[0] if one and self._single else turned

    def inv(self) -> Rotation:
        return self._of(self._quat * (-1, -1, -1, 1), self._single)

    def magnitude(self) -> Any:
        """Angles, of 0 to half a turn."""
        lengths = np.linalg.norm(self._quat[:, :quaternions.W], axis=1)
        return self._shown(2 * np.arctan2(lengths, np.abs(self._quat[:, quaternions.W])))

    def approx_equal(self, other: Rotation, atol: float | None = None, degrees: bool = False) -> Any:
        limit = 1e-8 if atol is None else np.radians(atol) if degrees else atol
        return (other * self.inv()).magnitude() < limit

    def mean(self, weights: Any = None) -> Rotation:
        weight = _weights(weights, len(self._quat))
        _, vectors = np.linalg.eigh((weight * self._quat.T) @ self._quat)
        return self._of(vectors[:, -1][None], True)

    def __mul__(self, other: Rotation) -> Rotation:
        if not isinstance(other, Rotation):
            return NotImplemented
        _paired(len(self._quat), len(other._quat), 'rotations')
        made = quaternions.normalized(quaternions.product(self._quat, other._quat))
        return self._of(made, self._single and other._single)

    def __pow__(self, n: float, modulus: None = None) -> Rotation:
        if modulus is not None:
            raise NotImplementedError('there is no power of rotations with a modulus')
        if n == 0:
            return self.identity(None if self._single else len(self._quat))
        if n == -1:
            return self.inv()
        if n == 1:
            return self._of(self._quat.copy(), self._single)
        return self.from_rotvec(n * self.as_rotvec())

    # ---- as a sequence

    @property
    def single(self) -> bool:
        return self._single

    def __bool__(self) -> bool:
        return True

    def __len__(self) -> int:
        if self._single:
            raise TypeError('a single rotation has no len()')
        return len(self._quat)

    def __getitem__(self, indexer: Any) -> Rotation:
        if self._single:
            raise TypeError('a single rotation is not subscriptable')
        return type(self)(self._quat[indexer], normalize=False)

    def __setitem__(self, indexer: Any, value: Rotation) -> None:
        if self._single:
            raise TypeError('a single rotation is not subscriptable')
        if not isinstance(value, Rotation):
            raise TypeError(f'{type(value)!r} is not a Rotation')
        self._quat[indexer] = value.as_quat()

    def __repr__(self) -> str:
        return f'Rotation.from_matrix({self.as_matrix()!r})'
