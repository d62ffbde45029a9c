"""pictures TOPIC: publishes a test card every half second: eight coloured bars, a grey ramp, a dot that goes along."""
import sys
from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import Image

WIDTH, HEIGHT = 64, 48
RAMP = 36
BARS = [(255, 255, 255), (255, 255, 0), (0, 255, 255), (0, 255, 0), (255, 0, 255), (255, 0, 0), (0, 0, 255), (0, 0, 0)]


def color(x, y, dot):
    """Of one pixel, as red, green and blue."""
    if (x - dot) ** 2 + (y - HEIGHT // 2) ** 2 < 30:
        return (255, 140, 0)
    if y >= RAMP:
        return (x * 255 // (WIDTH - 1),) * 3
    return BARS[x * len(BARS) // WIDTH]


def card(count):
    """The test card as rgb8, with the dot further right each time."""
    dot = 4 * count % WIDTH
    return bytes(part for y in range(HEIGHT) for x in range(WIDTH) for part in color(x, y, dot))


def main():
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        node = rclpy.create_node('pictures')
        publisher = node.create_publisher(Image, sys.argv[1], 10)
        count = 0

        def publish():
            nonlocal count
            picture = Image(width=WIDTH, height=HEIGHT, encoding='rgb8', step=3 * WIDTH, data=card(count))
            picture.header.stamp = node.get_clock().now().to_msg()
            publisher.publish(picture)
            count += 1
        node.create_timer(0.5, publish)
        rclpy.spin(node)
