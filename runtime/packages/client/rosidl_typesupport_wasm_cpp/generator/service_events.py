"""Gives every service the event message that it has in Jazzy; Debian's rosidl 3.3.1 knows of none.

Importing this module adds `event_message` to a parsed service and lets the templates beside this file go
before Debian's; run as a script, it runs the generator named first, mended.
"""

from pathlib import Path
import runpy
import sys
from typing import Set

import own_constants  # noqa: F401: the parser is mended
from rosidl_parser import definition as idl
import rosidl_pycommon
from rosidl_pycommon import convert_camel_case_to_lower_case_underscore as snake_case

EVENT_SUFFIX = '_Event'


def event_message(service: idl.Service) -> idl.Message:
    """Return what those who watch a service are told: facts, and at most one request or response."""
    name = service.namespaced_type
    parts = {'request': service.request_message, 'response': service.response_message}
    return idl.Message(idl.Structure(
        idl.NamespacedType(name.namespaces, name.name + EVENT_SUFFIX),
        members=[
            idl.Member(idl.NamespacedType(['service_msgs', 'msg'], 'ServiceEventInfo'), 'info'),
            *(idl.Member(idl.BoundedSequence(part.structure.namespaced_type, 1), field)
              for field, part in parts.items()),
        ]))


def own_headers(service: idl.Service, kind: str) -> Set[str]:
    """Return the headers that a template would include for request and response.

    They do not exist: both types are in the header that is being written.
    """
    name = service.namespaced_type
    folder = '/'.join([*name.namespaces, 'detail'])
    return {f'{folder}/{snake_case(name.name + part)}__{kind}.hpp'
            for part in ('_Request', '_Response')}


idl.Service.event_message = property(event_message)
rosidl_pycommon.template_prefix_path.insert(0, Path(__file__).parent / 'templates')

if __name__ == '__main__':
    del sys.argv[0]
    runpy.run_path(sys.argv[0], run_name='__main__')
