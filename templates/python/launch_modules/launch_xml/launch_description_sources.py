"""Where an included launch file in XML is."""
from __future__ import annotations

from launch.launch_description_sources import FrontendLaunchDescriptionSource


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    pass
