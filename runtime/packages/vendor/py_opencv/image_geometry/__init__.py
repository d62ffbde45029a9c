"""Cameras as CameraInfo messages describe them: the names and formulas of image_geometry for Python."""
from image_geometry.cameramodels import PinholeCameraModel, StereoCameraModel

__all__ = ['PinholeCameraModel', 'StereoCameraModel']
