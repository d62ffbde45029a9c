// Work of a panel that is only worth it while the panel is in sight.

import { useContext, useEffect, useRef } from 'preact/hooks';
import { PanelInSight } from './panel.tsx';

/** Calls `tick` every `periodMs` while the panel is in sight, and at once when it comes into sight. */
export function useEvery(periodMs: number, tick: () => void): void {
  const inSight = useContext(PanelInSight);
  const latest = useRef(tick);
  latest.current = tick;
  const seen = useRef(inSight);
  useEffect(() => {
    if (!inSight) {
      seen.current = false;
      return undefined;
    }
    if (!seen.current) latest.current();
    seen.current = true;
    const timer = setInterval(() => latest.current(), periodMs);
    return () => clearInterval(timer);
  }, [inSight, periodMs]);
}
