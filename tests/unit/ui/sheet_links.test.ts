// Links that act in the lab sheets of examples and templates are such that the page knows, with panels that there are.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { readPageAction } from '../../../runtime/site/ui/model/page_action.ts';
import { texts } from '../../../runtime/site/ui/texts.ts';

const ROOT = join(import.meta.dirname, '../../..');

test('every link of a lab sheet that acts is one that the page knows', () => {
  let count = 0;
  for (const folder of ['examples', 'templates/workspaces']) {
    for (const name of readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' }).filter((one) => one.endsWith('.md'))) {
      for (const [, href = ''] of readFileSync(join(ROOT, folder, name), 'utf8').matchAll(/\]\(<?(ros2wasm:[^>)\s]*)/g)) {
        count += 1;
        const action = readPageAction(href);
        assert.ok(action !== null, `${folder}/${name}: ${href}`);
        if (action.kind === 'open') assert.ok(Object.hasOwn(texts.panels, action.panel), `${folder}/${name}: ${action.panel}`);
      }
    }
  }
  assert.ok(count > 10, String(count));
});
