"""manage NODE: configures a managed node, and activates it two seconds later."""
import sys
import time

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState


def main():
    rclpy.init()
    node = rclpy.create_node('manage')
    client = node.create_client(ChangeState, f'{sys.argv[1]}/change_state')
    client.wait_for_service()
    for number in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE):
        future = client.call_async(ChangeState.Request(transition=Transition(id=number)))
        rclpy.spin_until_future_complete(node, future)
        print(f'transition {number}: {future.result().success}')
        time.sleep(2)
    rclpy.shutdown()
