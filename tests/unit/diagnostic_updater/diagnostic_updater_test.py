"""Diagnostics of Python nodes, heard on /diagnostics."""
from __future__ import annotations

import importlib
import sys
import unittest
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest
from tests.unit.rclpy.installation import ROOT

# Compatibility, works: diagnostic_updater for Python: Updater, tasks of functions and composed ones, frequency and time
# stamp status, Heartbeat, diagnosed publishers


class DiagnosticUpdaterTest(BusTest):
    updater: Any
    message: Any

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        package = ROOT / 'runtime/packages/tools/diagnostic_updater'
        cls.enterClassContext(mock.patch.object(sys, 'path', [str(package), *sys.path]))
        cls.updater = importlib.import_module('diagnostic_updater')
        cls.message = importlib.import_module('diagnostic_msgs.msg')

    def setUp(self) -> None:
        super().setUp()
        self.own = self.node('device')
        self.heard: list[Any] = []
        self.own.create_subscription(self.message.DiagnosticArray, '/diagnostics', self.heard.append, 10)
        self.status = self.message.DiagnosticStatus

    def summary(self, stat: Any) -> tuple[bytes, str]:
        return stat.level, stat.message

    def statuses(self, count: int) -> list[Any]:
        self.spin_until(lambda: sum(len(one.status) for one in self.heard) >= count)
        return [status for one in self.heard for status in one.status]

    def test_tasks_are_published_when_they_are_added_and_when_they_run(self) -> None:
        updater = self.updater.Updater(self.own, period=1000.0)
        updater.setHardwareID('arm 7')

        def temperature(stat: Any) -> Any:
            stat.summary(self.status.WARN, 'warm')
            stat.add('degrees', '51')
            return stat
        updater.add('Temperature', temperature)
        updater.add(self.updater.Heartbeat())
        updater.force_update()
        found = self.statuses(4)
        self.assertEqual([(one.name, one.level, one.message, one.hardware_id) for one in found], [
            ('device: Temperature', b'\x00', 'Node starting up', ''),
            ('device: Heartbeat', b'\x00', 'Node starting up', ''),
            ('device: Temperature', b'\x01', 'warm', 'arm 7'), ('device: Heartbeat', b'\x00', 'Alive', 'arm 7')])
        self.assertEqual([(one.key, one.value) for one in found[2].values], [('degrees', '51')])
        self.assertTrue(updater.removeByName('Temperature'))
        self.assertFalse(updater.removeByName('Temperature'))
        updater.broadcast(self.status.STALE, 'ends')
        self.assertEqual(self.summary(self.statuses(5)[4]), (b'\x03', 'ends'))

    def test_it_runs_at_its_period_which_may_change(self) -> None:
        updater = self.updater.Updater(self.own, period=0.01)
        updater.add(self.updater.Heartbeat())
        self.statuses(4)
        self.assertEqual(self.own.get_parameter('diagnostic_updater.period').value, 0.01)
        updater.period = 0.02
        self.assertEqual((updater.period, updater.timer.timer_period_ns), (0.02, 20_000_000))
        self.assertIn(updater.timer, list(self.own.timers))

    def test_a_composed_task_has_the_worst_level_and_the_messages_of_what_is_wrong(self) -> None:
        task = self.updater.CompositeDiagnosticTask('both')
        wrapper = self.updater.DiagnosticStatusWrapper
        for level, message in ((self.status.WARN, 'first'), (self.status.OK, 'fine'), (self.status.ERROR, 'last')):
            def fill(stat: Any, level: bytes = level, message: str = message) -> Any:
                stat.summary(level, message)
                return stat
            task.addTask(self.updater.FunctionDiagnosticTask(message, fill))
        self.assertEqual(self.summary(task.run(wrapper())), (b'\x02', 'first; last'))
        status = wrapper()
        status.summary(self.status.ERROR, 'no')
        status.clearSummary()
        status.mergeSummary(self.status(level=b'\x00', message='yes'))
        self.assertEqual(self.summary(status), (b'\x00', 'yes'))

    def test_how_often_and_how_old(self) -> None:
        wrapper = self.updater.DiagnosticStatusWrapper
        updater = self.updater.Updater(self.own, period=1000.0)
        header = importlib.import_module('std_msgs.msg').Header
        stamped = importlib.import_module('geometry_msgs.msg').PointStamped
        bound = {'min': 0.001, 'max': 1e9}
        publisher = self.updater.DiagnosedPublisher(
            self.own.create_publisher(stamped, 'points', 1), updater, self.updater.FrequencyStatusParam(bound, 0.0, 2),
            self.updater.TimeStampStatusParam())
        self.assertEqual(publisher.getName(), '/points topic status')
        stat = publisher.run(wrapper())
        self.assertEqual(self.summary(stat), (b'\x02', 'No events recorded.; No data since last update.'))
        publisher.publish(stamped(header=header(stamp=self.own.get_clock().now().to_msg())))
        stat = publisher.run(wrapper())
        self.assertEqual(stat.level, b'\x00', stat.message)
        values = {one.key: one.value for one in stat.values}
        self.assertEqual((values['Events in window'], values['Minimum acceptable frequency (Hz)']), ('1', '0.001000'))
        publisher.publish(stamped(header=header(stamp=importlib.import_module('rclpy.time').Time(seconds=5).to_msg())))
        bound['min'] = 1e8
        stat = publisher.run(wrapper())
        self.assertEqual(self.summary(stat), (b'\x02', 'Frequency too low.; Timestamps too far in past seen.'))
        publisher.clear_window()
        self.assertEqual(publisher.freq.count, 0)


if __name__ == '__main__':
    unittest.main()
