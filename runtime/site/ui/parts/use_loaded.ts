// Code that comes when it is first wanted.

import { useEffect, useState } from 'preact/hooks';

/** null until it is there. A failure reaches the boundary around the panel. */
export function useLoaded<T>(wanted: boolean, load: () => Promise<T>): T | null {
  const [loaded, setLoaded] = useState<{ readonly code: T; } | null>(null);
  const [failure, setFailure] = useState<unknown>(null);
  const missing = wanted && loaded === null;
  useEffect(() => {
    if (!missing) return undefined;
    let current = true;
    load().then(
      (code) => {
        if (current) setLoaded({ code });
      },
      (error: unknown) => {
        if (current) setFailure(error ?? new Error('not loaded'));
      },
    );
    return () => {
      current = false;
    };
  }, [missing]);
  if (failure !== null) throw failure;
  return loaded?.code ?? null;
}
