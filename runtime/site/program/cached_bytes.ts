// Bytes that a browser stores for later visits; the key says which inputs they were made from. They may be gone at any time.
// Only their maker knows what they must be, so their hash is stored where only pages can write, and no worker of a node.

import { sha256Of } from './expected_files.ts';
import type { KeptTexts } from '../contract/stored_texts.ts';

export interface KeptBytes {
  /** Only what has the hash that it was stored with; anything else is dropped. */
  readonly get: (key: string) => Promise<Blob | undefined>;
  readonly put: (key: string, bytes: Blob) => Promise<void>;
  readonly drop: (key: string) => Promise<void>;
}

const cacheName = 'ros2wasm-kept';
/** Upper bound of the entries of all sites of an origin; the oldest are removed first. */
const most = 4;

/** In the browser's Cache Storage, which pages of some kinds have not. No function of it throws. `hashes`: by address. */
export function keptBytes(base: URL, hashes: KeptTexts): KeptBytes {
  const address = (key: string): string => new URL(`kept/${key}`, base).href;
  const withCache = async <T>(use: (cache: Cache) => Promise<T>): Promise<T | undefined> => {
    try {
      return await use(await caches.open(cacheName));
    } catch {
      // No such storage, none for this page, or no room.
      return undefined;
    }
  };
  const dropFrom = async (cache: Cache, own: string): Promise<void> => {
    hashes.set(own, undefined);
    await cache.delete(own);
  };
  return {
    get: (key) =>
      withCache(async (cache) => {
        const own = address(key);
        const found = await (await cache.match(own))?.blob();
        if (found === undefined) return undefined;
        const hash = hashes.get(own);
        // A copy in memory: what is hashed is what is used, whatever becomes of the cache.
        const bytes = hash === undefined ? undefined : await found.arrayBuffer();
        if (bytes !== undefined && await sha256Of(bytes) === hash) return new Blob([bytes]);
        await dropFrom(cache, own);
        return undefined;
      }),
    put: async (key, blob) => {
      await withCache(async (cache) => {
        const own = address(key);
        const bytes = await blob.arrayBuffer();
        const others = (await cache.keys()).map(({ url }) => url).filter((url) => url !== own);
        for (const url of others.slice(0, Math.max(0, others.length - most + 1))) await dropFrom(cache, url);
        // First the bytes: without their hash they are none.
        await cache.put(own, new Response(bytes));
        if (!hashes.set(own, await sha256Of(bytes))) await dropFrom(cache, own);
      });
    },
    drop: async (key) => {
      await withCache((cache) => dropFrom(cache, address(key)));
    },
  };
}
