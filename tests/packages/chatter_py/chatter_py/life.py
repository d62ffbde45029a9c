"""A managed node is led through its life by a client of its services; parameters, events and bytes on the way."""
import asyncio
import os

import rclpy
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from example_interfaces.srv import AddTwoInts
from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler
from rclpy.qos import qos_profile_system_default
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


class Lamp(LifecycleNode):
    def on_configure(self, state):
        self.light = self.create_lifecycle_publisher(String, 'light', 10)
        self.declare_parameter('colour', 'white')
        return super().on_configure(state)

    def on_cleanup(self, state):
        raise RuntimeError('the lamp is broken')

    def on_error(self, state):
        return TransitionCallbackReturn.SUCCESS


def main():
    with rclpy.init():
        lamp, user = Lamp('lamp'), rclpy.create_node('user')
        executor = SingleThreadedExecutor()
        for node in (lamp, user):
            executor.add_node(node)
        states, lights, colours, calls = [], [], [], []
        user.create_subscription(
            TransitionEvent, 'lamp/transition_event', lambda event: states.append(event.goal_state.label), 20)
        user.create_subscription(String, 'light', lambda message: lights.append(message.data), 10)
        ParameterEventHandler(user).add_parameter_callback(
            'colour', 'lamp', lambda parameter: colours.append(parameter.value.string_value))
        switch = user.create_client(ChangeState, 'lamp/change_state')

        def wait(future):
            executor.spin_until_future_complete(future, 100)
            return future.result()

        def step(transition):
            return wait(switch.call_async(ChangeState.Request(transition=Transition(id=transition)))).success
        steps = [step(Transition.TRANSITION_CONFIGURE), step(Transition.TRANSITION_CONFIGURE)]
        lamp.light.publish(String(data='too early'))
        steps.append(step(Transition.TRANSITION_ACTIVATE))
        lamp.light.publish(String(data='shines'))
        steps += [step(Transition.TRANSITION_DEACTIVATE), step(Transition.TRANSITION_CLEANUP)]
        parameters = AsyncParameterClient(user, 'lamp')
        wait(parameters.set_parameters([Parameter('colour', value='red')]))
        while 'red' not in colours or not lights:
            executor.spin_once(timeout_sec=1)
        print('managed', steps, lights, colours)
        print('states', *states)

        lamp.create_service(AddTwoInts, 'add', lambda request, response: response)
        adder = user.create_client(AddTwoInts, 'add')
        adder.configure_introspection(
            user.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)
        user.create_subscription(
            AddTwoInts.Event, 'add/_service_event',
            lambda event: calls.append((event.info.event_type, len(event.request))), 10)
        wait(adder.call_async(AddTwoInts.Request(a=1)))
        while len(calls) < 2:
            executor.spin_once(timeout_sec=1)
        print('calls', calls)

        bytes_ = serialize_message(String(data='bytes'))
        print('bytes', deserialize_message(bytes_, String).data)
        print('waited', wait_for_message(String, user, 'chatter')[0])
        print('nothing', wait_for_message(String, user, 'silence', time_to_wait=0.1))

        async def later():
            ticks = asyncio.create_task(asyncio.sleep(0.01, 'slept'))
            spun = rclpy.task.Future()
            user.create_timer(0.01, lambda: spun.set_result('spun'))
            while not spun.done():
                rclpy.spin_once(user, timeout_sec=0.01)
                await asyncio.sleep(0)
            return await ticks, await spun
        executor.remove_node(user)
        print('asyncio', *asyncio.run(later()))
    with open(os.path.join(get_package_share_directory('test_share'), 'words.txt'), encoding='utf-8') as words:
        print('share', words.read())
    try:
        get_package_share_directory('no_such_package')
    except PackageNotFoundError as error:
        print('index', str(error).split(',')[0], os.environ['HOME'])
