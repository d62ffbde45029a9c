"""Lookups in random trees of frames that move, against matrices that are multiplied from the root down."""
from __future__ import annotations

import importlib
import math
import random
import unittest
from typing import Any

from tests.unit.rclpy.installation import install, install_host
from tests.unit.tf2_py.frames import NS, at

SEEDS, LOOKUPS, TIMES = 25, 20, 6
Matrix = list[list[float]]


def product(a: Matrix, b: Matrix) -> Matrix:
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def transposed(a: Matrix) -> Matrix:
    return [list(column) for column in zip(*a)]


def about(axis: list[float], angle: float) -> Matrix:
    """The rotation about an axis (Rodrigues)."""
    length = math.sqrt(sum(x * x for x in axis)) or 1.0
    x, y, z = (one / length for one in axis)
    skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
    twice = product(skew, skew)
    return [[(i == j) + math.sin(angle) * skew[i][j] + (1 - math.cos(angle)) * twice[i][j] for j in range(3)]
            for i in range(3)]


def part_of(a: Matrix, b: Matrix, ratio: float) -> Matrix:
    """On the way from one rotation to another."""
    step = product(transposed(a), b)
    angle = math.acos(max(-1.0, min(1.0, (step[0][0] + step[1][1] + step[2][2] - 1) / 2)))
    axis = [step[2][1] - step[1][2], step[0][2] - step[2][0], step[1][0] - step[0][1]]
    return product(a, about(axis, ratio * angle))


class Place:
    """A rotation and a shift."""

    def __init__(self, rotation: Matrix, shift: list[float]) -> None:
        self.rotation, self.shift = rotation, shift

    def then(self, inner: Place) -> Place:
        moved = [row[0] for row in product(self.rotation, [[x] for x in inner.shift])]
        return Place(product(self.rotation, inner.rotation), [a + b for a, b in zip(self.shift, moved)])

    def inverse(self) -> Place:
        back = transposed(self.rotation)
        return Place(back, [-row[0] for row in product(back, [[x] for x in self.shift])])


class RandomTreesTest(unittest.TestCase):
    tf2: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'tf2_py')
        install_host(cls)
        cls.tf2 = importlib.import_module('tf2_py')

    def put(self, buffer: Any, parent: str, child: str, second: int, is_static: bool) -> Place:
        axis = [random.uniform(-1, 1) for _ in range(3)]
        # Turns of less than half a circle from one time to the next: the shorter way is the one that is meant.
        angle = random.uniform(-1.4, 1.4)
        shift = [random.uniform(-5, 5) for _ in range(3)]
        message = importlib.import_module('geometry_msgs.msg').TransformStamped(child_frame_id=child)
        message.header.frame_id, message.header.stamp.sec = parent, second
        where = message.transform
        where.translation.x, where.translation.y, where.translation.z = shift
        length = math.sqrt(sum(x * x for x in axis))
        where.rotation.x, where.rotation.y, where.rotation.z = (x / length * math.sin(angle / 2) for x in axis)
        where.rotation.w = math.cos(angle / 2)
        (buffer.set_transform_static if is_static else buffer.set_transform)(message, 'test')
        return Place(about(axis, angle), shift)

    def place(self, frame: str, parents: dict[str, str], told: dict[str, list[Place]], seconds: float) -> Place:
        """In the root, at a time."""
        if frame not in parents:
            return Place(about([1, 0, 0], 0), [0, 0, 0])
        places = told[frame]
        here = places[0]
        if len(places) > 1:
            index = min(int(seconds), TIMES - 1)
            a, b, ratio = places[index - 1], places[index], seconds - index
            here = Place(part_of(a.rotation, b.rotation, ratio),
                         [x * (1 - ratio) + y * ratio for x, y in zip(a.shift, b.shift)])
        return self.place(parents[frame], parents, told, seconds).then(here)

    def test_lookups(self) -> None:
        for seed in range(SEEDS):
            with self.subTest(seed=seed):
                random.seed(seed)
                self.compare()

    def compare(self) -> None:
        buffer = self.tf2.BufferCore()
        frames = [f'frame{i}' for i in range(random.randint(2, 12))]
        parents: dict[str, str] = {}
        told: dict[str, list[Place]] = {}
        for i, frame in enumerate(frames[1:], 1):
            parents[frame] = random.choice(frames[:i])
            is_static = random.random() < 0.3
            told[frame] = [self.put(buffer, parents[frame], frame, second, is_static)
                           for second in range(1, 2 if is_static else TIMES + 1)]
        for _ in range(LOOKUPS):
            target, source = random.choice(frames), random.choice(frames)
            seconds = random.choice([random.uniform(1, TIMES), float(random.randint(1, TIMES))])
            found = buffer.lookup_transform_core(target, source, at(seconds)).transform
            # The time in the buffer's lookup is a whole number of nanoseconds.
            seconds = round(seconds * NS) / NS
            wanted = self.place(target, parents, told, seconds).inverse().then(
                self.place(source, parents, told, seconds))
            x, y, z, w = found.rotation.x, found.rotation.y, found.rotation.z, found.rotation.w
            self.assertAlmostEqual(x * x + y * y + z * z + w * w, 1)
            rotation = about([x, y, z], 2 * math.atan2(math.sqrt(x * x + y * y + z * z), w))
            for i in range(3):
                self.assertAlmostEqual((found.translation.x, found.translation.y, found.translation.z)[i],
                                       wanted.shift[i], 6)
                for j in range(3):
                    self.assertAlmostEqual(rotation[i][j], wanted.rotation[i][j], 6)


if __name__ == '__main__':
    unittest.main()
