// Lets go of what is held when its end may not be told: the window loses the focus, or the page is not looked at.

import { useEffect, useRef } from 'preact/hooks';

export function useLetGo(release: () => void): void {
  const newest = useRef(release);
  newest.current = release;
  useEffect(() => {
    const leave = (): void => newest.current();
    window.addEventListener('blur', leave);
    document.addEventListener('visibilitychange', leave);
    return () => {
      window.removeEventListener('blur', leave);
      document.removeEventListener('visibilitychange', leave);
    };
  }, []);
}
