"""Numbers of managed nodes, as launch files use them."""
