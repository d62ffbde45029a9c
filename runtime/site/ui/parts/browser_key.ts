// The Ed25519 key with which this browser signs the files that students hand in. It is made once for an origin and cannot
// leave the browser. Where the browser stores nothing, each visit makes a new one.

import { openDatabase } from './browser_database.ts';

const DATABASE = 'ros2wasm-keys';
const STORE = 'keys';
const NAME = 'progress';
const ALGORITHM = 'Ed25519';

export interface BrowserKey {
  /** 32 bytes. */
  readonly publicKey: Uint8Array<ArrayBuffer>;
  /** 64 bytes. */
  readonly sign: (bytes: Uint8Array<ArrayBuffer>) => Promise<Uint8Array<ArrayBuffer>>;
  /** The next visit has it too. */
  readonly kept: boolean;
}

/** "insecure": browsers sign on https:// and localhost only. "unsupported": this one cannot, as it is too old. */
export type NoKey = 'insecure' | 'unsupported';

export async function browserKey(): Promise<BrowserKey | NoKey> {
  const subtle = globalThis.crypto.subtle as SubtleCrypto | undefined;
  if (subtle === undefined) return 'insecure';
  const known = await keptPair();
  if (known !== null) return keyOf(subtle, known, true);
  let made: CryptoKeyPair;
  try {
    const pair = await subtle.generateKey(ALGORITHM, false, ['sign', 'verify']);
    if (!('privateKey' in pair)) return 'unsupported';
    made = pair;
  } catch {
    return 'unsupported';
  }
  // Another tab may have made one meanwhile: the first one stays.
  const first = await keepPair(made);
  return keyOf(subtle, first ?? made, first !== null);
}

async function keyOf(subtle: SubtleCrypto, pair: CryptoKeyPair, kept: boolean): Promise<BrowserKey> {
  return {
    publicKey: new Uint8Array(await subtle.exportKey('raw', pair.publicKey)),
    sign: async (bytes) => new Uint8Array(await subtle.sign(ALGORITHM, pair.privateKey, bytes)),
    kept,
  };
}

/** Other pages of the origin may have put anything there. */
function isPair(value: unknown): value is CryptoKeyPair {
  if (typeof value !== 'object' || value === null) return false;
  const { privateKey, publicKey } = value as Readonly<Record<string, unknown>>;
  const fits = (key: unknown, usage: KeyUsage): boolean => key instanceof CryptoKey && key.algorithm.name === ALGORITHM && key.usages.includes(usage);
  return fits(privateKey, 'sign') && fits(publicKey, 'verify') && !(privateKey as CryptoKey).extractable;
}

/** null: none is kept, or the browser does not say. */
async function keptPair(): Promise<CryptoKeyPair | null> {
  return inStore('readonly', () => undefined);
}

/** The pair that is stored afterwards: this one, or one that was there already. null: the browser stores nothing. */
async function keepPair(pair: CryptoKeyPair): Promise<CryptoKeyPair | null> {
  return inStore('readwrite', (store) => void store.put(pair, NAME)).then((before) => before ?? keptPair());
}

/** Gives the pair that is there; `otherwise` runs in the same transaction when there is none. */
async function inStore(mode: IDBTransactionMode, otherwise: (store: IDBObjectStore) => void): Promise<CryptoKeyPair | null> {
  let database: IDBDatabase;
  try {
    database = await openDatabase(DATABASE, STORE);
  } catch {
    return null;
  }
  try {
    return await new Promise<CryptoKeyPair | null>((resolve) => {
      const transaction = database.transaction(STORE, mode);
      const store = transaction.objectStore(STORE);
      let found: CryptoKeyPair | null = null;
      const request = store.get(NAME) as IDBRequest<unknown>;
      request.onsuccess = () => {
        if (isPair(request.result)) found = request.result;
        else otherwise(store);
      };
      transaction.oncomplete = () => resolve(found);
      transaction.onabort = () => resolve(null);
    });
  } catch {
    return null;
  } finally {
    database.close();
  }
}
