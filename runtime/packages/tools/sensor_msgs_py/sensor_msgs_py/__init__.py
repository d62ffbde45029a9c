"""What Python programs do with sensor messages. Needs numpy."""
