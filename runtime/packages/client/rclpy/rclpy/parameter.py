"""Parameters and their values."""
from __future__ import annotations

from array import array
from enum import IntEnum
from typing import Any

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterType, ParameterValue
from rclpy.impl.elsewhere import names_of
from ros2wasm.parameter_overrides import flatten, visit
from ros2wasm.yaml import parse, parse_value

__getattr__ = names_of(__name__, {'enum': 'Enum', 'typing': 'Dict List Optional Tuple Union'})

PARAMETER_SEPARATOR_STRING = '.'


class Parameter:
    """A name, a value and the value's type."""

    class Type(IntEnum):
        """The types that a value can have."""

        NOT_SET = ParameterType.PARAMETER_NOT_SET
        BOOL = ParameterType.PARAMETER_BOOL
        INTEGER = ParameterType.PARAMETER_INTEGER
        DOUBLE = ParameterType.PARAMETER_DOUBLE
        STRING = ParameterType.PARAMETER_STRING
        BYTE_ARRAY = ParameterType.PARAMETER_BYTE_ARRAY
        BOOL_ARRAY = ParameterType.PARAMETER_BOOL_ARRAY
        INTEGER_ARRAY = ParameterType.PARAMETER_INTEGER_ARRAY
        DOUBLE_ARRAY = ParameterType.PARAMETER_DOUBLE_ARRAY
        STRING_ARRAY = ParameterType.PARAMETER_STRING_ARRAY

        @classmethod
        def from_parameter_value(cls, parameter_value: Any) -> Parameter.Type:
            """Which type a Python value has. TypeError: no type fits."""
            if parameter_value is None:
                return cls.NOT_SET
            for type_, python in ((cls.BOOL, bool), (cls.INTEGER, int), (cls.DOUBLE, float), (cls.STRING, str)):
                if isinstance(parameter_value, python):
                    return type_
            if isinstance(parameter_value, (list, tuple, array)):
                items = list(parameter_value)
                if all(isinstance(v, bytes) for v in items):
                    return cls.BYTE_ARRAY
                for type_, python in ((cls.BOOL_ARRAY, bool), (cls.INTEGER_ARRAY, int), (cls.DOUBLE_ARRAY, float),
                                      (cls.STRING_ARRAY, str)):
                    if all(isinstance(v, python) and not (python is int and isinstance(v, bool)) for v in items):
                        return type_
            raise TypeError(
                f"The given value is not one of the allowed types '{parameter_value}'.")

        def check(self, parameter_value: Any) -> bool:
            """Whether a Python value fits this type."""
            if self is Parameter.Type.NOT_SET:
                return parameter_value is None
            python = _ELEMENTS[self]
            if self < Parameter.Type.BYTE_ARRAY:
                return isinstance(parameter_value, python)
            return isinstance(parameter_value, (list, tuple, array)) and \
                all(isinstance(v, python) for v in parameter_value)

    @classmethod
    def from_parameter_msg(cls, param_msg: Any) -> Parameter:
        value = param_msg.value
        type_ = Parameter.Type(value.type)
        return cls(param_msg.name, type_, parameter_value_to_python(value))

    def __init__(self, name: str, type_: Parameter.Type | None = None, value: Any = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError("type must be an instance of '{}'".format(repr(Parameter.Type)))
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._type_ = type_
        self._name = name
        self._value = value

    @property
    def name(self) -> str:
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        return self._type_

    @property
    def value(self) -> Any:
        return self._value

    def __repr__(self) -> str:
        return f'Parameter(name={self._name!r}, type_={self._type_}, value={self._value!r})'

    def get_parameter_value(self) -> Any:
        """The value as a message."""
        message = ParameterValue(type=int(self.type_))
        if self.type_ is not Parameter.Type.NOT_SET:
            name = _FIELDS[self.type_]
            value = self.value
            if self.type_ == Parameter.Type.DOUBLE:
                value = float(value)
            setattr(message, name, list(value) if name.endswith('array_value') else value)
        return message

    def to_parameter_msg(self) -> Any:
        return ParameterMsg(name=self.name, value=self.get_parameter_value())


_FIELDS = {
    Parameter.Type.BOOL: 'bool_value', Parameter.Type.INTEGER: 'integer_value', Parameter.Type.DOUBLE: 'double_value',
    Parameter.Type.STRING: 'string_value', Parameter.Type.BYTE_ARRAY: 'byte_array_value',
    Parameter.Type.BOOL_ARRAY: 'bool_array_value', Parameter.Type.INTEGER_ARRAY: 'integer_array_value',
    Parameter.Type.DOUBLE_ARRAY: 'double_array_value', Parameter.Type.STRING_ARRAY: 'string_array_value',
}
_ELEMENTS: dict[Parameter.Type, type] = {
    Parameter.Type.BOOL: bool, Parameter.Type.INTEGER: int, Parameter.Type.DOUBLE: float, Parameter.Type.STRING: str,
    Parameter.Type.BYTE_ARRAY: bytes, Parameter.Type.BOOL_ARRAY: bool, Parameter.Type.INTEGER_ARRAY: int,
    Parameter.Type.DOUBLE_ARRAY: float, Parameter.Type.STRING_ARRAY: str,
}


def get_parameter_value(string_value: str) -> Any:
    """What a text means: read as YAML; a text that is not a value stays a string."""
    try:
        value = parse_value(string_value)
        return Parameter('', value=string_value if value is None else value).get_parameter_value()
    except (TypeError, ValueError):
        return Parameter('', Parameter.Type.STRING, string_value).get_parameter_value()


def parameter_value_to_python(parameter_value: Any) -> Any:
    """The Python value of a message."""
    try:
        type_ = Parameter.Type(parameter_value.type)
    except ValueError:
        raise RuntimeError(f'unexpected parameter type {parameter_value.type}') from None
    if type_ is Parameter.Type.NOT_SET:
        return None
    value = getattr(parameter_value, _FIELDS[type_])
    return list(value) if type_ == Parameter.Type.BYTE_ARRAY else value


def parameter_dict_from_yaml_file(
    parameter_file: str, use_wildcard: bool = False, target_nodes: list[str] | None = None, namespace: str = ''
) -> dict[str, ParameterMsg]:
    """What a parameter file sets, by name: for the nodes that are asked for, or for all."""
    with open(parameter_file, encoding='utf-8') as file:
        document = parse(file.read())
    found: dict[str, Any] = {}
    wanted = {one if one.startswith('/') else f'/{one}' for one in target_nodes or []}

    def take(node: str, parameters: dict[str, Any]) -> None:
        if node == '/**' and use_wildcard or not wanted or node in wanted:
            flatten(parameters, namespace, found)
    visit('', document or {}, take)
    if not found:
        raise RuntimeError(f'Param file does not contain any valid parameters: {parameter_file}')
    return {name: Parameter(name, value=value).to_parameter_msg() for name, value in found.items()}
