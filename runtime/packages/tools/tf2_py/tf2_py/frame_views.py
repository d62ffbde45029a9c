"""What a buffer holds, as text for people and tools."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tf2_py.time_cache import NS, StaticCache, TimeCache, seconds_text

SHORTEST_NS = 100_000
LEGEND = 'edge [style=invis];\n subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'


@dataclass
class Frame:
    """A frame, and who told of it last. Without a cache it is only known as a parent."""

    authority: str = 'no recorded authority'
    cache: TimeCache | StaticCache | None = None


Frames = dict[str, Frame]


def told(frames: Frames) -> Iterator[tuple[str, Frame, TimeCache | StaticCache, str]]:
    """Those that have a parent, with it."""
    for name, frame in frames.items():
        if frame.cache is not None and frame.cache.latest_parent is not None:
            yield name, frame, frame.cache, frame.cache.latest_parent


def rate(cache: TimeCache | StaticCache) -> float:
    return len(cache) * 1e9 / max(cache.latest - cache.oldest, SHORTEST_NS)


def seconds(duration_ns: int) -> str:
    return f'{duration_ns / NS:.3f}'


def as_string(frames: Frames) -> str:
    return ''.join(f'Frame {name} exists with parent {parent}.\n' for name, _, _, parent in told(frames))


def as_yaml(frames: Frames) -> str:
    text = '' if frames else '[]'
    for name, frame, cache, parent in told(frames):
        text += (f"{name}: \n  parent: '{parent}'\n  broadcaster: '{frame.authority}'\n  rate: {rate(cache):.3f}\n"
                 f'  most_recent_transform: {seconds_text(cache.latest)}\n'
                 f'  oldest_transform: {seconds_text(cache.oldest)}\n'
                 f'  buffer_length: {seconds(cache.latest - cache.oldest)}\n')
    return text


def as_dot(frames: Frames, now: int) -> str:
    """For Graphviz. `now`: 0 leaves out how old things are."""
    text = 'digraph G {\n'
    if not frames:
        text += '"no tf data recieved"'
    for name, frame, cache, parent in told(frames):
        old = f'( {seconds(now - cache.latest)} sec old)' if now else ''
        text += (f'"{parent}" -> "{name}"[label="Broadcaster: {frame.authority}\\nAverage rate: {rate(cache):.3f} Hz'
                 f'\\nMost recent transform: {seconds_text(cache.latest)} {old}'
                 f'\\nBuffer length: {seconds(cache.latest - cache.oldest)} sec\\n"];\n')
    # The legend hangs on the roots.
    recorded = f'"Recorded at time: {seconds_text(now)}"[ shape=plaintext ] ;\n ' if now else ''
    for name, frame in frames.items():
        is_empty = frame.cache is not None and frame.cache.latest_parent is None
        if is_empty or (frame.cache is None and now):
            text += f'{LEGEND}{recorded}}}->"{name}";\n'
    return text + '}'


def loop_error(frames: Frames) -> str:
    return f'The tf tree is invalid because it contains a loop.\n{as_string(frames)}\n'


def unconnected_error(target: str, source: str) -> str:
    return (f"Could not find a connection between '{target}' and '{source}' because they are not part of the same "
            'tree.Tf has two or more unconnected trees.')
