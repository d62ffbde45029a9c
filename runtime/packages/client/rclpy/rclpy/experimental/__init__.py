"""What is not settled yet in ROS 2."""
from rclpy.experimental.events_executor import EventsExecutor

__all__ = ['EventsExecutor']
