"""The part of generated modules that is the same for all. It runs in nodes."""
from __future__ import annotations

import copy
import dataclasses
import operator
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, ClassVar, Generic, TypeVar

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy import logging
from rclpy.clock import Clock
from rclpy.exceptions import InvalidParameterValueException
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.time import Time

ParamsT = TypeVar('ParamsT')


class MapOf:
    """A group with a map in it: an entry for each key, which is an attribute too."""

    entry_type: type[Any]

    def add_entry(self, name: str) -> Any:
        entries = self.__dict__.setdefault('_entries', {})
        if name not in entries:
            entries[name] = self.entry_type()
            self.__dict__.setdefault(name, entries[name])
        return entries[name]

    def get_entry(self, name: str) -> Any:
        """Raises KeyError for an unknown key."""
        return self.__dict__.get('_entries', {})[name]


@dataclasses.dataclass(frozen=True)
class Each:
    """In the path of a field: an entry for each text in this array, which is named from the outermost group on."""

    keys: str


@dataclasses.dataclass(frozen=True)
class Field:
    """A parameter, as the YAML file describes it."""

    path: tuple[str | Each, ...]
    type_: str  # of rclpy.parameter.Parameter.Type
    description: str = ''
    additional_constraints: str = ''
    is_required: bool = False
    is_read_only: bool = False
    range_: tuple[Any, Any] | None = None
    #: Functions of a parameter and these arguments; they return why it is refused.
    checks: tuple[tuple[Any, ...], ...] = ()

    @property
    def is_mapped(self) -> bool:
        return any(isinstance(one, Each) for one in self.path)

    def descriptor(self) -> Any:
        descriptor = ParameterDescriptor(
            description=self.description, additional_constraints=self.additional_constraints,
            read_only=self.is_read_only)
        if self.range_ is not None:
            lower, upper = self.range_
            if self.type_.startswith('DOUBLE'):
                descriptor.floating_point_range = [FloatingPointRange(from_value=lower, to_value=upper)]
            else:
                descriptor.integer_range = [IntegerRange(from_value=lower, to_value=upper)]
        return descriptor

    def refusal(self, parameter: Any) -> str:
        for function, *arguments in self.checks:
            reason = function(parameter, *arguments)
            if reason:
                return str(reason)
        return ''

    def places(self, params: Any) -> Iterator[tuple[str, Any]]:
        """The name of each parameter that this is, and the group whose attribute has its value."""
        found: Iterable[tuple[str, Any]] = [('', params)]
        for part in self.path[:-1]:
            found = _below(found, part, params)
        return ((f'{name}{self.path[-1]}', group) for name, group in found)


def _below(found: Iterable[tuple[str, Any]], part: str | Each, params: Any) -> Iterator[tuple[str, Any]]:
    for name, group in found:
        if isinstance(part, str):
            yield f'{name}{part}.', getattr(group, part)
        else:
            for key in operator.attrgetter(part.keys)(params):
                yield f'{name}{key}.', group.add_entry(key)


class ParameterListener(Generic[ParamsT]):
    """Declares the parameters of a node, checks them, and follows their changes."""

    params_type: type[Any]
    fields: ClassVar[Sequence[Field]]
    name: ClassVar[str]

    def __init__(self, node: Any, prefix: str = '') -> None:
        self.prefix_ = prefix
        self.params_: ParamsT = self.params_type()
        self.node_ = node
        self.logger_ = logging.get_logger(f'{self.name}.{prefix}')
        self.clock_ = Clock()
        self.user_callback: Callable[[ParamsT], object] | None = None
        self.declare_params()
        self.node_.add_on_set_parameters_callback(self.update)

    def get_params(self) -> ParamsT:
        """A copy."""
        stamp = self.params_.stamp_  # type: ignore[attr-defined]
        return copy.deepcopy(self.params_, {id(stamp): stamp})

    def is_old(self, other_param: ParamsT) -> bool:
        return bool(self.params_.stamp_ != other_param.stamp_)  # type: ignore[attr-defined]

    def set_user_callback(self, callback: Callable[[ParamsT], object]) -> None:
        """`callback` gets the new values after each change."""
        self.user_callback = callback

    def clear_user_callback(self) -> None:
        self.user_callback = None

    def declare_params(self) -> None:
        """Declare and read all parameters. Raises InvalidParameterValueException."""
        params = self.get_params()
        for is_mapped in (False, True):
            self._declare(params, is_mapped)
        self._put(params)

    def refresh_dynamic_parameters(self) -> None:
        """Declare the parameters of new keys of maps."""
        params = self.get_params()
        if self._declare(params, True):
            self._put(params)

    def update(self, parameters: Sequence[Any]) -> Any:
        """Take all of these, or none: those of others are passed over."""
        params = self.get_params()
        for is_mapped in (False, True):
            for parameter in parameters:
                reason = self._take(params, parameter, is_mapped)
                if reason:
                    return SetParametersResult(successful=False, reason=reason)
        self._put(params)
        if self.user_callback is not None:
            self.user_callback(self.get_params())
        return SetParametersResult(successful=True)

    def unpack_parameter_dict(self, namespace: str, parameter_dict: dict[str, Any]) -> list[Any]:
        """Parameters, from dictionaries in one another."""
        result = []
        for name, value in parameter_dict.items():
            if isinstance(value, dict):
                result += self.unpack_parameter_dict(f'{namespace}{name}{PARAMETER_SEPARATOR_STRING}', value)
            else:
                result.append(Parameter(namespace + name, value=value))
        return result

    def set_params_from_dict(self, param_dict: dict[str, Any]) -> None:
        """Take values without setting the parameters of the node."""
        self.update(self.unpack_parameter_dict('', param_dict))

    def _put(self, params: ParamsT) -> None:
        # Later than before, also where the clock stands still.
        last = self.params_.stamp_.nanoseconds  # type: ignore[attr-defined]
        now = self.clock_.now()
        params.stamp_ = Time(  # type: ignore[attr-defined]
            nanoseconds=max(now.nanoseconds, last + 1), clock_type=now.clock_type)
        self.params_ = params

    def _declare(self, params: ParamsT, is_mapped: bool) -> bool:
        """Returns whether one was not declared before."""
        is_new = False
        for field in self.fields:
            if field.is_mapped != is_mapped:
                continue
            for name, group in field.places(params):
                full_name = self.prefix_ + name
                if not self.node_.has_parameter(full_name):
                    is_new = True
                    self._declare_one(field, full_name, getattr(group, str(field.path[-1])))
                parameter = self.node_.get_parameter(full_name)
                self._log(parameter)
                reason = field.refusal(parameter)
                if reason:
                    raise InvalidParameterValueException(
                        name, parameter.value,
                        f'Invalid value set during initialization for parameter {name}: {reason}')
                setattr(group, str(field.path[-1]), parameter.value)
        return is_new

    def _declare_one(self, field: Field, name: str, default: Any) -> None:
        descriptor = field.descriptor()
        type_ = Parameter.Type[field.type_]
        if field.is_required:
            self.node_.declare_parameter(name, type_, descriptor)
        elif default != []:
            self.node_.declare_parameter(name, default, descriptor)
        else:  # of an empty list rclpy does not know the type
            descriptor.read_only = False
            if self.node_.declare_parameter(name, type_, descriptor).type_ == Parameter.Type.NOT_SET:
                self.node_.set_parameters([Parameter(name, type_, default)])
            if field.is_read_only:
                final = field.descriptor()
                final.type = type_.value
                self.node_.set_descriptor(name, final)

    def _take(self, params: ParamsT, parameter: Any, is_mapped: bool) -> str:
        """Why the parameter is refused."""
        for field in self.fields:
            if field.is_mapped != is_mapped:
                continue
            for name, group in field.places(params):
                if self.prefix_ + name != parameter.name:
                    continue
                reason = field.refusal(parameter)
                if reason:
                    return reason
                setattr(group, str(field.path[-1]), parameter.value)
                self._log(parameter)
        return ''

    def _log(self, parameter: Any) -> None:
        self.logger_.debug(f'{parameter.name}: {parameter.type_.name} = {parameter.value}')
