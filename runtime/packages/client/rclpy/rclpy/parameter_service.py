"""The services by which others reach a node's parameters."""
from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters, GetParameters, GetParameterTypes, ListParameters, SetParameters, SetParametersAtomically,
)
from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_services_default


class ParameterService:
    """Made by a node for itself."""

    def __init__(self, node: Any) -> None:
        self._node = node
        for type_, name, callback in (
            (DescribeParameters, 'describe_parameters', self._describe_parameters_callback),
            (GetParameters, 'get_parameters', self._get_parameters_callback),
            (GetParameterTypes, 'get_parameter_types', self._get_parameter_types_callback),
            (ListParameters, 'list_parameters', self._list_parameters_callback),
            (SetParameters, 'set_parameters', self._set_parameters_callback),
            (SetParametersAtomically, 'set_parameters_atomically', self._set_parameters_atomically_callback),
        ):
            node.create_service(type_, f'~/{name}', callback, qos_profile=qos_profile_services_default)

    def _describe_parameters_callback(self, request: Any, response: Any) -> Any:
        for name in request.names:
            try:
                response.descriptors.append(self._node.describe_parameter(name))
            except ParameterNotDeclaredException as error:
                response.descriptors = []
                self._node.get_logger().warning(f'Failed to describe parameters: {error}')
                return response
        return response

    def _get_parameters_callback(self, request: Any, response: Any) -> Any:
        for name in request.names:
            try:
                response.values.append(self._node.get_parameter(name).get_parameter_value())
            except (ParameterNotDeclaredException, ParameterUninitializedException) as error:
                response.values = []
                self._node.get_logger().warning(f'Failed to get parameters: {error}')
                return response
        return response

    def _get_parameter_types_callback(self, request: Any, response: Any) -> Any:
        types = []
        for name in request.names:
            try:
                types.append(int(self._node.get_parameter_type(name)))
            except ParameterNotDeclaredException as error:
                self._node.get_logger().warning(f'Failed to get parameter types: {error}')
                return response
        response.types = types
        return response

    def _list_parameters_callback(self, request: Any, response: Any) -> Any:
        try:
            response.result = self._node.list_parameters(request.prefixes, request.depth)
        except (TypeError, ValueError) as error:
            self._node.get_logger().warning(f'Failed to list parameters: {error}')
        return response

    def _try(self, messages: Any) -> Any:
        """Set all or none of them."""
        try:
            return self._node.set_parameters_atomically([Parameter.from_parameter_msg(one) for one in messages])
        except ParameterNotDeclaredException as error:
            return SetParametersResult(successful=False, reason=str(error))

    def _set_parameters_callback(self, request: Any, response: Any) -> Any:
        response.results = [self._try([one]) for one in request.parameters]
        return response

    def _set_parameters_atomically_callback(self, request: Any, response: Any) -> Any:
        response.result = self._try(request.parameters)
        return response
