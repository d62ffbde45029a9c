"""What a bag says of itself."""
from __future__ import annotations

import os

from rosbag2_py import _metadata_yaml
from rosbag2_py._reader import open_file
from rosbag2_py._storage import BagMetadata


class Info:
    def read_metadata(self, uri: str, storage_id: str) -> BagMetadata:
        """Of a folder or a file. RuntimeError: it is not a bag."""
        if not os.path.exists(uri):
            raise RuntimeError(f'Bag path {uri} does not exist.')
        if _metadata_yaml.is_there(uri):
            return _metadata_yaml.read(uri)
        if os.path.isdir(uri):
            raise RuntimeError(f'Could not find metadata in bag directory {uri}')
        file = open_file(uri, storage_id)
        if file is None:
            raise RuntimeError(f'No plugin detected that could open file {uri}')
        return file.metadata()
