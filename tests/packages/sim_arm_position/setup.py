from glob import glob

from setuptools import find_packages, setup

package_name = 'sim_arm_position'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', glob('launch/*')),
        ('share/' + package_name + '/urdf', glob('urdf/*')),
        ('share/' + package_name + '/worlds', glob('worlds/*')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='ros2wasm',
    maintainer_email='maintainers@example.com',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'reacher = sim_arm_position.reacher:main',
        ],
    },
)
