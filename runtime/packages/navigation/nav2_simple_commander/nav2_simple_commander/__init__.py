"""Navigation as calls: `robot_navigator` for robots, `costmap_2d` and its checkers for maps of costs."""
