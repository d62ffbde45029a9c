"""The folders that packages export to Gazebo, for the launch files of gazebo_ros and ros_gz_sim."""
from __future__ import annotations

from xml.etree import ElementTree

from ament_index_python.packages import get_packages_with_prefixes


def exported_paths(attribute: str) -> list[str]:
    """Those of `<export><gazebo_ros ATTRIBUTE="${prefix}/models"/></export>`; the prefix is the share folder."""
    found: list[str] = []
    for name, prefix in sorted(get_packages_with_prefixes().items()):
        share = f'{prefix}/share/{name}'
        try:
            with open(f'{share}/package.xml', 'rb') as file:
                text = file.read()
        except OSError:
            continue  # a site has package.xml only where something is exported
        if b'<gazebo_ros' in text:
            found += [export.attrib[attribute].replace('${prefix}', share)
                      for export in ElementTree.fromstring(text).iterfind('export/gazebo_ros')
                      if attribute in export.attrib]
    return found
