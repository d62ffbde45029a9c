from setuptools import find_packages, setup

package_name = 'learn_vision_py'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='ros2wasm',
    maintainer_email='maintainers@example.com',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'camera = learn_vision_py.camera:main',
            'colour_tracker = learn_vision_py.colour_tracker:main',
            'lane_finder = learn_vision_py.lane_finder:main',
            'marker_pose = learn_vision_py.marker_pose:main',
        ],
    },
)
