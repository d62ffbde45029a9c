"""Descriptions that every language must come to the same with. Names are their own in each case."""
from __future__ import annotations

from typing import Any

from tests.launch.launch_trees import Action, Sub, Text, action, part


def var(name: str, default: Text | None = None) -> Sub:
    return Sub('var', (name,) if default is None else (name, default))


def node(name: str, *parts: Action, **more: Any) -> Action:
    return action('node', *parts, pkg='demo', exec='talker', name=name, **more)


CASES: dict[str, list[Action]] = {
    'a node': [action('node', pkg='demo', exec='talker')],
    'a name and a namespace': [node('n1', namespace='x/y')],
    'an absolute namespace wins': [
        action('push_ros_namespace', namespace='p'), node('n2', namespace='/x'), node('n3', namespace='x')],
    'pushed namespaces add up and end with their group': [
        action('group', children=[
            action('push_ros_namespace', namespace='p'),
            action('group', children=[action('push_ros_namespace', namespace='q'), node('n4')]),
            node('n5')]),
        node('n6')],
    'types of parameters': [node('n7', *(part('param', name=name, value=value) for name, value in {
        'i': 1, 'd': 1.0, 's': 'one', 't': True, 'q': '1', 'e': '', 'y': 'yes', 'n': 'null', 'c': 'a: b # c',
        'quotes': '"\'', 'backslash': '\\n', 'dollar': '$(x) $y', 'minus': -3, 'small': 0.25}.items()))],
    'lists of parameters': [node('n8', part('param', name='i', value=[1, 2]), part('param', name='d', value=[1.0, 2.5]),
                                 part('param', name='m', value=[1, 2.5]), part('param', name='b', value=[True, False]),
                                 part('param', name='s', value=['a', 'b c', '3']))],
    'nested parameters': [node('n9', Action('param', {'name': 'p'}, [
        part('param', name='x', value=1), Action('param', {'name': 'q'}, [part('param', name='y', value='two')])]))],
    'parameters of substitutions are read as YAML': [
        action('let', name='v', value='3'), action('let', name='w', value='yes'),
        action('let', name='l', value='[1, 2]'),
        node('n10', part('param', name='i', value=var('v')), part('param', name='b', value=var('w')),
             part('param', name='l', value=var('l')), part('param', name='s', value=('x', var('v'))))],
    'parameters from files among others': [
        action('let', name='v', value='5'),
        node('n11', part('param', name='a', value=1), part('param', from_=(Sub('dirname'), '/p.yaml')),
             part('param', from_=(Sub('dirname'), '/p.yaml'), allow_substs=True), part('param', name='b', value=2))],
    'parameters of all nodes come before their own': [
        action('set_parameter', name='p', value=1), node('n12', part('param', name='p', value=2)),
        action('set_use_sim_time', value=True), node('n13')],
    'a text for all nodes': [action('set_parameter', name='p', value=var('none', 'text')), node('n14'),
                             action('log', message=('p is ', Sub('param', ('p',))))],
    'remappings of all nodes come before their own': [
        action('set_remap', from_='x', to='y'), node('n15', part('remap', from_='x', to='z')),
        node('n16', part('remap', from_=var('none', 'a'), to=('b', '/c')))],
    'words of a command line': [node('n17', args='--a b --c'), node('n18', args='one')],
    'conditions': [
        action('arg', name='c', default='False'), node('n19', if_=var('c')), node('n20', unless=var('c')),
        node('n21', if_='1'), node('n22', unless='true'), node('n23', if_=Sub('equals', (var('c'), 'False')))],
    'a group that is skipped': [action('group', if_='false', children=[node('n24')])],
    'variables end with their group, unless it is not scoped': [
        action('let', name='v', value='1'), action('group', children=[action('let', name='v', value='2')]),
        action('log', message=var('v')),
        action('group', scoped=False, children=[action('let', name='v', value='3')]), action('log', message=var('v'))],
    'a group that forwards only what is kept': [
        action('let', name='v', value='1'), action('let', name='w', value='2'),
        action('group', part('keep', name='w', value=var('w')), forwarding=False,
               children=[action('log', message=(var('v', 'none'), ' ', var('w')))])],
    'an argument with a default of another': [
        action('arg', name='a1', default='1'), action('arg', name='b1', default=(var('a1'), '2'), description='two')],
    'choices': [action('arg', part('choice', value='x'), part('choice', value='y'), name='d1', default='x')],
    'an include with arguments, each of which sees the ones before': [
        action('include', part('arg', name='x', value='7'), part('arg', name='y', value=(var('x'), '8')),
               file=(Sub('dirname'), '/inner.launch.xml')),
        action('log', message=(var('x'), var('y')))],
    'an include of YAML': [action('include', part('arg', name='x', value='7'), file='inner.launch.yaml')],
    'the environment': [
        action('set_env', name='E', value='1'), action('append_env', name='E', value='2'),
        action('append_env', name='E', value='0', prepend=True, separator=';'),
        node('n25', part('env', name='F', value=Sub('env', ('E',)))), action('unset_env', name='E'), node('n26')],
    'environment of the site, and defaults': [
        action('log', message=(Sub('env', ('ROS_DISTRO',)), ' ', Sub('env', ('NONE', 'x'))))],
    'timers add up': [action('timer', period=1.5, children=[
        action('timer', period=2.0, children=[node('n27')]), action('log', message='m')])],
    'the life of a process': [
        node('n28', respawn=True, respawn_delay=4.0, output='log'), node('n29', on_exit='shutdown', output='both')],
    'a shutdown': [action('timer', period=9.0, children=[action('shutdown', reason='done')])],
    'a command is skipped, and one that starts a node is not': [
        action('executable', cmd='webots -r'),
        action('executable', part('env', name='G', value='1'), cmd='ros2 run demo talker --loud')],
    'components of a container, and some more of them': [
        action('node_container', Action('composable_node', {'pkg': 'demo', 'plugin': 'demo::B', 'name': 'one',
                                                            'namespace': 'in'},
                                        [part('param', name='p', value=1), part('remap', from_='x', to='y')]),
               pkg='rclcpp_components', exec='component_container', name='box', namespace='c'),
        action('load_composable_node', part('composable_node', pkg='demo', plugin='demo::C', name='two'),
               target='/c/box')],
    'texts and quotes': [action('log', message='\'a\' "b" $(c) $ \\ d')],
    'substitutions in substitutions': [
        action('let', name='n', value='a b'), action('let', name='a b', value='it\'s "c"'),
        action('log', message=Sub('var', (var('n'),)))],
    'booleans': [action('log', message=(
        Sub('not', ('true',)), ' ', Sub('and', ('1', 'TRUE')), ' ', Sub('or', ('off', '0')), ' ',
        Sub('not', ('no',))))],
    'comparisons': [action('log', message=(
        Sub('equals', ('a', 'a')), Sub('equals', ('1', '1.0')), Sub('equals', ('1', 'true')),
        Sub('not-equals', ('a', 'b')), Sub('if', ('yes', 'x', 'y')), Sub('if', ('0', 'x', ''))))],
    'expressions': [
        action('arg', name='e1', default='4'),
        action('log', message=Sub('eval', ((var('e1'), ' * 2 > 7'),))),
        action('log', message=Sub('eval', (("'", var('e1'), "' + \"5\""),)))],
    'texts put together': [action('log', message=(
        Sub('string-join', (',', 'a', 'b')), ' ', Sub('anon', ('n',)), ' ',
        Sub('file-content', ((Sub('dirname'), '/note.txt'),))))],
    'paths of packages': [action('log', message=(Sub('find-pkg-share', ('demo',)), '/config'))],
    'forgotten variables': [
        action('group', children=[action('let', name='v', value='1'), action('reset'),
                                  action('log', message=var('v', 'gone'))])],
}
