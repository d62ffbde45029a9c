"""The service ~/get_type_description: what the types are that a node uses."""
from __future__ import annotations

import re
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_services_default
from ros2wasm.definition import definition_of
from ros2wasm.type_description import full_description
from ros2wasm.types import find_structure, source_of

START_TYPE_DESCRIPTION_SERVICE_PARAM = 'start_type_description_service'
HASH = re.compile('RIHS01_[0-9a-fA-F]{64}$')


class TypeDescriptionService:
    """Made by a node for itself."""

    def __init__(self, node: Any) -> None:
        self._node = node
        name = START_TYPE_DESCRIPTION_SERVICE_PARAM
        if not node.has_parameter(name):
            node.declare_parameter(name, True, ParameterDescriptor(
                name=name, type=int(Parameter.Type.BOOL), read_only=True,
                description='If enabled, start the ~/get_type_description service.'))
        self.enabled = bool(node.get_parameter(name).value)
        if self.enabled:
            from type_description_interfaces.srv import GetTypeDescription
            self._service = node.create_service(
                GetTypeDescription, '~/get_type_description', self._answer, qos_profile=qos_profile_services_default)

    def _answer(self, request: Any, response: Any) -> Any:
        response.successful = False
        if HASH.match(request.type_hash) is None:
            self._node.get_logger().error(f"Failed to parse type hash '{request.type_hash}'")
            response.failure_reason = 'Failed to parse type hash'
            return response
        name = self._node._rw_used_types.get(request.type_hash)
        if name is None:
            response.failure_reason = 'Type not currently in use by this node'
            return response
        full = full_description(name, find_structure)
        parts = [full['type_description'], *full['referenced_type_descriptions']]
        response.type_description.type_description = self._individual(parts[0])
        response.type_description.referenced_type_descriptions = [self._individual(one) for one in parts[1:]]
        if request.include_type_sources:
            response.type_sources = [self._source(one['type_name']) for one in parts]
        response.successful = True
        return response

    def _individual(self, described: dict[str, Any]) -> Any:
        from type_description_interfaces.msg import Field, FieldType, IndividualTypeDescription
        return IndividualTypeDescription(type_name=described['type_name'], fields=[
            Field(name=one['name'], type=FieldType(**one['type'])) for one in described['fields']])

    def _source(self, name: str) -> Any:
        from type_description_interfaces.msg import TypeSource
        if definition_of(name) != name:
            return TypeSource(type_name=name, encoding='implicit')
        return TypeSource(type_name=name, encoding=name.split('/')[1], raw_file_contents=source_of(name))
