"""Tasks, and who runs and publishes them."""
from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from diagnostic_updater._diagnostic_status_wrapper import DiagnosticStatusWrapper

Fill = Callable[[DiagnosticStatusWrapper], DiagnosticStatusWrapper]


class DiagnosticTask:
    """Reports on one part of a node."""

    def __init__(self, name: str) -> None:
        self.name = name

    def getName(self) -> str:
        return self.name

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Fill the status in, and return it."""
        return stat


class FunctionDiagnosticTask(DiagnosticTask):
    """Calls a function."""

    def __init__(self, name: str, fn: Fill) -> None:
        super().__init__(name)
        self.fn = fn

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        return self.fn(stat)


class CompositeDiagnosticTask(DiagnosticTask):
    """Several tasks that report as one: the worst level, the messages joined."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.tasks: list[DiagnosticTask] = []

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        level, message = stat.level, stat.message
        merged = DiagnosticStatusWrapper()
        for task in self.tasks:
            # Each begins with what the composite began with.
            stat.summary(level, message)
            stat = task.run(stat)
            merged.mergeSummary(stat)
        stat.summary(merged)
        return stat

    def addTask(self, t: DiagnosticTask) -> None:
        self.tasks.append(t)


class DiagnosticTaskVector:
    """Tasks by name."""

    class DiagnosticTaskInternal:
        def __init__(self, name: str, fn: Fill) -> None:
            self.name = name
            self.fn = fn

        def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
            stat.name = self.name
            return self.fn(stat)

    def __init__(self) -> None:
        self.tasks: list[DiagnosticTaskVector.DiagnosticTaskInternal] = []
        self.lock = threading.Lock()

    def addedTaskCallback(self, task: DiagnosticTaskInternal) -> None:
        """Called with each task that is added."""

    def add(self, *args: Any) -> None:
        """A DiagnosticTask, or a name and a function."""
        name, fn = (args[0].getName(), args[0].run) if len(args) == 1 else args
        task = self.DiagnosticTaskInternal(name, fn)
        with self.lock:
            self.tasks.append(task)
            self.addedTaskCallback(task)

    def removeByName(self, name: str) -> bool:
        """Remove the first of that name. False: there is none."""
        with self.lock:
            for task in self.tasks:
                if task.name == name:
                    self.tasks.remove(task)
                    return True
        return False


class Updater(DiagnosticTaskVector):
    """Runs its tasks at a period, and publishes on /diagnostics."""

    def __init__(self, node: Any, period: float = 1.0) -> None:
        super().__init__()
        self.node = node
        self.publisher = node.create_publisher(DiagnosticArray, '/diagnostics', 1)
        self.period_parameter = 'diagnostic_updater.period'
        self._period = float(node.declare_parameter(self.period_parameter, period).value)
        self.timer = node.create_timer(self._period, self.update)
        self.verbose = False
        self.hwid = ''
        self.warn_nohwid_done = False
        self.use_fqn_parameter = 'diagnostic_updater.use_fqn'
        if not node.has_parameter(self.use_fqn_parameter):
            node.declare_parameter(self.use_fqn_parameter, False)
        full = node.get_parameter(self.use_fqn_parameter).value
        self.node_name = '/'.join([node.get_namespace(), node.get_name()]) if full else node.get_name()

    def update(self) -> None:
        """Run all tasks, and publish what they say."""
        statuses = []
        with self.lock:
            for task in self.tasks:
                status = DiagnosticStatusWrapper(
                    level=DiagnosticStatus.ERROR, name=task.name, message='No message was set', hardware_id=self.hwid)
                statuses.append(task.run(status))
        wrong = [one for one in statuses if one.level != DiagnosticStatus.OK]
        if self.verbose:
            for one in wrong:
                self.node.get_logger().warn(
                    f'Non-zero diagnostic status. Name: {one.name}, status {one.level!r}: {one.message}')
        if not self.hwid and not wrong and not self.warn_nohwid_done:
            self.node.get_logger().warn(
                'diagnostic_updater: No HW_ID was set. This is probably a bug. Please report it. '
                "For devices that do not have a HW_ID, set this value to 'none'. This warning "
                'only occurs once all diagnostics are OK. It is okay to wait until the device is '
                'open before calling setHardwareID.')
            self.warn_nohwid_done = True
        self.publish(statuses)

    @property
    def period(self) -> float:
        return self._period

    @period.setter
    def period(self, period: float) -> None:
        self._period = period
        self.node.destroy_timer(self.timer)
        self.timer = self.node.create_timer(period, self.update)

    def force_update(self) -> None:
        """Do not wait for the period."""
        self.update()

    def broadcast(self, lvl: bytes, msg: str) -> None:
        """The same for all tasks, as when the node ends."""
        statuses = []
        for task in self.tasks:
            status = DiagnosticStatusWrapper(name=task.name)
            status.summary(lvl, msg)
            statuses.append(status)
        self.publish(statuses)

    def setHardwareID(self, hwid: str) -> None:
        self.hwid = hwid

    def publish(self, msg: Any) -> None:
        """One status or a list of them."""
        statuses = msg if isinstance(msg, list) else [msg]
        message = DiagnosticArray()
        message.header.stamp = self.node.get_clock().now().to_msg()
        for status in statuses:
            status.name = f'{self.node_name}: {status.name}'
            message.status.append(DiagnosticStatus(
                level=status.level, name=status.name, message=status.message, hardware_id=status.hardware_id,
                values=status.values))
        self.publisher.publish(message)

    def addedTaskCallback(self, task: DiagnosticTaskVector.DiagnosticTaskInternal) -> None:
        """Who looks at diagnostics learns of a task before it has run."""
        status = DiagnosticStatusWrapper(name=task.name)
        status.summary(DiagnosticStatus.OK, 'Node starting up')
        self.publish(status)
