from setuptools import setup

setup(
    name='board_companions_py',
    version='0.1.0',
    license='Apache-2.0',
    packages=['board_companions_py'],
    data_files=[
        ('share/board_companions_py', ['package.xml']),
        ('share/ament_index/resource_index/packages', ['resource/board_companions_py']),
    ],
    entry_points={'console_scripts': [
        'manage = board_companions_py.manage:main', 'pictures = board_companions_py.pictures:main',
    ]},
)
