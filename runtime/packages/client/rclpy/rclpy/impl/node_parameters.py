"""The parameters of a node: declaring, checking, setting, telling."""
from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from typing import Any

from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.exceptions import (
    InvalidParameterTypeException, InvalidParameterValueException, ParameterAlreadyDeclaredException,
    ParameterImmutableException, ParameterNotDeclaredException, ParameterUninitializedException,
)
from rclpy.impl.node_base import NodeBase
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.validate_parameter_name import validate_parameter_name
from ros2wasm.parameter_overrides import overrides

WRONG_TYPE = 'Wrong parameter type'


class NodeParameters(NodeBase):
    #: How near to an end or a step of its range a double must be, in relation to itself.
    PARAM_REL_TOL = 1e-6

    _parameter_event_publisher: Any

    def _rw_begin_parameters(self, given: Sequence[Parameter] | None, allow_undeclared: bool) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._descriptors: dict[str, Any] = {}
        self._allow_undeclared_parameters = allow_undeclared
        self._pre_set_parameters_callbacks: list[Callable[[list[Parameter]], list[Parameter]]] = []
        self._on_set_parameters_callbacks: list[Callable[[list[Parameter]], Any]] = []
        self._post_set_parameters_callbacks: list[Callable[[list[Parameter]], None]] = []
        found = overrides(self._rw_sources, self.get_fully_qualified_name())
        self._parameter_overrides = {name: Parameter(name, value=value) for name, value in found.items()}
        self._parameter_overrides.update({one.name: one for one in given or ()})

    # ---- declaring

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False
    ) -> Parameter:
        if value is None and descriptor is None:
            # Only the name was given.
            args: tuple[Any, ...] = (name,)
        else:
            args = (name, value, ParameterDescriptor() if descriptor is None else descriptor)
        return self.declare_parameters('', [args], ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Sequence[tuple[Any, ...]], ignore_override: bool = False
    ) -> list[Parameter]:
        declared: list[Parameter] = []
        descriptors: dict[str, Any] = {}
        for index, one in enumerate(parameters):
            if not 1 <= len(one) <= 3:
                raise TypeError(f'Invalid parameter tuple length at index {index} in parameters list: {one}; '
                                'expecting length between 1 and 3')
            name = one[0]
            if not isinstance(name, str):
                raise TypeError(f'First element {name} at index {index} in parameters list is not a str.')
            if namespace:
                name = f'{namespace}.{name}'
            validate_parameter_name(name)
            value, descriptor = self._rw_declaration(name, one)
            if not ignore_override and name in self._parameter_overrides:
                value = self._parameter_overrides[name].value
            declared.append(Parameter(name, value=value))
            descriptors[name] = descriptor
        already = [one.name for one in declared if one.name in self._parameters]
        if already:
            raise ParameterAlreadyDeclaredException(already)
        for parameter in declared:
            self._rw_declare(parameter, descriptors[parameter.name])
        return [self._parameters[one.name] for one in declared]

    def _rw_declaration(self, name: str, one: tuple[Any, ...]) -> tuple[Any, Any]:
        """The default value and the descriptor that a declaration means."""
        descriptor = one[2] if len(one) > 2 else ParameterDescriptor()
        if not isinstance(descriptor, ParameterDescriptor):
            raise TypeError(f'Third element {descriptor} of parameter {name} is not a ParameterDescriptor.')
        descriptor.name = name
        if len(one) < 2:
            warnings.warn(f"when declaring parameter named '{name}', declaring a parameter only providing its name "
                          'is deprecated. You have to either:\n'
                          '\t- Pass a name and a default value different to "PARAMETER NOT SET"'
                          ' (and optionally a descriptor).\n'
                          '\t- Pass a name and a parameter type.\n'
                          '\t- Pass a name and a descriptor with `dynamic_typing=True', stacklevel=4)
            descriptor.dynamic_typing = True
            return None, descriptor
        value = one[1]
        if isinstance(value, Parameter.Type):
            if value == Parameter.Type.NOT_SET:
                raise ValueError(f'Cannot declare parameter {{{name}}} as statically typed of type NOT_SET')
            if descriptor.dynamic_typing:
                raise ValueError(f'When declaring parameter {{{name}}} passing a descriptor with'
                                 '`dynamic_typing=True` is not allowed when the parameter type is provided')
            descriptor.type = int(value)
            return None, descriptor
        if not descriptor.dynamic_typing and value is not None:
            descriptor.type = int(Parameter.Type.from_parameter_value(value))
        elif not descriptor.dynamic_typing and descriptor.type == 0:
            raise ValueError(f'Cannot declare a statically typed parameter {{{name}}} without a value or a type')
        return value, descriptor

    def _rw_declare(self, parameter: Parameter, descriptor: Any) -> None:
        event = ParameterEvent()
        if parameter.type_ != Parameter.Type.NOT_SET:
            result = self._rw_check(parameter, descriptor, read_only_matters=False)
            if result.successful:
                result = self._rw_ask([parameter])
            if not result.successful:
                if result.reason.startswith(WRONG_TYPE):
                    raise InvalidParameterTypeException(parameter, Parameter.Type(descriptor.type).name)
                raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)
            if descriptor.dynamic_typing:
                descriptor.type = int(parameter.type_)
            event.new_parameters = [parameter.to_parameter_msg()]
        self._parameters[parameter.name] = parameter
        self._descriptors[parameter.name] = descriptor
        if parameter.type_ != Parameter.Type.NOT_SET:
            for callback in self._post_set_parameters_callbacks:
                callback([parameter])
        self._rw_tell(event)

    def undeclare_parameter(self, name: str) -> None:
        if not self.has_parameter(name):
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self._parameters[name]
        del self._descriptors[name]

    def has_parameter(self, name: str) -> bool:
        return name in self._parameters

    # ---- reading

    def get_parameter(self, name: str) -> Parameter:
        if self.has_parameter(name):
            parameter = self._parameters[name]
            if parameter.type_ != Parameter.Type.NOT_SET or self._descriptors[name].dynamic_typing:
                return parameter
            # Declared with a type alone: there is nothing to give yet.
            raise ParameterUninitializedException(name)
        if self._allow_undeclared_parameters:
            return Parameter(name, Parameter.Type.NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: Sequence[str]) -> list[Parameter]:
        if not all(isinstance(name, str) for name in names):
            raise TypeError('All names must be instances of type str')
        return [self.get_parameter(name) for name in names]

    def get_parameter_type(self, name: str) -> Parameter.Type:
        if self.has_parameter(name):
            return self._parameters[name].type_
        if self._allow_undeclared_parameters:
            return Parameter.Type.NOT_SET
        raise ParameterNotDeclaredException(name)

    def get_parameter_types(self, names: Sequence[str]) -> list[Parameter.Type]:
        return [self.get_parameter_type(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        if alternative_value is None:
            alternative_value = Parameter(name, Parameter.Type.NOT_SET)
        return self._parameters.get(name, alternative_value)

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        start = f'{prefix}{PARAMETER_SEPARATOR_STRING}' if prefix else ''
        return {name[len(start):]: value for name, value in self._parameters.items() if name.startswith(start)}

    def list_parameters(self, prefixes: Sequence[str], depth: int) -> Any:
        if depth < 0:
            raise TypeError('depth must be greater than or equal to zero')
        result = ListParametersResult()
        for name in self._parameters:
            within = not prefixes and (depth == 0 or name.count('.') < depth)
            for prefix in prefixes:
                rest = name[len(prefix) + 1:]
                if name == prefix or (name.startswith(f'{prefix}.') and (depth == 0 or rest.count('.') < depth)):
                    within = True
            if not within:
                continue
            result.names.append(name)
            prefix = name.rpartition('.')[0]
            if prefix and prefix not in result.prefixes:
                result.prefixes.append(prefix)
        return result

    def describe_parameter(self, name: str) -> Any:
        if name in self._descriptors:
            return self._descriptors[name]
        if self._allow_undeclared_parameters:
            return ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: Sequence[str]) -> list[Any]:
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(self, name: str, descriptor: Any, alternative_value: Any = None) -> Any:
        if not self.has_parameter(name):
            if not self._allow_undeclared_parameters:
                raise ParameterNotDeclaredException(name)
            return self.get_parameter(name).get_parameter_value()
        if self.describe_parameter(name).read_only:
            raise ParameterImmutableException(name)
        current = self.get_parameter(name)
        if alternative_value is not None:
            current = Parameter(name=name, value=alternative_value)
        result = self._rw_check(current, descriptor, read_only_matters=False)
        if not result.successful:
            raise InvalidParameterValueException(name, current.value, result.reason)
        descriptor.name = name
        self._descriptors[name] = descriptor
        self._parameters[name] = current
        return current.get_parameter_value()

    # ---- setting

    def set_parameters(self, parameter_list: Sequence[Parameter]) -> list[Any]:
        return [self._rw_set([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: Sequence[Parameter]) -> Any:
        return self._rw_set(list(parameter_list))

    def _rw_set(self, parameters: list[Parameter]) -> Any:
        for callback in self._pre_set_parameters_callbacks:
            parameters = callback(parameters)
        if not parameters:
            return SetParametersResult(
                successful=False, reason='parameter list cannot be empty, this might be due to '
                'pre_set_parameters_callback modifying the original parameters list.')
        if not self._allow_undeclared_parameters:
            missing = [one.name for one in parameters if one.name not in self._parameters]
            if missing:
                raise ParameterNotDeclaredException(missing)
        for parameter in parameters:
            if not isinstance(parameter, Parameter):
                raise TypeError("parameter must be instance of type '{}'".format(repr(Parameter)))
            result = self._rw_check(parameter, self._descriptors.get(parameter.name, None))
            if not result.successful:
                return result
        result = self._rw_ask(parameters)
        if result.successful:
            self._rw_store(parameters)
            for tell in self._post_set_parameters_callbacks:
                tell(parameters)
        return result

    def _rw_store(self, parameters: list[Parameter]) -> None:
        event = ParameterEvent()
        for parameter in parameters:
            message = parameter.to_parameter_msg()
            known = parameter.name in self._parameters
            before = self._parameters.get(parameter.name)
            if parameter.type_ == Parameter.Type.NOT_SET:
                if known and before is not None and before.type_ != Parameter.Type.NOT_SET:
                    event.deleted_parameters.append(message)
                    self._parameters.pop(parameter.name)
                    self._descriptors.pop(parameter.name)
                continue
            if not known or before is None or before.type_ == Parameter.Type.NOT_SET:
                event.new_parameters.append(message)
            else:
                event.changed_parameters.append(message)
            self._parameters[parameter.name] = parameter
            if parameter.name not in self._descriptors:
                self._descriptors[parameter.name] = ParameterDescriptor(name=parameter.name, dynamic_typing=True)
            if self._descriptors[parameter.name].dynamic_typing:
                self._descriptors[parameter.name].type = int(parameter.type_)
        self._rw_tell(event)

    def _rw_tell(self, event: Any) -> None:
        if self._parameter_event_publisher is not None:
            event.node = self.get_fully_qualified_name()
            event.stamp = self._clock.now().to_msg()
            self._parameter_event_publisher.publish(event)

    def _rw_ask(self, parameters: list[Parameter]) -> Any:
        for callback in list(self._on_set_parameters_callbacks):
            result = callback(parameters)
            if not result.successful:
                return result
        return SetParametersResult(successful=True)

    def _rw_check(self, parameter: Parameter, descriptor: Any, read_only_matters: bool = True) -> Any:
        """Whether a descriptor allows a value."""
        def refuse(reason: str) -> Any:
            return SetParametersResult(successful=False, reason=reason)
        if descriptor is None:
            return SetParametersResult(successful=True)
        if read_only_matters and descriptor.read_only:
            return refuse(f'Trying to set a read-only parameter: {parameter.name}.')
        if not descriptor.dynamic_typing and descriptor.type != int(parameter.type_):
            return refuse(f"{WRONG_TYPE}, expected '{Parameter.Type(descriptor.type)}' got '{parameter.type_}'")
        if parameter.type_ == Parameter.Type.INTEGER and descriptor.integer_range:
            return self._rw_check_range(parameter, descriptor.integer_range[0], 0)
        if parameter.type_ == Parameter.Type.DOUBLE and descriptor.floating_point_range:
            return self._rw_check_range(parameter, descriptor.floating_point_range[0], self.PARAM_REL_TOL)
        return SetParametersResult(successful=True)

    def _rw_check_range(self, parameter: Parameter, limits: Any, nearly: float) -> Any:
        low, high = sorted((limits.from_value, limits.to_value))
        step, value = limits.step, parameter.value
        if any(value == end or math.isclose(value, end, rel_tol=nearly) for end in (low, high)):
            return SetParametersResult(successful=True)
        if not low < value < high:
            return SetParametersResult(
                successful=False,
                reason=f"Parameter {parameter.name} out of range{'' if nearly else '.'} "
                f'Min: {low}, Max: {high}, value: {value}')
        if step and not math.isclose(low + round((value - low) / step) * step, value, rel_tol=nearly):
            return SetParametersResult(
                successful=False,
                reason=f'The parameter value for {parameter.name} is not '
                f"{'close enough to ' if nearly else ''}a valid step. "
                f'Min: {low}, max: {high}, value: {value}, step: {step}')
        return SetParametersResult(successful=True)

    # ---- callbacks; the last added is asked first

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Add a callback that may change what is to be set."""
        self._pre_set_parameters_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Add a callback that may refuse what is to be set."""
        self._on_set_parameters_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Add a callback that is told what was set."""
        self._post_set_parameters_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(
        self, callback: Callable[[list[Parameter]], list[Parameter]]
    ) -> None:
        self._pre_set_parameters_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        self._on_set_parameters_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        self._post_set_parameters_callbacks.remove(callback)
