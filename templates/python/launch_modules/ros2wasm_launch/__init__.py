"""What launch files in Python are recorded with. The packages beside this one have launch's names on it."""
