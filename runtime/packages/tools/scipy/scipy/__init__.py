"""Of SciPy what nodes use most: rotations. The rest is compiled code."""
from scipy import spatial

__all__ = ['spatial']

#: Whose interface this is.
__version__ = '1.14.0'
