// The files that describe a site: licenses, bill of materials, citation and RO-Crate, read by their own tools.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const require = createRequire(import.meta.url);

interface Relationship {
  readonly spdxElementId: string;
  readonly relationshipType: string;
  readonly relatedSpdxElement: string;
}
interface SpdxPackage {
  readonly SPDXID: string;
  readonly name: string;
  readonly versionInfo?: string;
  readonly licenseDeclared: string;
  readonly downloadLocation: string;
  readonly externalRefs?: readonly { readonly referenceLocator: string; }[];
}
interface Spdx {
  readonly spdxVersion: string;
  readonly dataLicense: string;
  readonly documentNamespace: string;
  readonly creationInfo: { readonly created: string; readonly creators: readonly string[]; };
  readonly packages: readonly SpdxPackage[];
  readonly relationships: readonly Relationship[];
  readonly hasExtractedLicensingInfos?: readonly { readonly licenseId: string; readonly extractedText: string; }[];
}

let ws: PackWorkspace;
const read = (file: string): string => readFileSync(join(ws.root, 'packed', file), 'utf8');

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  ws.write('LICENSE', 'Do as you like, with care.\n');
  ws.write('workspace.yaml', `schema: 1
name: quick_site
title: 'Quick: "one" \\ two'
version: 2.1.0
license: MIT
authors:
  - {name: Ada de Example, orcid: 0000-0002-1825-0097, affiliation: Example University}
  - "Doe, Jo <jo@example.org>"
  - Collective
citation:
  date_released: 2026-11-23
  doi: 10.5281/zenodo.1234567
  repository: https://example.org/quick.git
  abstract: |
    A node that says hello.
    Then it ends: #1.
  keywords: [robotics, "yes", teaching]
packages: [src/*]
launch:
  - {package: quick, executable: hello}
`);
  const packed = await ws.run(['pack', '-o', 'packed']);
  assert.equal(packed.code, 0, packed.stderr);
});

after(() => ws.close());

// Guarantee, citable: CITATION.cff, as citation-js reads it
test('CITATION.cff is read with its authors, date and DOI', async () => {
  const { Cite } = require('@citation-js/core') as { Cite: new(text: string) => { data: readonly Record<string, unknown>[]; }; };
  require('@citation-js/plugin-cff');
  const cited = new Cite(read('CITATION.cff')).data[0] ?? {};
  assert.equal(cited['title'], 'Quick: "one" \\ two');
  assert.equal(cited['DOI'], '10.5281/zenodo.1234567');
  assert.equal(cited['version'], '2.1.0');
  assert.deepEqual((cited['issued'] as { 'date-parts': unknown; })['date-parts'], [[2026, 11, 23]]);
  const authors = cited['author'] as readonly Record<string, unknown>[];
  assert.deepEqual(authors.map(({ given, family, literal }) => [given, family ?? literal]), [
    ['Ada de', 'Example'],
    ['Jo', 'Doe'],
    [undefined, 'Collective'],
  ]);
  assert.match(String(cited['abstract']), /hello\.\nThen it ends: #1\./);
});

// Guarantee, citable: RO-Crate metadata (1.1), as ro-crate's validator wants it; it lists every file
test('ro-crate-metadata.json is valid and lists every file of the site', () => {
  const { ROCrate, Validator } = require('ro-crate') as {
    ROCrate: new(json: unknown, options: object) => { readonly rootDataset: Record<string, unknown>; };
    Validator: new(crate?: unknown) => { parseJSON(text: string): void; result: { errors: readonly unknown[]; }; };
  };
  const text = read('ro-crate-metadata.json');
  const crate = new ROCrate(JSON.parse(text), { array: false, link: true });
  const validator = new Validator(crate);
  validator.parseJSON(text);
  assert.deepEqual(validator.result.errors, []);
  assert.equal(crate.rootDataset['datePublished'], '2026-11-23');
  const site = JSON.parse(read('site.json')) as { readonly files: readonly { readonly path: string; }[]; };
  const parts = new Set((crate.rootDataset['hasPart'] as readonly { readonly '@id': string; }[]).map((part) => decodeURIComponent(part['@id'])));
  for (const { path } of site.files) {
    if (path !== 'ro-crate-metadata.json') assert.ok(parts.has(path), `${path} is not in the crate`);
  }
});

// Guarantee, citable: an SPDX 2.3 bill of materials of what the site is made of, with licenses that are SPDX expressions
test('sbom.spdx.json names each part with a license that SPDX has, or its own words', () => {
  const parse = require('spdx-expression-parse') as (text: string) => unknown;
  const spdx = JSON.parse(read('sbom.spdx.json')) as Spdx;
  assert.equal(spdx.spdxVersion, 'SPDX-2.3');
  assert.equal(spdx.dataLicense, 'CC0-1.0');
  assert.match(spdx.documentNamespace, /^urn:ros2wasm:site:[0-9a-f]{64}$/);
  assert.equal(spdx.creationInfo.created, '2026-11-23T00:00:00Z');
  const ids = spdx.packages.map(({ SPDXID }) => SPDXID);
  assert.equal(new Set(ids).size, ids.length);
  for (const id of ids) assert.match(id, /^SPDXRef-[A-Za-z0-9.-]+$/);
  const own = new Set((spdx.hasExtractedLicensingInfos ?? []).map(({ licenseId }) => licenseId));
  for (const { licenseDeclared } of spdx.packages) {
    if (licenseDeclared === 'NOASSERTION') continue;
    parse(licenseDeclared); // throws for what is not an expression
    for (const [reference] of licenseDeclared.matchAll(/LicenseRef-\d+/g)) assert.ok(own.has(reference), reference);
  }
  const known = new Set([...ids, 'SPDXRef-DOCUMENT']);
  for (const { spdxElementId, relatedSpdxElement } of spdx.relationships) {
    assert.ok(known.has(spdxElementId) && known.has(relatedSpdxElement), relatedSpdxElement);
  }
  const named = new Map(spdx.packages.map((one) => [one.name, one]));
  assert.equal(named.get('quick_site')?.versionInfo, '2.1.0');
  assert.equal(named.get('preact')?.licenseDeclared, 'MIT');
  assert.ok(named.has('quick') && named.has('ros2wasm'));
  assert.match(named.get('emscripten-abi')?.externalRefs?.[0]?.referenceLocator ?? '', /^pkg:conda\/emscripten-abi@3\./);
});

// Guarantee, citable: the license texts of all parts
test('LICENSES.txt has each part and each text once', () => {
  const licenses = read('LICENSES.txt');
  assert.match(licenses, /^ {2}preact \d[\d.]*: MIT$/m);
  assert.match(licenses, /Do as you like, with care\./);
  assert.equal(licenses.match(/Copyright \(c\) 2015-present Jason Miller/g)?.length, 1);
});

test('a site without `citation` has its licenses and its bill of materials, and claims no date', async () => {
  ws.write('plain.yaml', 'schema: 1\nname: plain\npackages: [src/*]\nlaunch:\n  - {package: quick, executable: hello}\n');
  const packed = await ws.run(['pack', 'plain.yaml', '-o', 'plain']);
  assert.equal(packed.code, 0, packed.stderr);
  const files = [...ws.files('plain').keys()];
  assert.deepEqual(files.filter((file) => /^(CITATION|LICENSES|ro-crate|sbom)/.test(file)), ['LICENSES.txt', 'sbom.spdx.json']);
  const spdx = JSON.parse(ws.read('plain/sbom.spdx.json').toString()) as Spdx;
  assert.equal(spdx.creationInfo.created, '1970-01-01T00:00:00Z');
});
