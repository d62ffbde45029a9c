import time

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
import rclpy
from std_msgs.msg import String


def call(node, kind, name, request):
    client = node.create_client(kind, '/lc_talker/' + name)
    client.wait_for_service()
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def main():
    rclpy.init()
    node = rclpy.create_node('manager')
    heard = []
    node.create_subscription(String, 'lifecycle_chatter', heard.append, 10)
    offered = call(node, GetAvailableTransitions, 'get_available_transitions', GetAvailableTransitions.Request())
    print('offered:', [one.transition.label for one in offered.available_transitions])
    for number in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE):
        request = ChangeState.Request()
        request.transition.id = number
        done = call(node, ChangeState, 'change_state', request)
        print('done:', done.success, call(node, GetState, 'get_state', GetState.Request()).current_state.label)
    while len(heard) < 2:
        rclpy.spin_once(node)
    print('heard', heard[0].data[:24])
    for number in (Transition.TRANSITION_DEACTIVATE, Transition.TRANSITION_CLEANUP,
                   Transition.TRANSITION_UNCONFIGURED_SHUTDOWN):
        time.sleep(0.05)
        done = call(node, ChangeState, 'change_state', ChangeState.Request(transition=Transition(id=number)))
        print('done:', done.success, call(node, GetState, 'get_state', GetState.Request()).current_state.label)
    rclpy.shutdown()
