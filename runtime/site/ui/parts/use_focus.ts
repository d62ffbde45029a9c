import { useCallback, useLayoutEffect, useState } from 'preact/hooks';

/**
 * Gives the focus to the element of an id as soon as the next render is in the document. It comes before the visitor's next key:
 * a focus that is given a frame later takes it away from what a fast hand has opened meanwhile.
 */
export function useFocus(): (id: string) => void {
  // An object, so that the same id can be wished for twice.
  const [wish, setWish] = useState<{ readonly id: string; } | null>(null);
  useLayoutEffect(() => {
    if (wish !== null) document.getElementById(wish.id)?.focus();
  }, [wish]);
  return useCallback((id) => setWish({ id }), []);
}
