"""What Python nodes of a site stand on: the host's functions, the message types, the start of a program."""
