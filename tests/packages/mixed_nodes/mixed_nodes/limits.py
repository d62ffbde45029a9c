"""The limits in the package's share folder."""
import json
import os

from ament_index_python.packages import get_package_share_directory


def highest() -> float:
    path = os.path.join(get_package_share_directory('mixed_nodes'), 'config', 'limits.json')
    with open(path, encoding='utf-8') as stream:
        return float(json.load(stream)['highest'])
