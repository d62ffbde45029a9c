"""Point clouds as numpy arrays, and arrays as point clouds."""
from __future__ import annotations

import array
import sys
from collections import namedtuple
from collections.abc import Iterable
from typing import Any

import numpy as np
from sensor_msgs.msg import PointCloud2, PointField

DUMMY_FIELD_PREFIX = 'unnamed_field'

_DATATYPES: dict[int, Any] = {
    PointField.INT8: np.dtype(np.int8), PointField.UINT8: np.dtype(np.uint8),
    PointField.INT16: np.dtype(np.int16), PointField.UINT16: np.dtype(np.uint16),
    PointField.INT32: np.dtype(np.int32), PointField.UINT32: np.dtype(np.uint32),
    PointField.FLOAT32: np.dtype(np.float32), PointField.FLOAT64: np.dtype(np.float64),
}


def dtype_from_fields(fields: Iterable[Any], point_step: int | None = None) -> Any:
    """The numpy type of one point. A field with a count becomes that many fields."""
    names: list[str] = []
    formats: list[str] = []
    offsets: list[int] = []
    for i, field in enumerate(fields):
        one = _DATATYPES[field.datatype]
        name = field.name or f'{DUMMY_FIELD_PREFIX}_{i}'
        for part in range(field.count):
            names.append(f'{name}_{part}' if field.count > 1 else name)
            if names[-1] in names[:-1]:
                raise AssertionError('Duplicate field names are not allowed!')
            offsets.append(field.offset + part * one.itemsize)
            formats.append(one.str)
    form: dict[str, Any] = {'names': names, 'formats': formats, 'offsets': offsets}
    if point_step is not None:
        form['itemsize'] = point_step
    return np.dtype(form)


def read_points(
    cloud: Any, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Iterable[Any] | None = None,
    reshape_organized_cloud: bool = False
) -> Any:
    """The points as a structured array: all or the named fields; `uvs`: only those at these indices."""
    assert isinstance(cloud, PointCloud2), 'Cloud is not a sensor_msgs.msg.PointCloud2'
    points: Any = np.ndarray(
        shape=(cloud.width * cloud.height,), dtype=dtype_from_fields(cloud.fields, point_step=cloud.point_step),
        buffer=cloud.data)
    if field_names is not None:
        known = points.dtype.names
        assert all(name in known for name in field_names), 'Requests field is not in the fields of the PointCloud!'
        points = points[list(field_names)]
    if bool(sys.byteorder != 'little') != bool(cloud.is_bigendian):
        points = points.byteswap()
    if skip_nans and not cloud.is_dense:
        valid = np.ones(len(points), dtype=bool)
        for name in points.dtype.names:
            valid &= ~np.isnan(points[name])
        points = points[valid]
    if uvs is not None:
        indices = np.asarray(list(uvs) if not isinstance(uvs, np.ndarray) else uvs)
        if indices.ndim == 2:
            # Columns and rows of an organised cloud.
            indices = indices[:, 1] * cloud.width + indices[:, 0]
        points = points[indices]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.width, cloud.height)
    return points


def read_points_numpy(
    cloud: Any, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Iterable[Any] | None = None,
    reshape_organized_cloud: bool = False
) -> Any:
    """The points as rows of numbers, for fields that are all of one type."""
    assert all(cloud.fields[0].datatype == field.datatype for field in cloud.fields[1:]
               if field_names is None or field.name in field_names), \
        'All fields need to have the same datatype. Use `read_points()` otherwise.'
    from numpy.lib.recfunctions import structured_to_unstructured
    return structured_to_unstructured(read_points(
        cloud, field_names, skip_nans, uvs, reshape_organized_cloud))


def read_points_list(
    cloud: Any, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Iterable[Any] | None = None
) -> list[Any]:
    """The points as named tuples."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    make: Any = namedtuple
    made = make('Point', points.dtype.names)
    return [made._make(point) for point in points]


def create_cloud(header: Any, fields: Iterable[Any], points: Any, point_step: int | None = None) -> Any:
    """A message of points: a structured array, or rows of numbers."""
    fields = list(fields)
    form = dtype_from_fields(fields, point_step)
    if not isinstance(points, np.ndarray):
        points = np.array([tuple(point) for point in points], dtype=form)
    elif points.dtype.names is not None:
        assert points.dtype == form, \
            'PointFields and structured NumPy array dtype do not match for all fields! ' \
            'Check their field order, names and types.'
    else:
        structured = np.zeros(points.shape[:-1], dtype=form)
        for column, name in enumerate(form.names):
            structured[name] = points[..., column]
        points = structured
    assert points.ndim <= 2, 'Too many dimensions for organized cloud! Points can only be organized in max. ' \
        'two dimensional space'
    height, width = (1, points.shape[0]) if points.ndim == 1 else (points.shape[1], points.shape[0])
    return PointCloud2(
        header=header, height=height, width=width, is_dense=False, is_bigendian=sys.byteorder != 'little',
        fields=fields, point_step=points.dtype.itemsize, row_step=points.dtype.itemsize * width,
        data=array.array('B', points.tobytes()))


def create_cloud_xyz32(header: Any, points: Any, step: int | None = None) -> Any:
    """A message of points with x, y and z."""
    fields = [PointField(name=name, offset=4 * i, datatype=PointField.FLOAT32, count=1) for i, name in enumerate('xyz')]
    return create_cloud(header, fields, points, step)
