"""Helpers of the package controller_manager for launch files."""
