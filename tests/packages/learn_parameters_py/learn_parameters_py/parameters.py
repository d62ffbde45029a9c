from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
import rclpy
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter


class MinimalParam(Node):

    def __init__(self):
        super().__init__('minimal_param_node')
        self.declare_parameter('my_parameter', 'world', ParameterDescriptor(description='Whom to greet'))
        self.declare_parameter('speed', 0.5, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0, step=0.0)]))
        self.declare_parameters('wheels', [('left', 1), ('right', 2)])
        self.add_on_set_parameters_callback(self.on_set)
        self.add_post_set_parameters_callback(self.after_set)
        self.timer = self.create_timer(0.1, self.timer_callback)
        self.rounds = 0

    def on_set(self, params):
        for param in params:
            if param.name == 'my_parameter' and param.value == 'nobody':
                return SetParametersResult(successful=False, reason='somebody must be greeted')
        return SetParametersResult(successful=True)

    def after_set(self, params):
        for param in params:
            self.get_logger().info('%s is now %s' % (param.name, param.value))

    def timer_callback(self):
        my_param = self.get_parameter('my_parameter').get_parameter_value().string_value
        self.get_logger().info('Hello %s!' % my_param)
        self.rounds += 1
        if self.rounds == 1:
            result, = self.set_parameters([Parameter('my_parameter', Parameter.Type.STRING, 'nobody')])
            self.get_logger().info('refused: %s' % result.reason)
            result, = self.set_parameters([Parameter('speed', value=9.0)])
            self.get_logger().info('too fast: %s' % (not result.successful))
            self.set_parameters([Parameter('my_parameter', Parameter.Type.STRING, 'moon')])
            wheels = self.get_parameters_by_prefix('wheels')
            self.get_logger().info('wheels: %s' % sorted((name, param.value) for name, param in wheels.items()))
            try:
                self.get_parameter('colour')
            except ParameterNotDeclaredException as error:
                self.get_logger().info('no such parameter: %s' % error)


def main():
    rclpy.init()
    node = MinimalParam()
    rclpy.spin(node)


if __name__ == '__main__':
    main()
