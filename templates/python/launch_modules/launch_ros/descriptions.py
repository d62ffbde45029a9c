"""Components of containers."""
from __future__ import annotations

from typing import Any

from ros2wasm_launch import host
from ros2wasm_launch.entities import Entity, entity
from ros2wasm_launch.texts import text_of

from .older_names import takes_older_names
from .parameter_descriptions import Parameter, ParameterFile, ParameterValue, parameter_parts, remap_parts

__all__ = ['ComposableNode', 'Parameter', 'ParameterFile', 'ParameterValue']


class ComposableNode:
    #: File and line where it was made.
    _place: dict[str, Any]

    @host.noted_place
    @takes_older_names
    def __init__(self, *, package: Any, plugin: Any, name: Any = None, namespace: Any = None, parameters: Any = None,
                 remappings: Any = None, extra_arguments: Any = None, condition: Any = None) -> None:
        self.package, self.plugin, self.name, self.namespace = package, plugin, name, namespace
        self.parameters, self.remappings, self.extra_arguments = parameters, remappings, extra_arguments
        self.condition = condition

    def _entity(self) -> Entity:
        place = self._place
        optional = {'name': self.name, 'namespace': self.namespace}
        attributes: dict[str, Any] = {'pkg': text_of(self.package), 'plugin': text_of(self.plugin)}
        attributes |= {key: text_of(value) for key, value in optional.items() if value is not None}
        if self.condition is not None:
            attributes |= dict([self.condition._attribute()])
        extra = [{**part, 'tag': 'extra_arg'} for part in parameter_parts(self.extra_arguments, place)]
        return entity('composable_node', place, attributes,
                      parameter_parts(self.parameters, place) + remap_parts(self.remappings, place) + extra)


def component_parts(descriptions: Any) -> list[Entity]:
    return [one._entity() for one in descriptions or ()]
