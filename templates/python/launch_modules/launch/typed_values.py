"""Values with a type that substitutions may stand for: what upstream keeps in launch.utilities.type_utils."""
from __future__ import annotations

from typing import Any

import yaml

from .substitution import Substitution
from .utilities import normalize_to_list_of_substitutions, perform_substitutions

_SCALARS = (bool, int, float, str)


def extract_type(data_type: Any) -> tuple[type, bool]:
    """The type of a scalar, or of the items of a list, and whether it is a list."""
    items = getattr(data_type, '__args__', None)
    is_list = getattr(data_type, '__origin__', None) is list and bool(items)
    scalar = items[0] if is_list and items else data_type
    if scalar not in _SCALARS:
        raise ValueError(f'Unrecognized data type: {data_type}')
    return scalar, is_list


def is_instance_of(value: Any, data_type: Any, *, can_be_str: bool = False) -> bool:
    """An int is not a float, and a bool is not an int. None: of any of the types."""
    if data_type is None:
        if not isinstance(value, list):
            return isinstance(value, _SCALARS)
        return len({type(one) for one in value} - ({str} if can_be_str else set())) <= 1
    scalar, is_list = extract_type(data_type)
    wanted = (scalar, str) if can_be_str else (scalar,)
    if is_list:
        return isinstance(value, list) and all(type(one) in wanted for one in value)
    return type(value) in wanted


def _as_yaml(text: str, can_be_str: bool) -> Any:
    try:
        value = yaml.safe_load(text) if text else text
    except yaml.YAMLError as error:
        if can_be_str:
            return text
        raise ValueError(f"Failed to convert '{text}' using yaml rules: {error}") from error
    if not is_instance_of(value, None, can_be_str=can_be_str):
        raise ValueError(f"Failed to convert '{text}' using yaml rules: output type is not allowed, got {type(value)}")
    return value


def coerce_to_type(value: str, data_type: Any = None, *, can_be_str: bool = False) -> Any:
    if data_type is None:
        return _as_yaml(value, can_be_str)
    scalar, is_list = extract_type(data_type)
    if not is_list and scalar is str:
        return value
    if not is_list and scalar in (int, float):
        try:
            return scalar(value)
        except ValueError:
            if can_be_str:
                return value
            raise
    result = _as_yaml({'1': 'true', '0': 'false'}.get(value, value) if scalar is bool and not is_list else value,
                      can_be_str)
    if not is_instance_of(result, data_type, can_be_str=can_be_str):
        wanted = f"a list of '{scalar}'" if is_list else f"'{scalar}'"
        raise ValueError(f"Cannot convert value '{value}' to {wanted}")
    return result


def coerce_list(value: list[str], data_type: Any = None, *, can_be_str: bool = False) -> list[Any]:
    result = [coerce_to_type(one, data_type, can_be_str=can_be_str) for one in value]
    if not is_instance_of(result, None, can_be_str=can_be_str):
        raise ValueError(f"Failed to convert '{value}' to a list of one type")
    return result


def get_typed_value(value: Any, data_type: Any, *, can_be_str: bool = False) -> Any:
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str=can_be_str)
    scalar = None
    if data_type is not None:
        scalar, is_list = extract_type(data_type)
        if not is_list:
            raise TypeError(f"Cannot convert input '{value}' of type '{type(value)}' to '{data_type}'")
    return coerce_list(value, scalar, can_be_str=can_be_str)


def is_substitution(value: Any) -> bool:
    """One, or a list of them and of texts; texts alone are a list."""
    if isinstance(value, Substitution):
        return True
    return (isinstance(value, (list, tuple)) and any(isinstance(one, Substitution) for one in value)
            and all(isinstance(one, (str, Substitution)) for one in value))


def is_normalized_substitution(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(one, Substitution) for one in value)


def normalize_typed_substitution(value: Any, data_type: Any) -> Any:
    """For `perform_typed_substitution`: substitutions as lists of them, all else as it is."""
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if isinstance(value, _SCALARS):
        if not is_instance_of(value, data_type):
            raise TypeError(f"value='{value}' is not an instance of {data_type}")
        return value
    if not isinstance(value, (list, tuple)):
        raise TypeError(f'value should be a scalar, a substitution, or a list of these, got {value!r}')
    scalar, is_list = (None, True) if data_type is None else extract_type(data_type)
    if not is_list:
        raise TypeError(f"The provided value resolves to a list, though the required type is a scalar, '{data_type}'")
    result = [normalize_to_list_of_substitutions(one) if is_substitution(one)
              else float(one) if scalar is float and type(one) is int else one for one in value]
    plain = [one for one in result if not is_normalized_substitution(one)]
    if not is_instance_of(plain, data_type):
        raise TypeError(f"Got the list '{value}', expected a list of '{scalar}'")
    return result


def perform_typed_substitution(context: Any, value: Any, data_type: Any) -> Any:
    if isinstance(value, _SCALARS):
        if data_type is not None and not is_instance_of(value, data_type):
            raise TypeError(f'value=`{value}` is a scalar and not an instance of `{data_type}`')
        return value
    if is_normalized_substitution(value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    scalar, is_list = (None, True) if data_type is None else extract_type(data_type)
    if not is_list:
        raise ValueError(f"The input value is a list, cannot convert it to a scalar of type '{scalar}'")
    result = [coerce_to_type(perform_substitutions(context, one), scalar) if is_normalized_substitution(one) else one
              for one in value]
    if not is_instance_of(result, data_type):
        raise ValueError(f"The output list '{result}' does not match the expected type '{data_type}'")
    return result
