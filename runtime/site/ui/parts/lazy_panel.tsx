// Shows a panel: at once when it is part of the first view, else when its code has come.

import { useEffect, useState } from 'preact/hooks';
import type { PanelComponent, PanelProps, PanelRow } from '../panels/panel_props.ts';
import { texts } from '../texts.ts';
import { panelStyles } from './panel_styles.ts';

export function LazyPanel({ row, panel }: { readonly row: PanelRow; readonly panel: PanelProps; }) {
  const [Loaded, setLoaded] = useState<PanelComponent | null>(() => row.source.kind === 'ready' ? row.source.component : null);
  const [failure, setFailure] = useState<unknown>(null);
  useEffect(() => {
    if (row.source.kind === 'lazy' && Loaded === null) {
      Promise.all([row.source.load(), row.source.plain === true ? undefined : panelStyles()]).then(
        ([component]) => setLoaded(() => component),
        (error: unknown) => setFailure(error ?? new Error('not loaded')),
      );
    }
  }, [row]);
  // The boundary around every panel shows it.
  if (failure !== null) throw failure;
  return Loaded === null ? <p class="hint">{texts.starting}</p> : <Loaded {...panel} />;
}
