"""`from distutils.core import setup`."""
from setuptools import Command, Extension, setup

__all__ = ['Command', 'Extension', 'setup']
