"""Counts changes of what there is to execute, so that executors look at their nodes only when something changed."""
from __future__ import annotations


class Changes:
    def __init__(self) -> None:
        self.count = 0

    def add(self) -> None:
        self.count += 1


changes = Changes()
