// Looks for a text in all sources of the site, as they stand here, and leads to the lines that have it.

import { useEffect, useMemo, useState } from 'preact/hooks';
import type { Sources, SourceView } from '../../contract/session.ts';
import { problemOf } from '../model/problem.ts';
import { searchSources } from '../model/source_search.ts';
import { sourceTexts } from '../texts_source.ts';
import { Name } from './name.tsx';

export interface SourceSearchProps {
  readonly sources: Sources;
  readonly list: readonly SourceView[];
  readonly wanted: string;
  readonly onHit: (file: string, line: number) => void;
}

export function SourceSearch({ sources, list, wanted, onHit }: SourceSearchProps) {
  const [packed, setPacked] = useState<ReadonlyMap<string, string> | string | null>(null);
  useEffect(() => {
    let current = true;
    Promise.all(list.map(async ({ path }) => [path, await sources.packed(path)] as const)).then(
      (all) => {
        if (current) setPacked(new Map(all));
      },
      (error: unknown) => {
        if (current) setPacked(problemOf(error).what);
      },
    );
    return () => {
      current = false;
    };
  }, [sources]);
  const found = useMemo(() => {
    if (packed === null || typeof packed === 'string') return null;
    const files = list.map(({ path, file, state }) => ({
      file,
      text: (state === 'changed' ? sources.changed(path) : undefined) ?? packed.get(path) ?? '',
    }));
    return searchSources(files, wanted);
  }, [packed, list, wanted]);
  if (found === null) return typeof packed === 'string' ? <p class="hint">{packed}</p> : null;
  return (
    <div class="source-hits" role="group" aria-label={sourceTexts.hits} tabIndex={0}>
      <p class="hint" role="status">
        {sourceTexts.hitCount(found.hits.length, found.more)}
      </p>
      <ul role="list">
        {found.hits.map(({ file, line, before, found: text, after }) => (
          <li key={`${file}:${line}`}>
            <button type="button" class="link-button" onClick={() => onHit(file, line)}>
              <Name text={`${file}:${line}`} />
            </button>{' '}
            <code>
              {before}
              <mark>{text}</mark>
              {after}
            </code>
          </li>
        ))}
      </ul>
    </div>
  );
}
