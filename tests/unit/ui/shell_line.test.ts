import assert from 'node:assert/strict';
import { test } from 'node:test';
import { desktopPanel, needless } from '../../../runtime/site/ui/model/desktop_programs.ts';
import { shellSteps } from '../../../runtime/site/ui/model/shell_line.ts';
import { readGrep } from '../../../runtime/site/ui/shell/grep.ts';

test('a line is a sequence of commands with filters and a file; quotes hide what joins them', () => {
  assert.deepEqual(shellSteps('a 1 && b | grep x | grep -v "y | z" > f; c || d \\; # ; e'), [
    { when: 'always', words: ['a', '1'], filters: [] },
    { when: 'succeeded', words: ['b'], filters: [['grep', 'x'], ['grep', '-v', 'y | z']], target: 'f' },
    { when: 'always', words: ['c'], filters: [] },
    { when: 'failed', words: ['d', ';'], filters: [] },
  ]);
  assert.deepEqual(shellSteps('ros2 topic pub /t T \'{a: "b && c"}\' -1;'), [{
    when: 'always',
    words: ['ros2', 'topic', 'pub', '/t', 'T', '{a: "b && c"}', '-1'],
    filters: [],
  }]);
  assert.deepEqual(shellSteps('ros2 param dump /x >x.yaml')?.[0]?.target, 'x.yaml');
  assert.deepEqual(shellSteps('a#b')?.[0]?.words, ['a#b']);
  assert.deepEqual(shellSteps('  '), []);
  // Something is missing: it is told when it would run.
  assert.deepEqual(shellSteps('a &&')?.[1], { when: 'succeeded', words: [], filters: [] });
  assert.equal(shellSteps('a && b "c'), undefined);
  assert.deepEqual(shellSteps('a >> f; b 2>&1 >f; c 2>/dev/null | grep x; d &'), [
    { when: 'always', words: ['a'], filters: [], target: 'f', append: true },
    { when: 'always', words: ['b'], filters: [], target: 'f' },
    { when: 'always', words: ['c'], filters: [['grep', 'x']] },
    { when: 'always', words: ['d'], filters: [], background: true },
  ]);
  assert.deepEqual(shellSteps('a $X "$X" \'$X\' ${X}y', () => 'v w')?.[0]?.words, ['a', 'v w', 'v w', '$X', 'v wy']);
});

test('grep keeps lines by basic and extended expressions, and says what it does not know', () => {
  const kept = (...words: string[]): string[] | string => {
    const filter = readGrep(words);
    return typeof filter === 'string' ? filter : ['a+b', 'aab', 'AAB', 'a.b x'].filter(filter.passes);
  };
  assert.deepEqual(kept('a+b'), ['a+b']);
  assert.deepEqual(kept('a\\+b'), ['aab']);
  assert.deepEqual(kept('-E', 'a+b'), ['aab']);
  assert.deepEqual(kept('-iE', '^a+b'), ['aab', 'AAB']);
  assert.deepEqual(kept('-F', 'a.b'), ['a.b x']);
  assert.deepEqual(kept('-v', '-e', 'a.b'), ['AAB']);
  assert.deepEqual(kept('-w', 'x'), ['a.b x']);
  assert.match(String(kept('-o', 'a')), /-o is not known/);
  const files = readGrep(['a', 'file']);
  assert.ok(typeof files !== 'string' && files.files[0] === 'file');
  assert.match(String(kept('-E', '(')), /not a regular expression/);
  assert.match(String(kept()), /usage/);
});

test('programs with windows are panels, unless the site has a package of that name', () => {
  assert.equal(desktopPanel(['rqt_graph'], [])?.panel, 'graph');
  assert.deepEqual(desktopPanel(['ros2', 'run', 'rqt_plot', 'rqt_plot', '/a/b'], []), { program: 'rqt_plot', panel: 'plot', rest: ['/a/b'] });
  assert.equal(desktopPanel(['ros2', 'run', 'rqt_plot', 'rqt_plot'], ['rqt_plot']), undefined);
  assert.equal(desktopPanel(['ros2', 'topic', 'list'], []), undefined);
  assert.equal(desktopPanel(['ros2', 'run', 'tf2_tools', 'view_frames'], [])?.panel, 'frames');
  assert.deepEqual(['source', 'colcon', 'chmod', 'ls'].map(needless), ['source', 'build', 'mode', undefined]);
});
