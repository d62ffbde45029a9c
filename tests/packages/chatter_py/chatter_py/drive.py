"""Drives by keys, as teleop nodes do: raw mode, select, one character at a time, while another thread spins."""
# Compatibility, works: keys for Python nodes: `termios`, `tty`, `select` and `sys.stdin.read(1)` on standard input;
# the page and `ros2 run` send each key at once

# Compatibility, differs: a terminal in raw mode, for Python nodes -> what comes in lines all the same, out of a pipe,
# is read character by character, the line's end only when it is all there is
import select
import sys
import termios
import threading
import tty

import rclpy
from geometry_msgs.msg import Twist

MOVES = {'i': (1, 0), ',': (-1, 0), 'j': (0, 1), 'l': (0, -1)}


def get_key(settings, timeout):
    tty.setraw(sys.stdin.fileno())
    ready, _, _ = select.select([sys.stdin], [], [], timeout)
    key = sys.stdin.read(1) if ready else ''
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    return key


def main():
    settings = termios.tcgetattr(sys.stdin)
    rclpy.init()
    node = rclpy.create_node('drive')
    publisher = node.create_publisher(Twist, 'cmd_vel', 10)
    heard = []
    node.create_subscription(Twist, 'cmd_vel', heard.append, 10)
    spinner = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    spinner.start()
    try:
        while (key := get_key(settings, 0.1)) != 'q':
            if key not in MOVES:
                if key:
                    print('stands for', repr(key), flush=True)
                continue
            forward, turn = MOVES[key]
            twist = Twist()
            twist.linear.x, twist.angular.z = float(forward), float(turn)
            publisher.publish(twist)
            while not heard:
                spinner.join(0.01)
            print('drives', heard.pop().linear.x, twist.angular.z, flush=True)
        print('driven', sys.stdin.readline().strip(), flush=True)
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        rclpy.shutdown()
