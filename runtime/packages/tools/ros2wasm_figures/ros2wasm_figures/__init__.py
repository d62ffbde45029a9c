"""Windows of Python libraries as panels of the page."""
