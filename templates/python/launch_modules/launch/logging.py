"""Lines that launch files say while they are read."""
from __future__ import annotations

import logging
from typing import Any


def get_logger(name: str | None = None) -> logging.Logger:
    return logging.getLogger(name or 'launch')


class _Config:
    """Where lines go natively; here the evaluator's caller shows them."""

    log_dir = '/home/user/.ros/log'
    level = logging.INFO

    def __setattr__(self, name: str, value: Any) -> None:
        self.__dict__[name] = value


launch_config = _Config()
