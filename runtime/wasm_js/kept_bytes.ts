// What a browser keeps for later visits, by a key that says what it was made of. It may be gone at any time.

export interface KeptBytes {
  readonly get: (key: string) => Promise<Blob | undefined>;
  readonly put: (key: string, bytes: Blob) => Promise<void>;
  readonly drop: (key: string) => Promise<void>;
}

const cacheName = 'ros2wasm-kept';
/** Of all sites of an origin; the oldest go first. */
const most = 4;

/** In the browser's Cache Storage, which pages of some kinds have not. No function of it throws. */
export function keptBytes(base: URL): KeptBytes {
  const address = (key: string): string => new URL(`kept/${key}`, base).href;
  const withCache = async <T>(use: (cache: Cache) => Promise<T>): Promise<T | undefined> => {
    try {
      return await use(await caches.open(cacheName));
    } catch {
      // No such storage, none for this page, or no room.
      return undefined;
    }
  };
  return {
    get: (key) => withCache(async (cache) => {
      const found = await cache.match(address(key));
      return found?.blob();
    }),
    put: async (key, bytes) => {
      await withCache(async (cache) => {
        const own = address(key);
        const others = (await cache.keys()).map(({ url }) => url).filter((url) => url !== own);
        for (const url of others.slice(0, Math.max(0, others.length - most + 1))) await cache.delete(url);
        await cache.put(own, new Response(bytes));
      });
    },
    drop: async (key) => {
      await withCache((cache) => cache.delete(address(key)));
    },
  };
}
