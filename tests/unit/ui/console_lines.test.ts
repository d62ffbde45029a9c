// Console text: escape sequences, log lines, rows, filters.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { ConsoleLine } from '../../../runtime/site/contract/session.ts';
import { parseAnsi, stripAnsi, styleClasses } from '../../../runtime/site/ui/model/ansi.ts';
import { displayLine, MAX_SHOWN, parseLogParts, rowsOf } from '../../../runtime/site/ui/model/log_line.ts';
import { afterSnapshot } from '../../../runtime/site/ui/model/line_feed.ts';
import { GrowingList } from '../../../runtime/site/ui/model/growing_list.ts';
import { LineList } from '../../../runtime/site/ui/model/line_list.ts';
import { RowMap } from '../../../runtime/site/ui/model/row_map.ts';

const line = (text: string, extra: Partial<ConsoleLine> = {}): ConsoleLine => ({
  time: 0,
  stream: 'stdout',
  text,
  ...extra,
});
const log = (level: string, message: string): ConsoleLine => line(`[${level}] [1700000000.123456789] [talker]: ${message}`);

test('plain text is one span and untouched', () => {
  assert.deepEqual(
    parseAnsi('a <b>&amp;').map((span) => span.text),
    ['a <b>&amp;'],
  );
});

test('colours and weights of SGR sequences', () => {
  const spans = parseAnsi('\x1b[33m[WARN]\x1b[0m rest \x1b[1;4;31mbad\x1b[22;24m!\x1b[39m.');
  assert.deepEqual(
    spans.map((span) => [span.text, styleClasses(span.style)]),
    [
      ['[WARN]', 'ansi-fg-3'],
      [' rest ', ''],
      ['bad', 'ansi-fg-1 ansi-bold ansi-underline'],
      ['!', 'ansi-fg-1'],
      ['.', ''],
    ],
  );
});

test('256 and true colours become the nearest of the sixteen', () => {
  const classes = (text: string): string => styleClasses(parseAnsi(text)[0]?.style ?? assert.fail());
  assert.equal(classes('\x1b[38;5;196mx'), 'ansi-fg-9');
  assert.equal(classes('\x1b[38;2;0;205;0mx'), 'ansi-fg-2');
  assert.equal(classes('\x1b[48;5;4mx'), 'ansi-bg-4');
  assert.equal(classes('\x1b[38;5mx'), '');
  assert.equal(classes('\x1b[38;2;1mx'), '');
});

test('every other sequence and control character disappears', () => {
  const hostile = [
    '\x1b[2J\x1b[H',
    '\x1b]0;title\x07',
    '\x1b]8;;javascript:alert(1)\x1b\\',
    '\x1bc',
    '\x1b(B',
    '\x9b31m',
    '\x1bPq#0\x1b\\',
    '\b\b\b',
    '\x00',
    '\x7f',
    '\x1b[?25l',
    '\x1b[999999999999999999999999A',
  ];
  for (const sequence of hostile) {
    assert.equal(stripAnsi(`a${sequence}b`), 'ab', JSON.stringify(sequence));
  }
  for (const cut of ['\x1b', '\x1b[', '\x1b[31', '\x1b]0;never ends', '\x1b(']) {
    assert.equal(stripAnsi(`a${cut}`), 'a', JSON.stringify(cut));
  }
});

test('a megabyte of escapes is parsed in linear time', () => {
  const started = process.cpuUsage();
  assert.equal(stripAnsi('\x1b[\x1b]'.repeat(250_000)).length <= 1_000_000, true);
  assert.ok(process.cpuUsage(started).user < 2_000_000, 'microseconds of the processor, not of the clock');
});

test('the default log format is taken apart and only that', () => {
  assert.deepEqual(
    parseLogParts("[INFO] [1700000000.123456789] [ns.talker]: Publishing: 'Hello'"),
    {
      level: 'INFO',
      stamp: '[1700000000.123456789]',
      logger: '[ns.talker]',
      message: "Publishing: 'Hello'",
    },
  );
  for (
    const other of [
      '[INFO] hello',
      'INFO [1.2] [a]: b',
      '[INFO] [1.2] [a] b',
      '[TRACE] [1.2] [a]: b',
      ' [INFO] [1.2] [a]: b',
    ]
  ) {
    assert.equal(parseLogParts(other), null, other);
  }
});

test('a coloured log line keeps its own colours and still has its level', () => {
  const shown = displayLine(line('\x1b[33m[WARN] [1.5] [a]: low\x1b[0m'), 7, '');
  assert.equal(shown.level, 'WARN');
  assert.equal(shown.parts, null);
  assert.equal(shown.plain, '[WARN] [1.5] [a]: low');
  assert.equal(shown.key, 7);
});

test('carriage returns, tabs and very long lines', () => {
  assert.equal(displayLine(line('10%\r50%\r100%\r'), 0, '').plain, '100%');
  assert.equal(displayLine(line('a\tb'), 0, '').plain, 'a       b');
  const long = displayLine(line('x'.repeat(MAX_SHOWN + 10)), 0, '');
  assert.ok(long.plain.endsWith('(10 more characters)'));
});

test('rows follow the width, wide characters count twice', () => {
  assert.equal(rowsOf(displayLine(line(''), 0, ''), 80), 1);
  assert.equal(rowsOf(displayLine(line('x'.repeat(80)), 0, ''), 80), 1);
  assert.equal(rowsOf(displayLine(line('x'.repeat(81)), 0, ''), 80), 2);
  assert.equal(rowsOf(displayLine(line('x'.repeat(75)), 0, '[talker-1] '), 80), 2);
  assert.equal(rowsOf(displayLine(line('日'.repeat(41)), 0, ''), 80), 2);
  // At spaces first; 10 columns, then 8 in later rows.
  const rows = (text: string): number => rowsOf(displayLine(line(text), 0, ''), 10);
  assert.equal(rows('aaaa bbbbb'), 1);
  assert.equal(rows('aaaa bbbbbb'), 2);
  assert.equal(rows('aaaaaaaaaa bbbb cccc'), 3);
  assert.equal(rows('aaaa bbbb      '), 1);
  assert.equal(rows('x'.repeat(26)), 3);
  assert.equal(rows('x'.repeat(27)), 4);
  assert.equal(rows(`aa ${'x'.repeat(16)} bb`), 4);
});

test('a row map agrees with a plain array through appends, drops and corrections', () => {
  const map = new RowMap();
  let plain: number[] = [];
  let seed = 1;
  const random = (n: number): number => {
    seed = (seed * 48271) % 2147483647;
    return seed % n;
  };
  for (let step = 0; step < 400; step += 1) {
    for (let i = random(60); i > 0; i -= 1) {
      const rows = 1 + random(4);
      map.push(rows);
      plain.push(rows);
    }
    const drop = random(40);
    const gone = plain.slice(0, drop).reduce((sum, rows) => sum + rows, 0);
    assert.equal(map.dropFirst(drop), gone);
    plain = plain.slice(drop);
    if (plain.length > 0) {
      const at = random(plain.length);
      plain[at] = 5;
      map.set(at, 5);
      const index = random(plain.length);
      const offset = plain.slice(0, index).reduce((sum, rows) => sum + rows, 0);
      assert.equal(map.offsetOf(index), offset);
      assert.equal(map.lineAt(offset), index);
      assert.equal(map.lineAt(offset + (plain[index] ?? 0) - 1), index);
    }
    assert.equal(map.length, plain.length);
    assert.equal(
      map.totalRows,
      plain.reduce((sum, rows) => sum + rows, 0),
    );
  }
});

test('a batch gathered before the snapshot is not shown twice', () => {
  const [a, b, c, d] = [line('a'), line('b'), line('c'), line('c')];
  assert.deepEqual(afterSnapshot([a, b])([a, b, c, d]), [c, d]);
  assert.deepEqual(afterSnapshot([a, b, c])([c, d]), [d]);
  assert.deepEqual(afterSnapshot([a, b])([c, d]), [c, d]);
  assert.deepEqual(afterSnapshot([])([a]), [a]);
  const feed = afterSnapshot([a]);
  assert.deepEqual(feed([a, b]), [b]);
  assert.deepEqual(feed([c]), [c]);
});

test('a line list filters by text and by level', () => {
  const list = new LineList(100);
  list.append(
    [
      log('DEBUG', 'one'),
      log('INFO', 'Two'),
      log('WARN', 'three'),
      line('plain two'),
      log('FATAL', 'four'),
    ],
    '',
  );
  list.setFilter({ text: 'two', level: null });
  assert.equal(list.text(), '[INFO] [1700000000.123456789] [talker]: Two\nplain two\n');
  list.setFilter({ text: '', level: 'WARN' });
  assert.equal(list.shownCount, 2);
  list.append([log('ERROR', 'five'), log('INFO', 'six')], '');
  assert.equal(list.shownCount, 3);
  list.setFilter({ text: '', level: null });
  assert.equal(list.shownCount, 7);
});

test('a line list stays bounded and says what fell off', () => {
  const list = new LineList(1000);
  let dropped = 0;
  for (let batch = 0; batch < 100; batch += 1) {
    list.append(
      Array.from({ length: 100 }, (_, i) => line(`line ${batch * 100 + i}`)),
      '',
    );
    dropped += list.takeFallenRows();
  }
  assert.ok(list.allCount <= 2024);
  assert.equal(list.totalRows, list.shownCount);
  assert.equal(dropped + list.totalRows, 10_000);
  assert.equal(list.window(list.totalRows - 1, list.totalRows).lines[0]?.plain, 'line 9999');
  list.clear();
  assert.equal(list.totalRows, 0);
  assert.deepEqual(list.window(0, 10).lines, []);
});

test('a hundred thousand lines are appended and windowed quickly', () => {
  const list = new LineList(100_000);
  const before = process.cpuUsage();
  for (let batch = 0; batch < 1000; batch += 1) {
    list.append(
      Array.from({ length: 100 }, (_, i) => log('INFO', `Publishing: 'Hello World: ${batch * 100 + i}'`)),
      '',
    );
    list.window(list.totalRows - 40, list.totalRows);
  }
  assert.equal(list.shownCount, 100_000);
  // The time of this process: a busy machine makes it no slower.
  assert.ok(process.cpuUsage(before).user < 5_000_000);
});

test('a list that grows at its front keeps the places of what is there', () => {
  const list = new GrowingList(100);
  list.setColumns(20);
  list.append([log('WARN', 'c'), line('d')], '');
  const rows = list.totalRows;
  list.prepend([line('a'), line('b '.repeat(15))]);
  assert.deepEqual(list.window(0, 100).lines.map(({ plain }) => plain.slice(0, 1)), ['a', 'b', '[', 'd']);
  assert.equal(list.takeFallenRows(), rows - list.totalRows);
  assert.equal(list.takeFallenRows(), 0);
  assert.equal(list.addedCount, 2, 'nothing new has come');
  list.append([line('e')], '');
  const keys = list.window(0, 100).lines.map(({ key }) => key);
  assert.deepEqual(keys, keys.toSorted((a, b) => a - b));
  assert.equal(new Set(keys).size, 5);
  list.setFilter({ text: '', level: 'WARN' });
  list.prepend([line('no'), log('ERROR', 'yes')]);
  assert.deepEqual(list.window(0, 100).lines.map(({ level }) => level), ['ERROR', 'WARN']);
});
