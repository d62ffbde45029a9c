"""The definitions of message types, as bags have them."""
from __future__ import annotations

from rosbag2_py._storage import MessageDefinition
from ros2wasm.definition import DefinitionError
from ros2wasm.types import find_structure, source_of

LINE = '=' * 80


class LocalMessageDefinitionSource:
    """A site has the definitions of all types that its Python nodes may use."""

    def get_full_text(self, topic_type: str) -> MessageDefinition:
        """With those of all types inside it. RuntimeError with the type's name: there is none."""
        inside: set[str] = set()
        queue = [topic_type]
        try:
            if topic_type.split('/')[1] != 'msg':
                raise KeyError(topic_type)
            while queue:
                for field in find_structure(queue.pop()).fields:
                    if field.type.is_message and field.type.base not in inside:
                        inside.add(field.type.base)
                        queue.append(field.type.base)
            text = source_of(topic_type)
            for name in sorted(inside):
                package, _, short = name.split('/')
                text += f'\n{LINE}\nMSG: {package}/{short}\n{source_of(name)}'
        except (KeyError, IndexError, ValueError, DefinitionError) as error:
            raise RuntimeError(topic_type) from error
        return MessageDefinition(topic_type, 'ros2msg', text, '')
