// Figures of Python programs: which topics are figures, what is told of them, where a picture stands, how keys read.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { TopicView } from '../../../runtime/site/contract/session.ts';
import { pngName, NO_FIGURE, modifiersOf, pixelIn, placeIn, pressCounter, readFigureControls } from '../../../runtime/site/ui/model/figure_controls.ts';
import { figuresOf, isFigure } from '../../../runtime/site/ui/model/figure_topics.ts';

const topic = (name: string, type: string, publishers: number) => ({ name, type, publishers }) as TopicView;

test('figures are images that a node publishes below /figures/PROGRAM', () => {
  assert.deepEqual(['/figures/plot/figure_1', '/figures/plot', '/figures/plot/figure_1/input', '/x/figures/a/b', '/cv2/a'].map(isFigure), [true, false, false,
    false, false]);
  const image = 'sensor_msgs/msg/Image';
  assert.deepEqual(
    figuresOf([topic('/figures/p/a', image, 1), topic('/figures/p/b', image, 0), topic('/figures/p/c', 'std_msgs/msg/String', 1), topic('/d', image, 1)]),
    ['/figures/p/a'],
  );
});

test('controls are those that make sense, whoever has sent them', () => {
  const told = { title: 'Odometry', tools: true, mode: 'zoom', back: true, forward: false, message: 'x=1', cursor: 'crosshair', rubberband: [1, 2, 3.5, 4] };
  assert.deepEqual(readFigureControls(JSON.stringify({ ...told, more: 1 })), told);
  for (const text of ['', '{', 'null', '[]', '7', '{"title": 1, "mode": "__proto__", "cursor": "url(x)", "rubberband": [1, 2, 3]}']) {
    assert.deepEqual(readFigureControls(text), NO_FIGURE, text);
  }
  for (const band of ['[1, 2, 3, "4"]', '[1, 2, 3, null]', '{"length": 4}', '[1, 2, 3, 1e999]'])
    assert.equal(readFigureControls(`{"rubberband": ${band}}`).rubberband, null, band);
  assert.equal(readFigureControls(JSON.stringify({ message: 'm'.repeat(9999) })).message.length, 500);
});

test('a picture stands in the middle, and is never larger than it is', () => {
  const small = placeIn({ width: 500, height: 300 }, { width: 100, height: 100 });
  assert.deepEqual(small, { scale: 1, left: 200, top: 100 });
  assert.deepEqual(pixelIn(small, { x: 210, y: 150 }), { x: 10, y: 50 });
  const large = placeIn({ width: 320, height: 480 }, { width: 640, height: 480 });
  assert.deepEqual(large, { scale: 0.5, left: 0, top: 120 });
  assert.deepEqual(pixelIn(large, { x: 160, y: 120 }), { x: 320, y: 0 });
});

test('two presses at one place within a moment are a double one, three are one and a double one', () => {
  const isSecond = pressCounter();
  const at = { x: 10, y: 10 };
  assert.deepEqual([isSecond(0, at, 0), isSecond(0, { x: 12, y: 9 }, 300), isSecond(0, at, 500)], [false, true, false]);
  assert.deepEqual([isSecond(2, at, 600), isSecond(2, { x: 30, y: 10 }, 700), isSecond(2, { x: 30, y: 10 }, 1200)], [false, false, false]);
});

test('modifiers and names of files', () => {
  assert.deepEqual(modifiersOf({ ctrlKey: true, altKey: false, shiftKey: true, metaKey: true }), ['ctrl', 'shift', 'super']);
  assert.deepEqual(['Figure_1.png', '../../a/b', '.bashrc', '', 'Odometry plot', 'x.PNG'].map(pngName), [
    'Figure_1.png',
    '_.._a_b.png',
    'bashrc.png',
    'figure.png',
    'Odometry plot.png',
    'x.PNG',
  ]);
});
