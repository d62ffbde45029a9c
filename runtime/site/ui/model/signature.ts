// What a signature beside a site says of itself (site.json.minisig, in minisign's format). Pure. Nothing of it is checked
// here: a page that somebody changed could say what it likes, so `ros2wasm verify --key` or minisign is asked, elsewhere.

export interface ClaimedSignature {
  /** As minisign writes it: hex, without zeros before it. */
  readonly keyId: string;
  readonly comment: string;
}

const kMostLetters = 16_384;

/** Null for what is no such signature. */
export function claimedSignature(text: string): ClaimedSignature | null {
  if (text.length > kMostLetters) return null;
  const [untrusted = '', first = '', trusted = ''] = text.split(/\r?\n/);
  const comment = /^trusted comment: ([^\p{Cc}]*)$/u.exec(trusted)?.[1];
  if (!untrusted.startsWith('untrusted comment: ') || comment === undefined || !/^[A-Za-z0-9+/]{99}=$/.test(first)) return null;
  const bytes = Uint8Array.from(atob(first), (letter) => letter.charCodeAt(0));
  if (bytes.length !== 74 || bytes[0] !== 0x45 || bytes[1] !== 0x44) return null;
  return { keyId: new DataView(bytes.buffer).getBigUint64(2, true).toString(16).toUpperCase(), comment };
}
