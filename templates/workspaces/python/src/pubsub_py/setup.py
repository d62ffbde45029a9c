from setuptools import setup

package_name = 'pubsub_py'

setup(
    name=package_name,
    version='0.0.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='Your name',
    maintainer_email='you@example.invalid',
    description='A talker and a listener.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'talker = pubsub_py.talker:main',
            'listener = pubsub_py.listener:main',
        ],
    },
)
