"""Takes any parameter that others set."""
from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException


def main():
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        rclpy.spin(rclpy.create_node('parameter_blackboard', allow_undeclared_parameters=True))
