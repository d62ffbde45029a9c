// Small texts that a browser keeps for later visits, by a key. Where it keeps none (private windows, frames of others),
// they last as long as the page.

export interface KeptTexts {
  readonly get: (key: string) => string | undefined;
  /** undefined: removes it. False: it is gone when the page is. */
  readonly set: (key: string, text: string | undefined) => boolean;
  /** Called when another tab has changed some. */
  readonly onChange: (listener: () => void) => () => void;
}

/** In the browser's local storage, below that prefix. No function of it throws. */
export function keptTexts(prefix: string): KeptTexts {
  // Texts that the browser refused to store; undefined: the key was removed.
  const own = new Map<string, string | undefined>();
  return {
    get: (key) => {
      if (own.has(key)) return own.get(key);
      try {
        return localStorage.getItem(prefix + key) ?? undefined;
      } catch {
        return undefined;
      }
    },
    set: (key, text) => {
      try {
        if (text === undefined) localStorage.removeItem(prefix + key);
        else localStorage.setItem(prefix + key, text);
        own.delete(key);
        return true;
      } catch {
        own.set(key, text);
        return false;
      }
    },
    onChange: (listener) => {
      const heard = ({ key }: StorageEvent): void => {
        if (key === null || key.startsWith(prefix)) listener();
      };
      addEventListener('storage', heard);
      return () => removeEventListener('storage', heard);
    },
  };
}
