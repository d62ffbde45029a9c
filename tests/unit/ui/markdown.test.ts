// Markdown as tokens, paths of its images, and links that act.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { headingId, readMarkdown, sitePath } from '../../../runtime/site/ui/model/markdown.ts';
import { isPageAction, readPageAction } from '../../../runtime/site/ui/model/page_action.ts';

const kinds = (text: string): unknown =>
  readMarkdown(text)?.flatMap((token) => token.type === 'paragraph' ? (token.tokens ?? []).map((inner) => [inner.type, inner.raw]) : [[token.type]]);

test('math stands between dollar signs, money does not', () => {
  assert.deepEqual(kinds('a $x^2$ b'), [['text', 'a '], ['inline_math', '$x^2$'], ['text', ' b']]);
  assert.deepEqual(kinds('5 $ or 6 $'), [['text', '5 $ or 6 $']]);
  assert.deepEqual(kinds('`$x$`'), [['codespan', '`$x$`']]);
  assert.deepEqual(kinds('$$\na\n$$\n'), [['block_math']]);
});

test('hostile texts end soon', { timeout: 60_000 }, () => {
  readMarkdown('> '.repeat(50_000));
  readMarkdown('['.repeat(5_000));
  readMarkdown('*a '.repeat(3_000));
  readMarkdown('$'.repeat(20_000));
  assert.equal(readMarkdown('x'.repeat(2_000_000)), null);
});

test('images are found beside the text, and nowhere else', () => {
  assert.equal(sitePath('text/lab/README.md', 'arm%201.svg'), 'text/lab/arm 1.svg');
  assert.equal(sitePath('text/lab/README.md', './../logo.svg?raw=1#x'), 'text/logo.svg');
  for (const path of ['../../site.json', '/x.png', 'https://a.example/x.png', 'data:image/png,', '//a.example/x', '%zz', '#a', 'JAVASCRIPT:x'])
    assert.ok([null, 'text/a.example/x'].includes(sitePath('text/README.md', path)), path);
});

test('headings have the names that links use', () => {
  assert.equal(headingId('Step 2: run `talker`!'), 'step-2-run-talker');
});

test('links that act say what they do, and nothing else counts', () => {
  assert.deepEqual(readPageAction('ros2wasm:open?panel=plot&paths=/a.b&paths=/c.d&seconds=5&held=true'), {
    kind: 'open',
    panel: 'plot',
    state: { paths: ['/a.b', '/c.d'], seconds: 5, held: true },
  });
  assert.deepEqual(readPageAction('ros2wasm:open?panel=console'), { kind: 'open', panel: 'console', state: null });
  assert.deepEqual(readPageAction('ros2wasm:start?node=talker'), { kind: 'start', node: 'talker' });
  assert.deepEqual(readPageAction('ros2wasm:publish?topic=/a&type=b/msg/C&value=%7Bx:%201%7D'), {
    kind: 'publish',
    topic: '/a',
    type: 'b/msg/C',
    value: '{x: 1}',
  });
  assert.deepEqual(readPageAction('ros2wasm:call?name=/add&value={a:%201,%20b:%202}'), { kind: 'call', name: '/add', type: '', value: '{a: 1, b: 2}' });
  assert.deepEqual(readPageAction('ros2wasm:goal?name=/count&type=demo/action/Count'), { kind: 'goal', name: '/count', type: 'demo/action/Count', value: '' });
  assert.deepEqual(readPageAction('ros2wasm:check'), { kind: 'check', name: '' });
  assert.deepEqual(readPageAction('ros2wasm:check?name=It%20moves'), { kind: 'check', name: 'It moves' });
  assert.deepEqual(readPageAction('ros2wasm:run?line=ros2%20topic%20list%20-t'), { kind: 'run', line: 'ros2 topic list -t' });
  assert.deepEqual(readPageAction('ros2wasm:pause'), { kind: 'pause' });
  assert.deepEqual(readPageAction('ros2wasm:resume?x=1'), { kind: 'resume' });
  assert.deepEqual(readPageAction('ros2wasm:step'), { kind: 'step', ms: 100 });
  assert.deepEqual(readPageAction('ros2wasm:step?ms=0.5'), { kind: 'step', ms: 0.5 });
  const wrong = ['call', 'call?value=1', 'goal?name=', 'run', 'run?line=%20', 'run?line=ros2%20topic%20list%0Aros2%20node%20list', 'run?line=a%1bb',
    'step?ms=0', 'step?ms=-1', 'step?ms=1e9', 'step?ms=x', 'step?ms=Infinity', 'Pause', 'pause%20', '__proto__', 'constructor?name=a'];
  for (const href of wrong) assert.equal(readPageAction(`ros2wasm:${href}`), null, href);
  for (
    const href of ['ros2wasm:', 'ros2wasm:open', 'ros2wasm:start?node=', 'ros2wasm:eval?x=1', 'ros2wasm:publish?topic=/a',
      `ros2wasm:start?node=${'x'.repeat(9000)}`]
  )
    assert.equal(readPageAction(href), null, href.slice(0, 40));
  assert.equal(isPageAction('https://a.example/ros2wasm:start?node=a'), false);
  const odd = readPageAction('ros2wasm:open?panel=plot&__proto__=1');
  assert.deepEqual(odd, { kind: 'open', panel: 'plot', state: null });
});
