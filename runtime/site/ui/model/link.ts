// The fields of a link to a view, after its "#": `site=HASH&layout=JSON`, and where they differ from the defaults,
// `params=JSON` and `autorun=0`. The hash is the beginning of the sha256 of site.json, which contains the hashes of all
// files of the site: so a link made for another site can be recognised. Fields of others stay as they are.

import { fetchOfSite } from '../../program/carried_files.ts';

const HASH_LENGTH = 16;
const MOST_FRAGMENT = 131_072;

/** The fields of a fragment, with or without its "#". Never throws; an overlong one has none. */
export function readFragment(fragment: string): URLSearchParams {
  const text = fragment.replace(/^#/, '');
  return new URLSearchParams(text.length > MOST_FRAGMENT ? '' : text);
}

/** The fragment with these fields set, or removed where null; empty when none is left. */
export function changedFragment(
  fragment: string,
  fields: Readonly<Record<string, string | null>>,
): string {
  const params = readFragment(fragment);
  for (const [name, value] of Object.entries(fields)) {
    if (value === null) params.delete(name);
    else params.set(name, value);
  }
  const text = params.toString();
  return text === '' ? '' : `#${text}`;
}

/** As links carry it. */
export async function siteHash(): Promise<string | null> {
  return (await siteDigest())?.slice(0, HASH_LENGTH) ?? null;
}

/** sha256 of the site; null where site.json does not come. */
export async function siteDigest(): Promise<string | null> {
  try {
    const response = await fetchOfSite('site.json');
    if (!response.ok) return null;
    const bytes = new Uint8Array(await response.arrayBuffer());
    // The browser has digests of its own on https:// and localhost only.
    if ((crypto.subtle as SubtleCrypto | undefined) === undefined) {
      const { RunningSha256 } = await import('../../contract/running_sha256.ts');
      const sum = new RunningSha256();
      sum.add(bytes);
      return sum.hex();
    }
    const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
    return Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join('');
  } catch {
    return null;
  }
}

/** Whether nodes start by themselves, for a link: null where they do what the manifest says. */
export function autorunField(running: boolean, usual: boolean): string | null {
  return running === usual ? null : running ? '1' : '0';
}
