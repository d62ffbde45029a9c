"""Every public name of ROS 2's Python packages (Jazzy, Humble) is there with its parameters, or listed with why not."""
from __future__ import annotations

import importlib
import importlib.util
import inspect
import sys
import unittest
import unittest.mock
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.unit.rclpy.installation import install, install_host

# Compatibility, works: the public names of Jazzy's and Humble's rclpy (also for actions and managed nodes), tf2_ros,
# tf2_py, tf2_geometry_msgs, tf2_sensor_msgs, message_filters, sensor_msgs_py, rosbag2_py, rosidl_runtime_py and
# ament_index_python, with names and places of their parameters (Jazzy's), against a list; what is missing has its
# reason there

# Compatibility, differs: rclpy's wait set -> nothing waits on it: a waitable is asked whenever something happened;
# handles of rcl, and some names that only hints of types need, are missing

DEBIAN = '/usr/lib/python3/dist-packages'
NAMES = Path(__file__).with_name('upstream_names.txt')
PACKAGES = ('ament_index_python', 'message_filters', 'rosbag2_py', 'rosidl_runtime_py', 'sensor_msgs_py',
            'tf2_geometry_msgs', 'tf2_py', 'tf2_ros_py', 'tf2_sensor_msgs')

WAIT_SET = 'of waitables on a wait set of rcl, which a site has not'
HANDLE = 'of a handle of rcl, for which the object itself stands'
HINT = 'a name for hints of types alone'
LOGGER = 'of the inside of a logger'
NO_COMPRESSION = 'bags are written uncompressed'
ON_THE_PAGE = "the page's panel Bag and `ros2 bag` record and play"
#: What is missing and why: a name, or all that begin with it when it ends in `*`.
LACKING: dict[str, str] = {
    'ament_index_python.cli*': 'a program for shells',
    'ament_index_python.resources.Set': HINT,
    **{f'{owner}.{name}': WAIT_SET
       for owner in ('rclpy.event_handler.EventHandler', 'rclpy.qos_event.QoSEventHandler')
       for name in ('add_to_wait_set', 'execute', 'get_num_entities', 'is_ready', 'take_data')},
    'rclpy.action.server.ActionServer.notify_goal_done': WAIT_SET,
    'rclpy.client.Client.__init__': HANDLE,
    'rclpy.publisher.Publisher.__init__': HANDLE,
    'rclpy.service.Service.__init__': HANDLE,
    'rclpy.subscription.Subscription.__init__': HANDLE,
    'rclpy.clock.ClockHandle*': HANDLE,
    'rclpy.context.ContextHandle*': HANDLE,
    'rclpy.destroyable*': HANDLE,
    'rclpy.time.TimeHandle': HANDLE,
    'rclpy.duration.DurationType': HANDLE,
    'rclpy.clock.JumpHandlePreCallbackType': HINT,
    'rclpy.clock.TimeJumpDictionary': HINT,
    'rclpy.executors.WaitableEntityType': HINT,
    'rclpy.qos_overriding_options.QoSProfileAttributes': HINT,
    'tf2_ros.buffer.FrameGraphSrv*': HINT,
    'tf2_ros.buffer_client.LookupTransform*': HINT,
    'tf2_ros.buffer_interface.MsgStamped': HINT,
    'tf2_ros.buffer_interface.PyKDLType': HINT,
    'tf2_ros.buffer_interface.TransformableObject*': HINT,
    'rclpy.context.g_logging_configure_lock': LOGGER,
    'rclpy.context.g_logging_ref_count': LOGGER,
    **{f'rclpy.impl.rcutils_logger.{name}*': LOGGER
       for name in ('CallerId', 'LoggingFilter', 'Once', 'SkipFirst', 'Throttle', 'get_filters_from_kwargs',
                    'supported_filters')},
    **{f'rosbag2_py.{name}': NO_COMPRESSION
       for name in ('CompressionMode*', 'CompressionOptions*', 'SequentialCompression*', 'compression_mode_*')},
    **{f'rosbag2_py.{name}': ON_THE_PAGE
       for name in ('Info.read_metadata_and_output_service_verbose', 'PlayOptions', 'Player', 'RecordOptions',
                    'Recorder', 'ServiceRequestsSource')},
    'rosbag2_py.Reindexer': 'a file without index is read as it is',
    'rosbag2_py.bag_rewrite': 'nothing is converted',
    'rclpy.executors.SignalHandlerGuardCondition': 'a stop wakes every wait of a site',
    'rclpy.signals.SignalHandlerGuardCondition*': 'a stop wakes every wait of a site',
    'rclpy.topic_endpoint_info.TopicEndpointInfo.__init__': 'its parameters have names',
    'rclpy.type_description_service.TypeDescriptionService.destroy': 'it ends with its node',
    'rclpy.utilities.g_context_lock': 'one thread runs at a time',
}


def upstream() -> Iterator[tuple[str, str, str | None]]:
    """Module, name in it, parameters."""
    module = ''
    for line in NAMES.read_text(encoding='utf-8').splitlines():
        if line.startswith('['):
            module = line[1:-1]
            yield module, '', None
        elif not line.startswith('#'):
            name, bracket, rest = line.partition('(')
            yield module, name, rest[:-1] if bracket else None


def is_set_by_init(of: type, name: str) -> bool:
    code = getattr(getattr(of, '__init__'), '__code__', None)
    return not hasattr(of, name) and name in getattr(code, 'co_names', ())


def found(module: str, name: str) -> tuple[Any, bool]:
    """What the name stands for, and whether it is called on an object. Raises AttributeError or ImportError."""
    thing: Any = importlib.import_module(module)
    bound = False
    for part in filter(None, name.split('.')):
        if isinstance(thing, type) and is_set_by_init(thing, part):
            return None, False
        bound = isinstance(thing, type) and isinstance(inspect.getattr_static(thing, part), type(lambda: None))
        thing = getattr(thing, part)
    return thing, bound


def parameter_fault(thing: Any, bound: bool, wanted: str) -> str | None:
    """A call that upstream takes must be one that ours takes: same names in the same places."""
    if wanted == '*args, **kwargs':
        return None  # they say nothing
    try:
        ours = list(inspect.signature(thing).parameters.values())[int(bound):]
    except (TypeError, ValueError):
        return None  # of a class that Python's own library makes
    kinds = inspect.Parameter
    by_name = {one.name: one for one in ours}
    any_name = any(one.kind is kinds.VAR_KEYWORD for one in ours)
    any_place = any(one.kind is kinds.VAR_POSITIONAL for one in ours)
    places = [one.name for one in ours if one.kind is kinds.POSITIONAL_OR_KEYWORD]
    asked = [name for name in wanted.split(', ') if name]
    keyword_only = False
    for index, name in enumerate(asked):
        if name.startswith('**'):
            if not any_name:
                return f'takes no {name}'
        elif name.startswith('*'):
            keyword_only = True
            if name != '*' and not any_place:
                return f'takes no {name}'
        elif name not in by_name and not any_name:
            return f'takes no `{name}`'
        elif not keyword_only and places[index:index + 1] != [name] and not any_place:
            return f'`{name}` is at another place'
    extra = [one.name for one in ours if one.name not in asked and one.default is kinds.empty
             and one.kind in (kinds.POSITIONAL_OR_KEYWORD, kinds.KEYWORD_ONLY)]
    return f'asks for {", ".join(extra)}' if extra else None


def fault(module: str, name: str, parameters: str | None) -> str | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')  # of old names
            thing, bound = found(module, name)
    except (AttributeError, ImportError) as error:
        return f'{type(error).__name__}: {error}'
    return None if parameters is None else parameter_fault(thing, bound, parameters)


def excused(name: str) -> str | None:
    return next((key for key in LACKING if name == key or (key.endswith('*') and name.startswith(key[:-1]))), None)


class UpstreamNamesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        install(cls, *PACKAGES)
        install_host(cls)
        cls.enterClassContext(unittest.mock.patch.object(sys, 'path', [*sys.path, DEBIAN]))
        if importlib.util.find_spec('numpy') is None:  # names are all that is looked at
            cls.enterClassContext(unittest.mock.patch.dict(sys.modules, {'numpy': unittest.mock.MagicMock()}))

    def test_every_name_is_there_or_excused(self) -> None:
        faults, used = [], set()
        count = 0
        for module, name, parameters in upstream():
            count += 1
            told = fault(module, name, parameters)
            whole = f'{module}.{name}'.rstrip('.')
            excuse = excused(whole)
            if told and excuse is None:
                faults.append(f'{whole}: {told}')
            if told and excuse:
                used.add(excuse)
        self.assertGreater(count, 1000)
        self.assertEqual(faults, [])
        self.assertEqual(set(LACKING) - used, set(), 'these are there by now')

    def test_a_missing_name_and_a_wrong_signature_are_seen(self) -> None:
        self.assertIn('AttributeError', fault('rclpy.node', 'Node.create_nothing', '') or '')
        self.assertIn('ModuleNotFoundError', fault('rclpy.nothing', '', None) or '')
        self.assertEqual(fault('rclpy.node', 'Node.create_publisher', 'topic, msg_type'), '`topic` is at another place')
        self.assertEqual(
            fault('rclpy.node', 'Node.create_publisher', 'msg_type, topic, qos_profile, *, colour'),
            'takes no `colour`')
        self.assertEqual(fault('rclpy.node', 'Node.create_publisher', 'msg_type'), 'asks for topic, qos_profile')


if __name__ == '__main__':
    unittest.main()
