"""`from distutils.cmd import Command`."""
from setuptools import Command

__all__ = ['Command']
