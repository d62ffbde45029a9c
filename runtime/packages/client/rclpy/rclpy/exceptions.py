"""What rclpy raises."""
from __future__ import annotations

from typing import Any

from rclpy._rclpy_pybind11 import InvalidHandle as InvalidHandle  # noqa: F401


class NotInitializedException(Exception):
    """Something was asked of rclpy before its init."""

    def __init__(self, message: str | None = None) -> None:
        super().__init__(f'rclpy.init() has not been called.{f" msg:{message}" if message else ""}')


class NoImplementationAvailableException(Exception):
    """There is no middleware."""

    def __init__(self, *args: object) -> None:
        super().__init__('no rmw implementation with a Python extension available', *args)


class NoTypeSupportImportedException(Exception):
    """What was given as a type is none."""

    def __init__(self, *args: object) -> None:
        super().__init__('no type_support imported', *args)


class NameValidationException(Exception):
    """A name of a topic, service, node or namespace breaks the rules; where, and how."""

    def __init__(
        self, name_type: str, name: str, error_msg: str, invalid_index: int | None, *args: object
    ) -> None:
        lines = (f'Invalid {name_type}: {error_msg}:', f"  '{name}'", '^'.rjust(4 + (invalid_index or 0)))
        super().__init__('\n'.join(lines), name_type, name, error_msg, invalid_index, *args)
        self.name_type = name_type
        self.name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index


class InvalidNamespaceException(NameValidationException):
    """Of a namespace."""

    def __init__(self, name: str, error_msg: str, invalid_index: int | None, *args: object) -> None:
        super().__init__('namespace', name, error_msg, invalid_index, *args)


class InvalidNodeNameException(NameValidationException):
    """Of a node."""

    def __init__(self, name: str, error_msg: str, invalid_index: int | None, *args: object) -> None:
        super().__init__('node name', name, error_msg, invalid_index, *args)


class InvalidTopicNameException(NameValidationException):
    """Of a topic."""

    def __init__(self, name: str, error_msg: str, invalid_index: int | None, *args: object) -> None:
        super().__init__('topic name', name, error_msg, invalid_index, *args)


class InvalidServiceNameException(NameValidationException):
    """Of a service."""

    def __init__(self, name: str, error_msg: str, invalid_index: int | None, *args: object) -> None:
        super().__init__('service name', name, error_msg, invalid_index, *args)


class ROSInterruptException(Exception):
    """The end came while something waited."""

    def __init__(self, *args: object) -> None:
        super().__init__('rclpy.shutdown() has been called', *args)


class ParameterException(Exception):
    """Of parameters."""

    def __init__(self, error_msg: str, parameters: Any, *args: object) -> None:
        super().__init__(f'{error_msg}: {parameters}', error_msg, parameters, *args)


class ParameterNotDeclaredException(ParameterException):
    """Nobody declared it."""

    def __init__(self, parameters: Any, *args: object) -> None:
        super().__init__('Invalid access to undeclared parameter(s)', parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    """It was declared before."""

    def __init__(self, parameters: Any, *args: object) -> None:
        super().__init__('Parameter(s) already declared', parameters, *args)


class InvalidParameterException(ParameterException):
    """Its name breaks the rules."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__('Invalid parameter name', parameter_name)


class InvalidParameterTypeException(ParameterException):
    """Its type is not the one that was declared."""

    def __init__(self, desired_parameter: Any, expected_type: Any, *args: object) -> None:
        super().__init__(
            f"Trying to set parameter '{desired_parameter._name}' to '{desired_parameter._value}' of type "
            f"'{desired_parameter._type_.name}', expecting type '{expected_type}'", desired_parameter, *args)
        self.desired_parameter = desired_parameter
        self.expected_type = expected_type


class InvalidParameterValueException(ParameterException):
    """Its descriptor or a callback refuses the value."""

    def __init__(self, parameter: Any, value: Any, reason: str, *args: object) -> None:
        super().__init__(
            f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter, *args)


class ParameterImmutableException(ParameterException):
    """It is read-only."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__('Attempted to modify read-only parameter', parameter_name)


class ParameterUninitializedException(ParameterException):
    """It has no value yet."""

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__('The parameter is not initialized', parameter_name, *args)
