"""What the Python nodes of the package share."""
