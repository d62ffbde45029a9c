import sys

from setuptools import setup

package_name = 'parameter_checks_py'

if len(sys.argv) >= 2 and sys.argv[1] != 'clean':
    from generate_parameter_library_py.setup_helper import generate_parameter_module

    generate_parameter_module(
        'arm_parameters', 'parameter_checks_py/arm_parameters.yaml',
        validation_module='parameter_checks_py.own_validators')

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    entry_points={'console_scripts': ['arm_py = parameter_checks_py.arm:main']},
)
