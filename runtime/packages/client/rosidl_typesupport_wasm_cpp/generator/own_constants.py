"""Reads each constant as one of the structure that it stands in.

Debian's rosidl_parser looks for a constant by its text, so one that the feedback of an action has like the
result is taken for a second one of the result. Importing this module mends that.
"""

from typing import Any, List, Optional

from lark.tree import Tree
from rosidl_parser import parser


def _find_path(node: Any, target: Any) -> Optional[List[Any]]:
    """Return the nodes from `node` down to `target`: this very one, none that is equal."""
    if node is target:
        return [node]
    for child in node.children:
        if isinstance(child, Tree):
            tail = _find_path(child, target)
            if tail is not None:
                return [node, *tail]
    return None


parser._find_path = _find_path
