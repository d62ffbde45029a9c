"""Names for hints of types: what `parameters` of a node can be."""
from __future__ import annotations

from .descriptions import ParameterFile

EvaluatedParameters = EvaluatedParameterValue = Parameters = ParametersDict = ParameterName = object
SomeParameters = SomeParametersDict = SomeParameterName = SomeParameterValue = SomeParameterFile = object

__all__ = [
    'EvaluatedParameterValue', 'EvaluatedParameters', 'ParameterFile', 'ParameterName', 'Parameters', 'ParametersDict',
    'SomeParameterFile', 'SomeParameterName', 'SomeParameterValue', 'SomeParameters', 'SomeParametersDict',
]
