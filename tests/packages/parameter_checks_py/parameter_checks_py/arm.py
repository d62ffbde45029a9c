"""A node whose parameters are of two YAML files, of which CMake made a module of one."""
import rclpy
from parameter_checks.made_by_cmake import made
from parameter_checks_py.arm_parameters import arm_py
from rclpy.node import Node


class Arm(Node):
    def __init__(self):
        super().__init__('arm_py')
        self.listener = arm_py.ParamListener(self)
        self.speed = made.ParamListener(self, 'made.').get_params().speed
        self.params = self.listener.get_params()
        self.say()
        self.create_timer(0.05, self.look)

    def look(self):
        if self.listener.is_old(self.params):
            self.listener.refresh_dynamic_parameters()
            self.params = self.listener.get_params()
            self.say()

    def say(self):
        gains = ' '.join(f'{joint}={self.params.pid.get_entry(joint).p}' for joint in self.params.joints)
        print(f'rate {self.params.rate} parity {self.params.parity} speed {self.speed} gains {gains}', flush=True)


def main():
    rclpy.init()
    node = Arm()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


if __name__ == '__main__':
    main()
