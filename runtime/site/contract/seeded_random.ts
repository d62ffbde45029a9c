// Random numbers that are the same in every run of a seed. Not for secrets.

/** 32 bits that depend on every character (FNV-1a). */
function hashText(text: string): number {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return hash;
}

/** Fills bytes with what comes next for this seed and name. */
export function seededRandom(seed: number, name: string): (bytes: Uint8Array) => void {
  let state = hashText(`${seed} ${name}`);
  // SplitMix32.
  const next = (): number => {
    state = (state + 0x9e3779b9) | 0;
    let mixed = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    mixed = Math.imul(mixed ^ (mixed >>> 15), 0x735a2d97);
    return mixed ^ (mixed >>> 15);
  };
  return (bytes) => {
    let word = 0;
    for (let i = 0; i < bytes.length; i += 1) {
      if (i % 4 === 0) word = next();
      bytes[i] = word >>> (8 * (i % 4));
    }
  };
}
