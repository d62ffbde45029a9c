// The claims of a signature beside a site (site.json.minisig, in minisign's format). Pure. Nothing is verified
// here: a page that somebody changed could show anything, so the visitor runs `ros2wasm verify --key` or minisign elsewhere.

export interface ClaimedSignature {
  /** As minisign writes it: hex, without zeros before it. */
  readonly keyId: string;
  readonly comment: string;
}

const MOST_LETTERS = 16_384;

/** Null for what is no such signature. */
export function claimedSignature(text: string): ClaimedSignature | null {
  if (text.length > MOST_LETTERS) return null;
  const [untrusted = '', first = '', trusted = ''] = text.split(/\r?\n/);
  const comment = /^trusted comment: ([^\p{Cc}]*)$/u.exec(trusted)?.[1];
  if (!untrusted.startsWith('untrusted comment: ') || comment === undefined || !/^[A-Za-z0-9+/]{99}=$/.test(first)) return null;
  const bytes = Uint8Array.from(atob(first), (letter) => letter.charCodeAt(0));
  if (bytes.length !== 74 || bytes[0] !== 0x45 || bytes[1] !== 0x44) return null;
  return { keyId: new DataView(bytes.buffer).getBigUint64(2, true).toString(16).toUpperCase(), comment };
}
