import assert from 'node:assert/strict';
import { test } from 'node:test';
import { namedNodes } from '../../../runtime/site/launch/named_nodes.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';

const ids = ['talker-1', 'listener-2'];

test('an address names all nodes, none, or some', () => {
  assert.deepEqual(namedNodes('all', ids), ids);
  assert.deepEqual(namedNodes('none', ids), []);
  assert.deepEqual(namedNodes('listener-2', ids), ['listener-2']);
  assert.deepEqual(namedNodes('listener-2,talker-1', ids), ['listener-2', 'talker-1']);
});

test('R2W0713: a node that the site has not', () => {
  for (const text of ['talker', 'talker-1,', '', 'talker-1,all']) {
    assert.throws(
      () => namedNodes(text, ids),
      (error) => error instanceof SiteError && error.code === 'R2W0713' && String(error.why).includes('talker-1, listener-2'),
    );
  }
});
