"""Rotations."""
from scipy.spatial import transform

__all__ = ['transform']
