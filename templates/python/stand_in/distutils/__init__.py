"""The older name of setuptools."""
