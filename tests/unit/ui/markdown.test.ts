// Markdown as tokens, paths of its images, and links that act.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { headingId, readMarkdown, sitePath } from '../../../runtime/ui/model/markdown.ts';
import { isPageAction, readPageAction } from '../../../runtime/ui/model/page_action.ts';

const kinds = (text: string): unknown =>
  readMarkdown(text)?.flatMap((token) =>
    token.type === 'paragraph' ? (token.tokens ?? []).map((inner) => [inner.type, inner.raw]) : [[token.type]],
  );

test('math stands between dollar signs, money does not', () => {
  assert.deepEqual(kinds('a $x^2$ b'), [['text', 'a '], ['inline_math', '$x^2$'], ['text', ' b']]);
  assert.deepEqual(kinds('5 $ or 6 $'), [['text', '5 $ or 6 $']]);
  assert.deepEqual(kinds('`$x$`'), [['codespan', '`$x$`']]);
  assert.deepEqual(kinds('$$\na\n$$\n'), [['block_math']]);
});

test('hostile texts end soon', { timeout: 60_000 }, () => {
  readMarkdown('> '.repeat(50_000));
  readMarkdown('[' .repeat(5_000));
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
    kind: 'open', panel: 'plot', state: { paths: ['/a.b', '/c.d'], seconds: 5, held: true },
  });
  assert.deepEqual(readPageAction('ros2wasm:open?panel=console'), { kind: 'open', panel: 'console', state: null });
  assert.deepEqual(readPageAction('ros2wasm:start?node=talker'), { kind: 'start', node: 'talker' });
  assert.deepEqual(readPageAction('ros2wasm:publish?topic=/a&type=b/msg/C&value=%7Bx:%201%7D'), {
    kind: 'publish', topic: '/a', type: 'b/msg/C', value: '{x: 1}',
  });
  for (const href of ['ros2wasm:', 'ros2wasm:open', 'ros2wasm:start?node=', 'ros2wasm:eval?x=1', 'ros2wasm:publish?topic=/a', `ros2wasm:start?node=${'x'.repeat(9000)}`])
    assert.equal(readPageAction(href), null, href.slice(0, 40));
  assert.equal(isPageAction('https://a.example/ros2wasm:start?node=a'), false);
  const odd = readPageAction('ros2wasm:open?panel=plot&__proto__=1');
  assert.deepEqual(odd, { kind: 'open', panel: 'plot', state: null });
});
