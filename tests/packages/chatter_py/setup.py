from setuptools import setup

setup(
    name='chatter_py',
    version='0.1.0',
    license='Apache-2.0',
    packages=['chatter_py'],
    scripts=['scripts/cloud', 'scripts/fresh', 'scripts/threads'],
    data_files=[
        ('share/chatter_py', ['package.xml']),
        ('share/ament_index/resource_index/packages', ['resource/chatter_py']),
    ],
    entry_points={'console_scripts': [
        'busy = chatter_py.busy:main', 'count = chatter_py.count:main', 'drive = chatter_py.drive:main',
        'errands = chatter_py.errands:main', 'hear = chatter_py.hear:main', 'life = chatter_py.life:main',
    ]},
)
