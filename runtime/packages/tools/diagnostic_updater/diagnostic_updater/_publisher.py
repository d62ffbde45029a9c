"""Tasks of topics: how often something is published, with what stamps."""
from __future__ import annotations

from typing import Any

from diagnostic_updater._diagnostic_updater import CompositeDiagnosticTask, Updater
from diagnostic_updater._update_functions import (
    FrequencyStatus, FrequencyStatusParam, TimeStampStatus, TimeStampStatusParam,
)
from rclpy.time import Time


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """How often messages without a header are published."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam) -> None:
        super().__init__(f'{name} topic status')
        self.diag = diag
        self.freq = FrequencyStatus(freq)
        self.addTask(self.freq)
        diag.add(self)

    def tick(self) -> None:
        """One was published."""
        self.freq.tick()

    def clear_window(self) -> None:
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """How often messages are published, and how old they are."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(name, diag, freq)
        self.stamp = TimeStampStatus(stamp)
        self.addTask(self.stamp)

    def tick(self, stamp: Any) -> None:  # type: ignore[override]
        """One with this stamp was published."""
        self.stamp.tick(stamp)
        super().tick()


class DiagnosedPublisher(TopicDiagnostic):
    """A publisher that takes note of what it publishes."""

    def __init__(self, pub: Any, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(pub.topic_name, diag, freq, stamp)
        self.publisher = pub

    def publish(self, message: Any) -> None:
        """A message with a header."""
        self.tick(Time.from_msg(message.header.stamp))
        self.publisher.publish(message)
