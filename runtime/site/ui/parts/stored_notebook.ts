// Keeps changed notebooks in the browser: one text for each place and packed notebook. A browser that refuses only forgets.

import { openDatabase } from './browser_database.ts';

const DATABASE = 'ros2wasm';
const STORE = 'notebooks';

async function inStore<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const database = await openDatabase(DATABASE, STORE);
  try {
    return await new Promise<T>((resolve, reject) => {
      const transaction = database.transaction(STORE, mode);
      const request = work(transaction.objectStore(STORE));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = () => reject(transaction.error ?? new Error('IndexedDB'));
    });
  } finally {
    database.close();
  }
}

/** null: none is kept, or the browser does not say. */
export async function keptNotebook(key: string): Promise<string | null> {
  const found: unknown = await inStore('readonly', (store) => store.get(key) as IDBRequest<unknown>).catch(() => null);
  return typeof found === 'string' ? found : null;
}

/** Whether the browser keeps it. */
export function keepNotebook(key: string, text: string): Promise<boolean> {
  return inStore('readwrite', (store) => store.put(text, key)).then(() => true, () => false);
}

export async function forgetNotebook(key: string): Promise<void> {
  await inStore('readwrite', (store) => store.delete(key)).catch(() => undefined);
}
