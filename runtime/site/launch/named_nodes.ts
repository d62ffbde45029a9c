// What `?nodes=` of a page's address says.

import { SiteError } from '../contract/site_error.ts';

/** `all`, `none`, or ids separated by commas. Throws SiteError R2W0713 for an id that is not among `ids`. */
export function namedNodes(text: string, ids: readonly string[]): readonly string[] {
  if (text === 'all') return ids;
  if (text === 'none') return [];
  const named = text.split(',');
  const unknown = named.find((id) => !ids.includes(id));
  if (unknown === undefined) return named;
  throw new SiteError('R2W0713', `the address asks for the node \`${unknown}\`, which this site has not`, {
    why: `the nodes of this site are ${ids.join(', ')}`,
    fix: 'correct `nodes=` in the address, or leave it out to start the site as it was made',
  });
}
