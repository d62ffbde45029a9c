"""Rotations in three dimensions, and what lies between them."""
from scipy.spatial.transform._rotation import Rotation
from scipy.spatial.transform._slerp import Slerp

__all__ = ['Rotation', 'Slerp']
