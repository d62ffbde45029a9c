"""The kernel of notebooks: cells in, events out; on a bus within the process."""
from __future__ import annotations

import builtins
import importlib
import json
import sys
import time
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest

Event = dict[str, Any]


class KernelTest(BusTest):
    """Runs cells, and has the events that they cause."""

    def setUp(self) -> None:
        super().setUp()
        self.events: list[Event] = []
        self.bus.typed.clear()
        self.bus.rest = b''
        self.ahead = 0
        self.replace('tell', self.tell)
        self.replace('forget_stop', lambda: None)
        for module, names in ((sys, ('stdin', 'stdout', 'stderr', 'argv')), (builtins, ('input',))):
            for name in names:
                self.enterContext(mock.patch.object(module, name, getattr(module, name)))
        self.enterContext(mock.patch.dict(sys.modules))
        self.node_class = importlib.import_module('rclpy.node').Node
        self.enterContext(mock.patch.object(self.node_class, '__init__', self.node_class.__init__))
        self.notebook = importlib.import_module('ros2wasm.notebook')

    def tell(self, text: str) -> int:
        self.events.append(json.loads(text))
        return self.ahead

    def run_cells(self, *sources: str, more: tuple[Any, ...] = ()) -> list[list[Event]]:
        """What each did, without its begin and end."""
        for at, source in enumerate(sources):
            self.bus.typed.append(json.dumps({'cell': f'c{at}', 'code': source}).encode() + b'\n')
        self.bus.typed.extend(more)
        self.bus.typed.append(b'')
        self.assertEqual(self.notebook.main(), 0)
        self.assertEqual(self.events[0], {'event': 'idle', 'cell': ''})
        for at in range(len(sources)):
            names = [event['event'] for event in self.events if event['cell'] == f'c{at}']
            self.assertEqual([names[0], names[-1]], ['begin', 'end'])
        return [[{name: part for name, part in event.items() if name != 'cell'} for event in self.events
                 if event['cell'] == f'c{at}' and event['event'] not in ('begin', 'end')] for at in range(len(sources))]

    def good(self) -> list[bool]:
        return [event['good'] for event in self.events if event['event'] == 'end']


class NotebookTest(KernelTest):
    # Compatibility, works: notebooks: a cell's last value is its result, `;` hides it; names live on in the next cell
    def test_values(self) -> None:
        first, second, third, fourth = self.run_cells('x = 20\nx + 1', '_ * 2', 'x;', 'None')
        self.assertEqual(first, [{'event': 'result', 'count': 1, 'data': {'text/plain': '21'}, 'metadata': {}}])
        self.assertEqual((second[0]['data'], second[0]['count']), ({'text/plain': '42'}, 2))
        self.assertEqual((third, fourth), ([], []))
        self.assertEqual(self.good(), [True] * 4)

    def test_prints_line_by_line(self) -> None:
        first, second = self.run_cells(
            'import sys\nprint("a", 1)\nprint("b", end="")\nprint("e", file=sys.stderr)', 'print("x\\n" * 2_000_000)')
        self.assertEqual([(event['name'], event['text']) for event in first],
                         [('stdout', 'a 1\n'), ('stderr', 'e\n'), ('stdout', 'b')])
        # Output that is too long is cut.
        printed = ''.join(event['text'] for event in second)
        self.assertLess(len(printed), (1 << 20) + 200)
        self.assertIn('the rest is not shown', printed)

    def test_errors_name_cell_and_line(self) -> None:
        first, second, third = self.run_cells('def f():\n    return 1 / 0\n', 'f()', 'x = = 1')
        self.assertEqual(first, [])
        self.assertEqual((second[0]['ename'], second[0]['evalue']), ('ZeroDivisionError', 'division by zero'))
        told = '\n'.join(second[0]['traceback'])
        self.assertIn('File "Cell [1]", line 2, in f\n    return 1 / 0', told)
        self.assertIn('File "Cell [2]", line 1, in <module>', told)
        self.assertNotIn('notebook.py', told)
        self.assertEqual(third[0]['ename'], 'SyntaxError')
        self.assertEqual(self.good(), [True, False, False])

    # Compatibility, differs: notebooks: lines for IPython (`%matplotlib`, `!ls`) -> do nothing, and say so
    def test_magics_do_nothing(self) -> None:
        first, second, third = self.run_cells(
            '%load_ext tools\n5', '%%bash\nls', '%matplotlib inline\nx = (7\n  % 4\n  != 2)\nx')
        self.assertIn('line 1 does nothing here: `%load_ext tools`', first[0]['text'])
        self.assertEqual(first[1]['data'], {'text/plain': '5'})
        self.assertEqual(second[0]['ename'], 'SyntaxError')
        # Figures are shown below the cell anyhow.
        self.assertEqual([event['data'] for event in third], [{'text/plain': 'True'}])

    def test_what_cannot_be_said_ends_nothing(self) -> None:
        first, second = self.run_cells(
            'class E(Exception):\n    def __str__(self): return self.missing\nraise E()',
            'from IPython.display import JSON, display\n'
            'display(JSON({"x": float("nan")}), metadata={"y": float("inf")})')
        self.assertEqual(first[0]['evalue'], '<E whose str() fails>')
        self.assertNotIn('application/json', second[0]['data'])
        self.assertEqual(second[0]['metadata'], {})

    # Compatibility, works: notebooks: values show themselves as HTML, SVG, PNG, Markdown and LaTeX; `display` and
    # IPython.display
    def test_rich_values(self) -> None:
        first, second, third = self.run_cells(
            'class Rich:\n'
            '    def _repr_html_(self): return "<b>rich</b>"\n'
            '    def _repr_png_(self): return b"\\x89PNG"\n'
            '    def _repr_svg_(self): raise ValueError\n'
            '    def __repr__(self): return "Rich"\n'
            'Rich()',
            'from IPython.display import Markdown, Image, display, clear_output, update_display, HTML\n'
            'display(Markdown("# a"), 5)\nshown = display(HTML("<i>1</i>"), display_id=True)\n'
            'shown.update(HTML("<i>2</i>"))\n'
            'clear_output(wait=True)\ndisplay(Image(b"\\x89PNG", width=40))',
            'from IPython.display import HTML\nHTML(url="https://web.example")')
        self.assertEqual(first[0]['data'], {'text/plain': 'Rich', 'text/html': '<b>rich</b>', 'image/png': 'iVBORw=='})
        self.assertEqual([event['event'] for event in second],
                         ['display', 'display', 'display', 'update', 'clear', 'display'])
        self.assertEqual(second[0]['data']['text/markdown'], '# a')
        self.assertEqual(second[2]['display_id'], second[3]['display_id'])
        self.assertEqual(second[3]['data']['text/html'], '<i>2</i>')
        self.assertEqual(second[5]['metadata'], {'image/png': {'width': 40}})
        self.assertEqual(third[0]['ename'], 'ValueError')

    # Compatibility, works: notebooks: `await` in a cell, `asyncio` tasks across cells
    def test_awaits(self) -> None:
        first, second, third = self.run_cells(
            'import asyncio\nasync def later():\n    await asyncio.sleep(0.01)\n    return 7\nawait later()',
            'task = asyncio.ensure_future(later())\nawait asyncio.sleep(0)',
            'await task')
        self.assertEqual(first[0].get('data'), {'text/plain': '7'}, first)
        self.assertEqual((second, third[0]['data']), ([], {'text/plain': '7'}))

    # Compatibility, works: notebooks: nodes publish, hear, call and answer, with `rclpy.spin_once`, with
    # `rclpy.spin_until_future_complete` and with `await`
    def test_nodes(self) -> None:
        first, second, third, fourth, fifth = self.run_cells(
            'import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nnode = rclpy.create_node("lab")\nheard = []\n'
            'node.create_subscription(String, "topic_a", lambda m: heard.append(m.data), 10)\n'
            'pub = node.create_publisher(String, "topic_a", 10)\npub.publish(String(data="one"))\n'
            'while not heard: rclpy.spin_once(node, timeout_sec=0.1)\nheard',
            'pub.publish(String(data="two"))\nimport asyncio\nwhile len(heard) < 2: await asyncio.sleep(0.005)\nheard',
            'from example_interfaces.srv import AddTwoInts\n'
            'def add(request, response):\n    response.sum = request.a + request.b\n    return response\n'
            'node.create_service(AddTwoInts, "add", add)\nclient = node.create_client(AddTwoInts, "add")\n'
            '(await client.call_async(AddTwoInts.Request(a=2, b=3))).sum',
            'future = client.call_async(AddTwoInts.Request(a=40, b=2))\n'
            'rclpy.spin_until_future_complete(node, future)\nfuture.result().sum',
            'def fails(m): raise RuntimeError("in a callback")\n'
            'node.create_subscription(String, "topic_b", fails, 10)\n'
            'node.create_publisher(String, "topic_b", 10).publish(String())\nawait asyncio.sleep(5)')
        self.assertEqual(first[-1]['data'], {'text/plain': "['one']"})
        self.assertEqual(second[-1]['data'], {'text/plain': "['one', 'two']"})
        self.assertEqual(third[-1].get('data'), {'text/plain': '5'}, third)
        self.assertEqual(fourth[-1].get('data'), {'text/plain': '42'}, fourth)
        self.assertEqual(fifth[-1]['evalue'], 'in a callback')
        importlib.import_module('rclpy').shutdown()

    def test_asks_for_input(self) -> None:
        first, = self.run_cells('input("name? ")', more=(b'{"input": "Ada"}\n',))
        self.assertEqual(first[0], {'event': 'input', 'prompt': 'name? '})
        self.assertEqual(first[1]['text'], 'name? Ada\n')
        self.assertEqual(first[2]['data'], {'text/plain': "'Ada'"})

    # Compatibility, works: notebooks: an interrupt ends a cell that waits, with KeyboardInterrupt; the next cells run
    def test_interrupt(self) -> None:
        first, second = self.run_cells(
            'import _thread\ntry:\n    _thread.interrupt_main()\n    for _ in range(10**8): pass\n'
            'finally:\n    left = True',
            'left')
        self.assertEqual(first[0]['ename'], 'KeyboardInterrupt')
        self.assertEqual(second[0]['data'], {'text/plain': 'True'})

    def test_rests_while_the_page_is_behind(self) -> None:
        self.ahead = 1000
        begin = time.monotonic()
        self.run_cells('print(1)\nprint(2)')
        self.assertGreater(time.monotonic() - begin, 0.04)
