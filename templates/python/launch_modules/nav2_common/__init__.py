"""nav2_common, as far as launch files use it: files of parameters that are changed on their way to a node."""
