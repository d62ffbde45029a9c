// Codes of errors are those that have a page in cli/explain/.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';

test('a code without a page is an error of the type checker', () => {
  assert.equal(new SiteError('R2W0706', 'no network').code, 'R2W0706');
  // @ts-expect-error: no page has this code
  assert.equal(new SiteError('R2W9999', 'no network').code, 'R2W9999');
});
