// The visitor's choices about the page (theme, layout, views), stored by the browser if it allows that.
// A browser that refuses storage only forgets; nothing else depends on it.

export type Theme = 'system' | 'light' | 'dark';

const THEMES: readonly Theme[] = ['system', 'light', 'dark'];

export interface Store {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

const PREFIX = 'ros2wasm.';

/** The browser's storage, or null where it is refused (private windows, sandboxed frames). */
export function browserStore(): Store | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null;
  }
}

export function readPreference<T extends string>(
  store: Store | null,
  name: string,
  allowed: readonly T[],
  fallback: T,
): T {
  const value = read(store, name);
  return allowed.find((choice) => choice === value) ?? fallback;
}

/** The visitor's theme; else the one the author chose (`ui: theme:` in the manifest); else the system's. */
export function readTheme(store: Store | null, chosenByAuthor: unknown): Theme {
  const fallback = THEMES.find((theme) => theme === chosenByAuthor) ?? 'system';
  return readPreference(store, 'theme', THEMES, fallback);
}

/** The text that was stored under that name, unchecked. */
export function readText(store: Store | null, name: string): string | null {
  return read(store, name);
}

export function writePreference(store: Store | null, name: string, value: string): void {
  try {
    store?.setItem(PREFIX + name, value);
  } catch {
    // Full or refused: the choice holds until the page is closed.
  }
}

function read(store: Store | null, name: string): string | null {
  try {
    return store?.getItem(PREFIX + name) ?? null;
  } catch {
    return null;
  }
}
