"""launch's actions: what each was made with becomes an entity."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from ros2wasm_launch import host
from ros2wasm_launch.entities import Entity, entities_of
from ros2wasm_launch.texts import flag, text_of

from .action import Action
from .launch_description_sources import LaunchDescriptionSource
from .utilities import normalize_to_list_of_substitutions, perform_substitutions


def _optional(value: Any) -> str | None:
    return None if value is None else text_of(value)


def _pairs(pairs: Any) -> list[tuple[Any, Any]]:
    return list(pairs.items() if isinstance(pairs, Mapping) else pairs or ())


class DeclareLaunchArgument(Action):
    def __init__(self, name: str, *, default_value: Any = None, description: str | None = None,
                 choices: Iterable[str] | None = None, **more: Any) -> None:
        super().__init__(**more)
        self.name = name
        self.default_value = default_value
        self.description = description or 'no description given'
        self.choices = None if choices is None else list(choices)
        self._described = description

    def _entities(self) -> list[Entity]:
        choices = [self._part('choice', value=text_of(one)) for one in self.choices or ()]
        return [self._entity('arg', {'name': text_of(self.name), 'default': _optional(self.default_value),
                                     'description': _optional(self._described)}, choices)]


class SetLaunchConfiguration(Action):
    def __init__(self, name: Any, value: Any, **more: Any) -> None:
        super().__init__(**more)
        self.name, self.value = name, value

    def _entities(self) -> list[Entity]:
        value = str(self.value) if isinstance(self.value, (bool, int, float)) else self.value
        return [self._entity('let', {'name': text_of(self.name), 'value': text_of(value)})]


class UnsetLaunchConfiguration(Action):
    def __init__(self, name: Any, **more: Any) -> None:
        super().__init__(**more)
        self.name = name

    def _entities(self) -> list[Entity]:
        return [self._entity('unlet', {'name': text_of(self.name)})]


class SetEnvironmentVariable(Action):
    def __init__(self, name: Any, value: Any, **more: Any) -> None:
        super().__init__(**more)
        self.name, self.value = name, value

    def _entities(self) -> list[Entity]:
        return [self._entity('set_env', {'name': text_of(self.name), 'value': text_of(self.value)})]


class UnsetEnvironmentVariable(Action):
    def __init__(self, name: Any, **more: Any) -> None:
        super().__init__(**more)
        self.name = name

    def _entities(self) -> list[Entity]:
        return [self._entity('unset_env', {'name': text_of(self.name)})]


class AppendEnvironmentVariable(Action):
    def __init__(self, name: Any, value: Any, prepend: Any = False, separator: Any = ':', **more: Any) -> None:
        super().__init__(**more)
        self.name, self.value, self.prepend, self.separator = name, value, prepend, separator

    def _entities(self) -> list[Entity]:
        return [self._entity('append_env', {
            'name': text_of(self.name), 'value': text_of(self.value), 'prepend': flag(self.prepend),
            'separator': text_of(self.separator)})]


class ResetEnvironment(Action):
    def __init__(self, **more: Any) -> None:
        super().__init__(**more)

    def _entities(self) -> list[Entity]:
        return [self._entity('reset_env')]


class ResetLaunchConfigurations(Action):
    def __init__(self, launch_configurations: Any = None, **more: Any) -> None:
        super().__init__(**more)
        self.launch_configurations = _pairs(launch_configurations)

    def _entities(self) -> list[Entity]:
        return [self._entity('reset', {}, [self._part('keep', name=text_of(name), value=text_of(value))
                                           for name, value in self.launch_configurations])]


class _Bracket(Action):
    """Keeps or gives back all that a group would."""

    _tag = ''

    def __init__(self, **more: Any) -> None:
        super().__init__(**more)

    def _entities(self) -> list[Entity]:
        return [self._entity(self._tag)]


class PushLaunchConfigurations(_Bracket):
    _tag = 'push_configurations'


class PopLaunchConfigurations(_Bracket):
    _tag = 'pop_configurations'


class PushEnvironment(_Bracket):
    _tag = 'push_environment'


class PopEnvironment(_Bracket):
    _tag = 'pop_environment'


class GroupAction(Action):
    def __init__(self, actions: Iterable[Any], *, scoped: bool = True, forwarding: bool = True,
                 launch_configurations: Any = None, **more: Any) -> None:
        super().__init__(**more)
        self.actions = list(actions)
        self.scoped, self.forwarding = scoped, forwarding
        self.launch_configurations = _pairs(launch_configurations)

    def get_sub_entities(self) -> list[Any]:
        return self.actions

    def _entities(self) -> list[Entity]:
        kept = [self._part('keep', name=text_of(name), value=text_of(value))
                for name, value in self.launch_configurations]
        attributes = {'scoped': flag(self.scoped), 'forwarding': flag(self.forwarding)}
        return [self._entity('group', attributes, kept + entities_of(self.actions))]


class IncludeLaunchDescription(Action):
    def __init__(self, launch_description_source: Any, *, launch_arguments: Any = None, **more: Any) -> None:
        super().__init__(**more)
        is_source = isinstance(launch_description_source, LaunchDescriptionSource)
        self.launch_description_source = (
            launch_description_source if is_source else LaunchDescriptionSource(None, launch_description_source))
        self.launch_arguments = _pairs(launch_arguments)

    def _entities(self) -> list[Entity]:
        set_before = [(text_of(name), text_of(value)) for name, value in self.launch_arguments]
        source = self.launch_description_source
        if source.launch_description is None:
            arguments = [self._part('arg', name=name, value=value) for name, value in set_before]
            return [self._entity('include', {'file': text_of(source._location)}, arguments)]
        inner = [self._part('let', name=name, value=value) for name, value in set_before]
        return [self._entity('group', {'scoped': False}, inner + entities_of(source.launch_description))]


class LogInfo(Action):
    _level = 'info'

    def __init__(self, *, msg: Any, **more: Any) -> None:
        super().__init__(**more)
        self.msg = msg

    def _entities(self) -> list[Entity]:
        return [self._entity('log', {'message': text_of(self.msg), 'level': self._level})]


class LogDebug(LogInfo):
    _level = 'debug'


class LogWarning(LogInfo):
    _level = 'warning'


class LogError(LogInfo):
    _level = 'error'


class Log(LogInfo):
    def __init__(self, *, msg: Any, level: Any, **more: Any) -> None:
        super().__init__(msg=msg, **more)
        self._level = text_of(level)


class Shutdown(Action):
    def __init__(self, *, reason: Any = 'reason not given', due_to_sigint: bool = False, **more: Any) -> None:
        super().__init__(**more)
        self.reason = reason

    def _entities(self) -> list[Entity]:
        return [self._entity('shutdown', {'reason': text_of(self.reason)})]


class TimerAction(Action):
    def __init__(self, *, period: Any, actions: Iterable[Any], cancel_on_shutdown: Any = True, **more: Any) -> None:
        super().__init__(**more)
        self.period, self.actions = period, list(actions)

    def _entities(self) -> list[Entity]:
        return [self._entity('timer', {'period': flag(self.period)}, entities_of(self.actions))]

    def cancel(self) -> None:
        self.actions = []


class OpaqueFunction(Action):
    """Called when the evaluator comes to it; what it gives back takes its place."""

    def __init__(self, *, function: Callable[..., Any], args: Iterable[Any] | None = None,
                 kwargs: Mapping[str, Any] | None = None, **more: Any) -> None:
        super().__init__(**more)
        self._function, self._args, self._kwargs = function, list(args or ()), dict(kwargs or {})

    def execute(self, context: Any) -> Any:
        return self._function(context, *self._args, **self._kwargs)


class OpaqueCoroutine(Action):
    """Runs beside the launch, where a site has nothing."""

    def __init__(self, *, coroutine: Callable[..., Any], **more: Any) -> None:
        super().__init__(**{key: value for key, value in more.items() if key == 'condition'})

    def _entities(self) -> list[Entity]:
        return [self._entity('left_out', {'what': 'OpaqueCoroutine'})]


class ForEach(Action):
    """Calls a function with each of the mappings that a text in YAML has, with `;` between them."""

    SEPARATOR = ';'

    def __init__(self, input_values: Any, *, function: Callable[..., Any], **more: Any) -> None:
        super().__init__(**more)
        self.input_values, self.function = normalize_to_list_of_substitutions(input_values), function

    def execute(self, context: Any) -> Any:
        import yaml

        text = perform_substitutions(context, self.input_values)
        turns = [yaml.safe_load(one.strip()) for one in text.strip().split(self.SEPARATOR) if one]
        return [self.function(**values) for values in turns if values is not None]


class ForLoop(Action):
    """Calls a function with `i` from 0 on."""

    def __init__(self, length: Any, *, function: Callable[..., Any], name: str | None = None, **more: Any) -> None:
        super().__init__(**more)
        self.length = normalize_to_list_of_substitutions(length)
        self.function, self.name = function, name

    def execute(self, context: Any) -> Any:
        return [self.function(i=i) for i in range(int(perform_substitutions(context, self.length)))]


#: Those that the launch files have made.
PROCESSES: list[ExecuteLocal] = []


class ExecuteLocal(Action):
    """A process. What starts and ends it, and what follows from its end."""

    def __init__(self, *, process_description: Any = None, on_exit: Any = None, respawn: Any = False,
                 respawn_delay: float | None = None, respawn_max_retries: int | None = None, output: Any = None,
                 additional_env: Any = None, env: Any = None, cwd: Any = None, prefix: Any = None,
                 shell: Any = False, sigterm_timeout: Any = None, sigkill_timeout: Any = None,
                 emulate_tty: Any = None, output_format: Any = None, cached_output: Any = None, log_cmd: Any = None,
                 name: Any = None, condition: Any = None) -> None:
        super().__init__(condition=condition)
        PROCESSES.append(self)
        self._on_exit = on_exit
        self._process_name = name
        self._set = [*_pairs(env), *_pairs(additional_env)]
        self.cmd: list[Any] = []
        if process_description is not None:
            self.cmd = process_description.cmd
            self._process_name = name or process_description.name
            self._set = [*_pairs(process_description.env), *_pairs(process_description.additional_env)]
        self._respawn, self._respawn_delay = respawn, respawn_delay
        self._max_retries = respawn_max_retries
        self._output = output
        self._shell = shell

    def _process_attributes(self) -> dict[str, Any]:
        attributes: dict[str, Any] = {'process': host.OBJECTS.number(self), 'respawn': flag(self._respawn)}
        if self._respawn_delay is not None:
            attributes['respawn_delay'] = flag(self._respawn_delay)
        if self._max_retries is not None:
            attributes['respawn_max_retries'] = flag(self._max_retries)
        output = self._output
        if isinstance(output, Mapping):
            output = 'screen' if 'screen' in str(output.values()) else 'log'
        attributes['output'] = _optional(output)
        return attributes

    def _env_parts(self) -> list[Entity]:
        return [self._part('env', name=text_of(name), value=text_of(value)) for name, value in self._set]

    def _followed(self, process: Entity) -> list[Entity]:
        """The process, and what its end brings."""
        if self._on_exit is None:
            return [process]
        from .event_handlers import OnProcessExit

        return [*RegisterEventHandler(OnProcessExit(target_action=self, on_exit=self._on_exit))._entities(), process]

    def _entities(self) -> list[Entity]:
        attributes = {'cmd': [text_of(one) for one in self.cmd], 'shell': flag(self._shell),
                      'name': _optional(self._process_name), **self._process_attributes()}
        return self._followed(self._entity('executable', attributes, self._env_parts()))


class ExecuteProcess(ExecuteLocal):
    def __init__(self, *, cmd: Iterable[Any], **more: Any) -> None:
        super().__init__(**more)
        self.cmd = list(cmd)


class RegisterEventHandler(Action):
    def __init__(self, event_handler: Any, **more: Any) -> None:
        super().__init__(**more)
        self.event_handler = event_handler

    def _register(self, _context: Any) -> None:
        from .event_handlers import REGISTERED

        REGISTERED.append(self.event_handler)

    def _entities(self) -> list[Entity]:
        followed = [self._entity('on_event', attributes, entities_of(made))
                    for attributes, made in self.event_handler._followed()]
        if self.condition is None:
            self._register(None)  # natively too, what is emitted before is heard
            return followed
        return [*followed, self._entity('python', {'call': host.OBJECTS.number(self._register)})]


class UnregisterEventHandler(Action):
    def __init__(self, event_handler: Any, **more: Any) -> None:
        super().__init__(**more)
        self.event_handler = event_handler

    def _forget(self, _context: Any) -> None:
        from .event_handlers import REGISTERED

        if self.event_handler in REGISTERED:
            REGISTERED.remove(self.event_handler)

    def _entities(self) -> list[Entity]:
        return [self._entity('forget_event', {'handler': host.OBJECTS.number(self.event_handler)}),
                self._entity('python', {'call': host.OBJECTS.number(self._forget)})]


class EmitEvent(Action):
    def __init__(self, *, event: Any, **more: Any) -> None:
        super().__init__(**more)
        self.event = event

    def _emit(self, context: Any) -> Any:
        """What those do who hear of it."""
        from .event_handlers import REGISTERED

        done = []
        for handler in reversed(REGISTERED):
            if not handler._hears(self.event):
                continue
            if handler.handle_once:
                REGISTERED.remove(handler)
            done.append(handler.handle(self.event, context))
        return done

    def _entities(self) -> list[Entity]:
        from .events import Shutdown as ShutdownEvent
        from .events.process import ShutdownProcess, SignalProcess

        if isinstance(self.event, ShutdownEvent):
            return [self._entity('shutdown', {'reason': text_of(self.event.reason)})]
        transition = getattr(self.event, '_transition', None)
        if transition is not None:
            return [self._entity('lifecycle_transition', attributes) for attributes in transition()]
        if isinstance(self.event, (ShutdownProcess, SignalProcess)):
            if not self.event._ends:
                return [self._entity('left_out', {'what': f'the signal {self.event.signal_name}'})]
            return [self._entity('end_process', {'process': host.OBJECTS.number(one)})
                    for one in PROCESSES if self.event.process_matcher(one)]
        return [self._entity('python', {'call': host.OBJECTS.number(self._emit)})]


__all__ = [name for name, thing in list(globals().items())
           if isinstance(thing, type) and issubclass(thing, Action) and not name.startswith('_')]
