from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
import rclpy
from rclpy.parameter_client import AsyncParameterClient


def main():
    rclpy.init()
    node = rclpy.create_node('setter')
    parameters = AsyncParameterClient(node, 'minimal_param_node')
    parameters.wait_for_services()
    greeted = ''
    while greeted != 'moon':
        future = parameters.get_parameters(['my_parameter'])
        rclpy.spin_until_future_complete(node, future)
        greeted = future.result().values[0].string_value

    client = node.create_client(SetParameters, '/minimal_param_node/set_parameters')
    client.wait_for_service()
    request = SetParameters.Request()
    value = ParameterValue(type=ParameterType.PARAMETER_STRING, string_value='sun')
    request.parameters = [Parameter(name='my_parameter', value=value)]
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    print('set:', future.result().results[0].successful)

    future = parameters.get_parameters(['my_parameter', 'speed'])
    rclpy.spin_until_future_complete(node, future)
    print('values:', [value.type for value in future.result().values], future.result().values[0].string_value)
    node.destroy_node()
    rclpy.shutdown()
