// A link names the site that it was made for (`#site=`, runtime/site/ui/model/link.ts). Where a site was packed into a store
// again, what it was before lies beside it: such a link opens that one.

import { sha256Of } from './expected_files.ts';

/** As many digits of the sha256 as folders of earlier packs have in their names (bundler/emit/stored_folder.cpp). */
const digits = 16;

async function hashOf(base: URL): Promise<string | undefined> {
  try {
    const response = await fetch(new URL('site.json', base));
    return response.ok ? (await sha256Of(await response.arrayBuffer())).slice(0, digits) : undefined;
  } catch {
    return undefined;
  }
}

/** undefined: it is this one that is asked for, or that one is not kept. */
export async function earlierPack(base: URL, fragment: string): Promise<URL | undefined> {
  const asked = new URLSearchParams(fragment.replace(/^#/, '')).get('site')?.slice(0, digits) ?? '';
  const name = base.pathname.split('/').at(-2)?.replace(/@[0-9a-f]{16}$/, '') ?? '';
  if (!/^[0-9a-f]{16}$/.test(asked) || name === '' || await hashOf(base) === asked) return undefined;
  // The one that is newest has no hash in its name.
  for (const folder of [`../${name}@${asked}/`, `../${name}/`]) {
    const place = new URL(folder, base);
    if (place.href !== base.href && await hashOf(place) === asked) return place;
  }
  return undefined;
}
