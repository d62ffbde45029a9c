from setuptools import setup

setup(
    name='relay',
    version='1.0.0',
    packages=['relay'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/relay']),
        ('share/relay', ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    entry_points={'console_scripts': ['relay = relay.relay:main']},
)
