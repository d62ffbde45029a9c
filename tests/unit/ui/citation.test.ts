// The BibTeX entry of the page.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { bibtex } from '../../../runtime/site/ui/model/citation.ts';
import { FakeSession } from './fake_session.ts';

const require = createRequire(import.meta.url);
const { Cite } = require('@citation-js/core') as { Cite: new(text: string) => { data: readonly Record<string, unknown>[]; }; };
require('@citation-js/plugin-bibtex');

const site = {
  ...new FakeSession({ nodes: [] }).site,
  name: 'quick_site',
  title: 'Rovers & {robots}: 100% #1 of a_b \\ c ~ $5 ^2',
  authors: [
    { name: 'Doe, Jo', family: 'Doe', given: 'Jo' },
    { name: 'Bread and Butter', family: 'Bread and Butter', given: '' },
  ],
  citation: { date: '2026-02-03', doi: '10.5281/zenodo.1_2' },
};

// Guarantee, citable: the page's "Cite this site": a BibTeX entry, as citation-js reads it
test('an entry is read back with its authors, title and date, whatever characters they have', () => {
  const entry = bibtex(site, 'ab'.repeat(32), 'https://example.org/site/');
  const cited = new Cite(entry ?? '').data[0] ?? {};
  assert.equal(String(cited['title']).replace(/<[^>]*>/g, ''), site.title);
  assert.deepEqual(cited['author'], [{ given: 'Jo', family: 'Doe' }, { family: 'Bread and Butter' }]);
  assert.deepEqual((cited['issued'] as { 'date-parts': unknown; })['date-parts'], [[2026, 2]]);
  assert.equal(cited['DOI'], '10.5281/zenodo.1_2');
  assert.match(String(cited['note']), /^sha256 of site\.json: (ab){32}$/);
});

test('without a DOI the address of the page stands there; without `citation` there is none', () => {
  const { citation: _, ...plain } = site;
  assert.equal(bibtex(plain, null, ''), null);
  const entry = bibtex({ ...site, citation: { date: '2026-02-03', doi: '' } }, null, 'https://example.org/site/') ?? '';
  assert.match(entry, /^ {2}url = \{https:\/\/example\.org\/site\/\},?$/m);
  assert.doesNotMatch(entry, /note|doi/);
});

test('a local address is never cited', () => {
  for (const address of ['file:///home/me/paper.html', 'http://localhost:8080/', 'http://127.0.0.1:9000/site/', 'http://[::1]/', 'http://lab.localhost/'])
    assert.doesNotMatch(bibtex({ ...site, citation: { date: '2026-02-03', doi: '' } }, null, address) ?? assert.fail(), /url/);
});
