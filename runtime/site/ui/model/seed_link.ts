// The page's address with a seed, as `?seed=N`. Pure.

/** As launcher.ts takes it. */
export function isSeed(text: string): boolean {
  return /^\d{1,9}$/.test(text);
}

/** The page's address with another seed, or without one. */
export function seedLink(address: string, seed: string | undefined): string {
  const url = new URL(address);
  // Written as launch arguments are: their := stays.
  const words = url.search.replace(/^\?/, '').split('&').filter((word) => word !== '' && !/^seed(=|$)/.test(word));
  url.search = [...words, ...(seed === undefined ? [] : [`seed=${seed}`])].join('&');
  return url.href;
}
