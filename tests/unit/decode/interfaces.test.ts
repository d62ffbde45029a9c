// Every interface that ros2wasm ships can be gathered and read by the page's decoder.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createDecoder } from '../../../runtime/site/decode/decoder.ts';

const ROOT = fileURLToPath(new URL('../../../runtime/packages/interfaces', import.meta.url));
const PARTS: Readonly<Record<string, readonly string[]>> = {
  msg: [''],
  srv: ['_Request', '_Response'],
  action: ['_Goal', '_Result', '_Feedback', '_FeedbackMessage'],
};

function shippedInterfaces(): Map<string, string> {
  const found = new Map<string, string>();
  for (const name of readdirSync(ROOT)) {
    for (const kind of Object.keys(PARTS)) {
      const folder = `${ROOT}/${name}/${kind}`;
      for (const file of existsSync(folder) ? readdirSync(folder) : []) {
        found.set(
          `${name}/${kind}/${file.replace(/\.\w+$/, '')}`,
          readFileSync(`${folder}/${file}`, 'utf8'),
        );
      }
    }
  }
  return found;
}

test('all shipped definitions are understood', () => {
  const interfaces = shippedInterfaces();
  const decoder = createDecoder(interfaces);
  // A kilobyte of zeros holds every message: empty texts and arrays, zero numbers.
  const zeros = new Uint8Array(4096);
  zeros[1] = 1;
  let count = 0;
  for (const type of interfaces.keys()) {
    for (const part of PARTS[type.split('/')[1] ?? ''] ?? []) {
      const decoded = decoder.decode(type + part, zeros);
      if (/^(example_interfaces\/msg\/WString|test_msgs\/msg\/WStrings)$/.test(type)) {
        assert.match(decoded.kind === 'failed' ? decoded.reason : '', /wstring/);
      } else {
        assert.equal(
          decoded.kind,
          'value',
          `${type}${part}: ${decoded.kind === 'failed' ? decoded.reason : ''}`,
        );
      }
      count += 1;
    }
  }
  assert.ok(count > 232, String(count));
});
