"""A talker and a listener."""
