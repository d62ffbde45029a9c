from setuptools import find_packages, setup

package_name = 'bag_checks_py'

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
            'generator_py = bag_checks_py.generator:main',
            'recorder_py = bag_checks_py.recorder:main',
            'replayer_py = bag_checks_py.replayer:main',
        ],
    },
)
