"""A robot that does exactly what it is commanded to do: `loopback_simulator`."""
