"""Where an included launch file in YAML is."""
from __future__ import annotations

from launch.launch_description_sources import FrontendLaunchDescriptionSource


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    pass
