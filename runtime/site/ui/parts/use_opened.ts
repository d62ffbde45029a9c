// Which rows of a list are open, by name.

import { useState } from 'preact/hooks';

export function useOpened(): readonly [ReadonlySet<string>, (name: string) => void] {
  const [opened, setOpened] = useState<ReadonlySet<string>>(new Set());
  const toggle = (name: string): void => {
    const next = new Set(opened);
    if (!next.delete(name)) next.add(name);
    setOpened(next);
  };
  return [opened, toggle];
}
