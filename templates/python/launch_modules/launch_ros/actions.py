"""launch_ros's actions."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.action import Action
from launch.actions import ExecuteProcess, TimerAction
from ros2wasm_launch import host
from ros2wasm_launch.entities import Entity
from ros2wasm_launch.texts import flag, parameter_value, text_of

from .descriptions import component_parts
from .events.lifecycle import MANAGED_NODES
from .older_names import takes_older_names
from .parameter_descriptions import ParameterValue, parameter_parts, remap_parts


class Node(ExecuteProcess):
    _tag = 'node'

    @takes_older_names
    def __init__(self, *, executable: Any, package: Any = None, name: Any = None, namespace: Any = None,
                 exec_name: Any = None, parameters: Any = None, remappings: Any = None,
                 ros_arguments: Iterable[Any] | None = None, arguments: Iterable[Any] | None = None,
                 **more: Any) -> None:
        super().__init__(cmd=[executable, *(arguments or ())], **more)
        self._texts = {'pkg': package, 'exec': executable, 'name': name, 'namespace': namespace,
                       'exec_name': exec_name}
        self._words = {'args': arguments, 'ros_args': ros_arguments}
        self._parameters = parameter_parts(parameters, self._place)
        self._remappings = remap_parts(remappings, self._place)
        self.node_name = name
        self.node_package, self.node_executable = package, executable

    def _more_attributes(self) -> dict[str, Any]:
        return {}

    def _more_parts(self) -> list[Entity]:
        return []

    def _entities(self) -> list[Entity]:
        if self._texts['pkg'] is None:
            return super()._entities()  # a program by its path
        attributes: dict[str, Any] = {
            key: text_of(value) for key, value in self._texts.items() if value is not None}
        for key, words in self._words.items():
            if words is not None:
                attributes[key] = [text_of(one) for one in words]
        attributes |= {**self._process_attributes(), **self._more_attributes()}
        parts = self._parameters + self._remappings + self._env_parts() + self._more_parts()
        return self._followed(self._entity(self._tag, attributes, parts))


class LifecycleNode(Node):
    _tag = 'lifecycle_node'

    @takes_older_names
    def __init__(self, *, name: Any, namespace: Any, autostart: Any = False, **more: Any) -> None:
        super().__init__(name=name, namespace=namespace, **more)
        self._autostart = autostart
        MANAGED_NODES.append(self)

    def _more_attributes(self) -> dict[str, Any]:
        return {'autostart': flag(self._autostart)}


class LifecycleTransition(Action):
    def __init__(self, *, lifecycle_node_names: Iterable[Any], transition_ids: Iterable[Any], **more: Any) -> None:
        super().__init__(**more)
        self._names, self._ids = list(lifecycle_node_names), list(transition_ids)

    def _entities(self) -> list[Entity]:
        return [self._entity('lifecycle_transition', {
            'lifecycle_node_names': [text_of(name) for name in self._names],
            'transition_ids': [flag(one) for one in self._ids]})]


class ComposableNodeContainer(Node):
    _tag = 'node_container'

    @takes_older_names
    def __init__(self, *, name: Any, namespace: Any = None, composable_node_descriptions: Any = None,
                 **more: Any) -> None:
        super().__init__(name=name, namespace=namespace, **more)
        self._components = composable_node_descriptions

    def _more_parts(self) -> list[Entity]:
        return component_parts(self._components)


class LoadComposableNodes(Action):
    def __init__(self, *, composable_node_descriptions: Any, target_container: Any, **more: Any) -> None:
        super().__init__(**more)
        self._components, self._target = composable_node_descriptions, target_container

    def _entities(self) -> list[Entity]:
        target = self._target
        attributes: dict[str, Any] = (
            {'process': host.OBJECTS.number(target)} if isinstance(target, Action) else {'target': text_of(target)})
        return [self._entity('load_composable_node', attributes, component_parts(self._components))]


class PushROSNamespace(Action):
    def __init__(self, namespace: Any, **more: Any) -> None:
        super().__init__(**more)
        self._namespace = namespace

    def _entities(self) -> list[Entity]:
        return [self._entity('push_ros_namespace', {'namespace': text_of(self._namespace)})]


PushRosNamespace = PushROSNamespace


class ROSTimer(TimerAction):
    pass


RosTimer = ROSTimer


class SetParameter(Action):
    def __init__(self, name: Any, value: Any, **more: Any) -> None:
        super().__init__(**more)
        self._name, self._value = name, value

    def _entities(self) -> list[Entity]:
        value = self._value
        typed = value._attributes() if isinstance(value, ParameterValue) else {'value': parameter_value(value)}
        return [self._entity('set_parameter', {'name': text_of(self._name), **typed})]


class SetParametersFromFile(Action):
    def __init__(self, filename: Any, node_name: Any = None, **more: Any) -> None:
        super().__init__(**more)
        self._filename = filename

    def _entities(self) -> list[Entity]:
        return [self._entity('set_parameters_from_file', {'filename': text_of(self._filename)})]


class SetRemap(Action):
    def __init__(self, src: Any, dst: Any, **more: Any) -> None:
        super().__init__(**more)
        self._src, self._dst = src, dst

    def _entities(self) -> list[Entity]:
        return [self._entity('set_remap', {'from': text_of(self._src), 'to': text_of(self._dst)})]


class SetROSLogDir(Action):
    def __init__(self, new_log_dir: Any, **more: Any) -> None:
        super().__init__(**more)
        self._folder = new_log_dir

    def _entities(self) -> list[Entity]:
        return [self._entity('set_ros_log_dir', {'new_log_dir': text_of(self._folder)})]


class SetUseSimTime(Action):
    def __init__(self, value: Any, **more: Any) -> None:
        super().__init__(**more)
        self._value = value

    def _entities(self) -> list[Entity]:
        return [self._entity('set_use_sim_time', {'value': flag(self._value)})]


__all__ = ['ComposableNodeContainer', 'LifecycleNode', 'LifecycleTransition', 'LoadComposableNodes', 'Node',
           'PushROSNamespace', 'PushRosNamespace', 'ROSTimer', 'RosTimer', 'SetParameter', 'SetParametersFromFile',
           'SetROSLogDir', 'SetRemap', 'SetUseSimTime']
