// How the site is cited, as a BibTeX entry. Pure.

import type { SiteDescription } from '../../contract/session.ts';

const months = ['jan', 'feb', 'mar', 'apr', 'may', 'jun', 'jul', 'aug', 'sep', 'oct', 'nov', 'dec'];

const special: Readonly<Record<string, string>> = {
  '\\': '\\textbackslash{}',
  '{': '\\{',
  '}': '\\}',
  '%': '\\%',
  '&': '\\&',
  '#': '\\#',
  _: '\\_',
  $: '\\$',
  '~': '\\textasciitilde{}',
  '^': '\\textasciicircum{}',
};

function inBibtex(words: string): string {
  return words.replace(/[\\{}%&#_$~^]/g, (char) => special[char] ?? char).replace(/\s+/g, ' ').trim();
}

/** A file, or a server of the reader's own machine, is nothing that others can open. */
function isPublic(address: string): boolean {
  const { protocol, hostname } = new URL(address);
  return (protocol === 'https:' || protocol === 'http:') && !/^(localhost|127\..*|\[::1\])$|\.localhost$/.test(hostname);
}

/** Null for a site whose manifest has no `citation`. `hash`: the sha256 of site.json, null while unknown. */
export function bibtex(site: SiteDescription, hash: string | null, address: string): string | null {
  const { citation } = site;
  if (citation === undefined) return null;
  const [year = '', month = ''] = citation.date.split('-');
  const people = site.authors.map(({ family, given }) => given === '' ? `{${inBibtex(family)}}` : `${inBibtex(family)}, ${inBibtex(given)}`);
  const fields: readonly (readonly [string, string])[] = [
    ['author', people.join(' and ')],
    ['title', `{${inBibtex(site.title === '' ? site.name : site.title)}}`],
    ['version', inBibtex(site.version)],
    ['year', year],
    ['month', months[Number(month) - 1] ?? ''],
    ['doi', citation.doi],
    // A DOI is an address by itself.
    ['url', citation.doi === '' && isPublic(address) ? address : ''],
    ['note', hash === null ? '' : `sha256 of site.json: ${hash}`],
  ];
  const written = fields.filter(([, value]) => value !== '')
    .map(([name, value]) => `  ${name} = ${name === 'month' ? value : `{${value}}`}`);
  return `@software{${site.name.replace(/[^A-Za-z0-9_.-]/g, '')}_${year},\n${written.join(',\n')}\n}\n`;
}
