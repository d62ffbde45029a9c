from setuptools import setup

setup(
    name='frames_py',
    version='0.1.0',
    license='Apache-2.0',
    packages=['frames_py'],
    scripts=['scripts/rotations', 'scripts/scipy_rotations', 'scripts/turns'],
    data_files=[
        ('share/frames_py', ['package.xml']),
        ('share/frames_py/config', ['config/frames.yaml']),
        ('share/ament_index/resource_index/packages', ['resource/frames_py']),
    ],
    entry_points={'console_scripts': [
        'drive = frames_py.drive:main', 'follow = frames_py.follow:main', 'wait = frames_py.wait:main',
    ]},
)
