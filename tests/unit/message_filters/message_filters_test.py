"""Filters of Python nodes, fed by hand."""
from __future__ import annotations

import importlib
import random
import unittest
import unittest.mock
from types import SimpleNamespace
from typing import Any

from tests.unit.rclpy.installation import install, install_host

# Compatibility, works: message_filters for Python: Subscriber, Cache, Chain, TimeSynchronizer,
# ApproximateTimeSynchronizer, TimeSequencer

NS = 1_000_000_000


class MessageFiltersTest(unittest.TestCase):
    filters: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'message_filters')
        install_host(cls)
        cls.filters = importlib.import_module('message_filters')

    def setUp(self) -> None:
        self.got: list[tuple[Any, ...]] = []

    def collect(self, *messages: Any) -> None:
        self.got.append(messages)

    def inputs(self, count: int) -> list[Any]:
        return [self.filters.SimpleFilter() for _ in range(count)]

    def message(self, seconds: float, name: str = '') -> Any:
        header = importlib.import_module('std_msgs.msg').Header(frame_id=name)
        header.stamp.sec, header.stamp.nanosec = divmod(round(seconds * NS), NS)
        return SimpleNamespace(header=header)

    def time(self, seconds: float) -> Any:
        return importlib.import_module('rclpy.time').Time.from_msg(self.message(seconds).header.stamp)

    def test_a_filter_passes_messages_and_arguments(self) -> None:
        one, = self.inputs(1)
        self.assertEqual([one.registerCallback(self.collect, 'x', 2), one.registerCallback(self.collect)], [0, 1])
        one.signalMessage('m')
        self.assertEqual(self.got, [('m', 'x', 2), ('m',)])

    def test_a_subscriber_is_a_subscription(self) -> None:
        made: list[Any] = []

        def create_subscription(*args: Any, **kwargs: Any) -> Any:
            made.append((args, kwargs))
            return SimpleNamespace(handle=7)
        node = SimpleNamespace(create_subscription=create_subscription)
        subscriber = self.filters.Subscriber(node, str, 'topic')
        other = self.filters.Subscriber(node, str, 'topic', qos_profile=3, raw=True)
        self.assertEqual(made, [((str, 'topic', subscriber.callback), {'qos_profile': 10}),
                                ((str, 'topic', other.callback), {'qos_profile': 3, 'raw': True})])
        subscriber.registerCallback(self.collect)
        subscriber.callback('m')
        self.assertEqual((self.got, subscriber.getTopic(), subscriber.handle), ([('m',)], 'topic', 7))
        with self.assertRaises(AttributeError):
            subscriber.no_such_thing

    def test_a_cache_keeps_the_last(self) -> None:
        source, = self.inputs(1)
        cache = self.filters.Cache(source, 5)
        self.assertEqual((cache.getLast(), cache.getLastestTime(), cache.getOldestTime()), (None, None, None))
        messages = [self.message(t) for t in range(5)]
        for message in messages:
            source.signalMessage(message)
        self.assertEqual(cache.getInterval(self.time(2.5), self.time(3.5)), messages[3:4])
        self.assertEqual(cache.getInterval(self.time(2), self.time(3)), messages[2:4])
        self.assertEqual(cache.getElemAfterTime(self.time(0.5)), messages[1])
        self.assertEqual(cache.getElemBeforeTime(self.time(3.5)), messages[3])
        self.assertIsNone(cache.getElemAfterTime(self.time(9)))
        source.signalMessage(self.message(5))
        self.assertEqual((cache.getOldestTime(), cache.getLastestTime()), (self.time(1), self.time(5)))
        with unittest.mock.patch('message_filters.stamps.get_logger') as logger:
            source.signalMessage('no header')
        self.assertRegex(logger.return_value.warning.call_args[0][0], 'allow_headerless')
        self.assertEqual(cache.getLastestTime(), self.time(5))
        self.filters.Cache(source, 1, allow_headerless=True).registerCallback(self.collect)
        source.signalMessage('no header')
        self.assertEqual(self.got, [('no header',)])

    def test_a_chain(self) -> None:
        source, = self.inputs(1)
        chain = self.filters.Chain(source)
        chain.registerCallback(self.collect)
        source.signalMessage(self.message(1))
        caches = [self.filters.Cache(self.filters.SimpleFilter(), size) for size in (1, 2)]
        for cache in caches:
            chain.addFilter(cache)
        source.signalMessage(self.message(2))
        self.assertEqual([len(self.got), len(caches[0].cache_msgs), len(caches[1].cache_msgs)], [2, 1, 1])
        self.assertIs(chain.getFilter(1), caches[1])
        with self.assertRaisesRegex(RuntimeError, 'Already connected'):
            chain.connectInput(source)

    def test_messages_of_one_time(self) -> None:
        random.seed(1)
        for count in range(1, 10):
            one, two = self.inputs(2)
            self.filters.TimeSynchronizer([one, two], count).registerCallback(self.collect)
            first, second = ([self.message(t) for t in range(count)] for _ in range(2))
            self.got.clear()
            for message in random.sample(first, count):
                one.signalMessage(message)
            self.assertEqual(self.got, [])
            for message in second:
                two.signalMessage(message)
            self.assertEqual(self.got, list(zip(first, second)))

    def test_what_is_older_than_a_pair_is_dropped(self) -> None:
        one, two = self.inputs(2)
        self.filters.TimeSynchronizer([one, two], 10).registerCallback(self.collect)
        for source, seconds in ((one, 0), (two, 1), (one, 1), (two, 0)):
            source.signalMessage(self.message(seconds))
        self.assertEqual([message.header.stamp.sec for pair in self.got for message in pair], [1, 1])

    def test_a_queue_is_only_so_long(self) -> None:
        one, two = self.inputs(2)
        self.filters.TimeSynchronizer([one, two], 2).registerCallback(self.collect)
        for seconds in (1, 2, 3):
            one.signalMessage(self.message(seconds))
        two.signalMessage(self.message(1))
        self.assertEqual(self.got, [])
        two.signalMessage(self.message(2))
        self.assertEqual(len(self.got), 1)

    def test_messages_of_about_one_time(self) -> None:
        one, two, three = self.inputs(3)
        self.filters.ApproximateTimeSynchronizer([one, two, three], 10, 0.1).registerCallback(self.collect)
        late, near = self.message(1.09, 'late'), self.message(1.02, 'near')
        one.signalMessage(late)
        one.signalMessage(near)
        two.signalMessage(self.message(1.0, 'two'))
        self.assertEqual(self.got, [])
        three.signalMessage(self.message(0.95, 'three'))
        self.assertEqual([[m.header.frame_id for m in set_] for set_ in self.got], [['near', 'two', 'three']])
        two.signalMessage(self.message(1.1))
        three.signalMessage(self.message(1.2))  # just as far from the first as the slop
        self.assertEqual(len(self.got), 1)
        three.signalMessage(self.message(1.1))
        self.assertEqual(self.got[1][0], late)

    def test_scrambled_messages_of_about_one_time(self) -> None:
        random.seed(0)
        for count in range(1, 10):
            one, two = self.inputs(2)
            self.filters.ApproximateTimeSynchronizer([one, two], count, 0.1).registerCallback(self.collect)
            first = [self.message(t) for t in range(count)]
            second = [self.message(t + random.uniform(0, 0.09)) for t in range(count)]
            self.got.clear()
            for source, messages in ((one, first), (two, second)):
                for message in random.sample(messages, count):
                    source.signalMessage(message)
            self.assertCountEqual([tuple(map(id, pair)) for pair in self.got],
                                  [tuple(map(id, pair)) for pair in zip(first, second)])

    def test_messages_that_come_at_about_one_time(self) -> None:
        for options, pairs in (({'sync_arrival_time': True}, 1), ({'allow_headerless': True}, 0), ({}, 0)):
            one, two = self.inputs(2)
            self.got.clear()
            self.filters.ApproximateTimeSynchronizer([one, two], 5, 5, **options).registerCallback(self.collect)
            with unittest.mock.patch('message_filters.stamps.get_logger'):
                one.signalMessage('no header')
                two.signalMessage(self.message(1))
            self.assertEqual(len(self.got), pairs, options)

    def test_messages_in_the_order_of_time(self) -> None:
        now = [10.0]
        node = SimpleNamespace(create_timer=lambda period, callback: SimpleNamespace(period=period, fire=callback),
                               get_clock=lambda: SimpleNamespace(now=lambda: self.time(now[0])))
        source, = self.inputs(1)
        sequencer = self.filters.TimeSequencer(source, 1.0, 0.01, 3, node)
        sequencer.registerCallback(lambda message: self.got.append(message.header.stamp.sec))
        for seconds in (8, 10, 9):
            source.signalMessage(self.message(seconds))
        sequencer.update_timer.fire()
        self.assertEqual((self.got, sequencer.update_timer.period), ([8, 9], 0.01))
        source.signalMessage(self.message(7))
        now[0] = 20
        sequencer.update_timer.fire()
        self.assertEqual(self.got, [8, 9, 10])


if __name__ == '__main__':
    unittest.main()
