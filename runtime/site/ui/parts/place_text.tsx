// A line of a traceback, in which the place is a button that shows it in the source.

import { useContext } from 'preact/hooks';
import { tracebackPlace } from '../model/traceback_line.ts';
import { texts } from '../texts.ts';
import { SourceLinksContext } from './source_links.ts';

export function PlaceText({ text }: { readonly text: string; }) {
  const links = useContext(SourceLinksContext);
  const place = tracebackPlace(text);
  const file = place === null ? undefined : links?.fileOf(place.path);
  if (place === null || links === null || file === undefined) return <>{text}</>;
  return (
    <>
      {text.slice(0, place.start)}
      <button
        type="button"
        class="line-place"
        title={texts.console.toSource(file, place.line)}
        onClick={() => links.open(file, place.line)}
      >
        {text.slice(place.start, place.end)}
      </button>
      {text.slice(place.end)}
    </>
  );
}
