// The lines of a console: only those in sight are in the document, however many there are. Follows the
// end until the reader scrolls up or selects text, and follows again when the end is reached.

import { Component } from 'preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { styleClasses } from '../model/ansi.ts';
import type { LineList } from '../model/line_list.ts';
import type { DisplayLine } from '../model/log_line.ts';
import { formatCount } from '../model/quantities.ts';
import { texts } from '../texts.ts';
import { Icon } from './icon.tsx';
import { PlaceText } from './place_text.tsx';

export interface LineScrollerProps {
  readonly list: LineList;
  /** Changes whenever the list does. */
  readonly version: number;
  readonly label: string;
  readonly empty: string;
}

/** Rows drawn above and below the window, so that fast scrolling shows no gap. */
const SPARE_ROWS = 12;
const PROBE_LENGTH = 64;

interface Metrics {
  /** Heights in px. */
  readonly row: number;
  readonly view: number;
}

export function LineScroller({ list, version, label, empty }: LineScrollerProps) {
  const box = useRef<HTMLDivElement>(null);
  const probe = useRef<HTMLDivElement>(null);
  const body = useRef<HTMLDivElement>(null);
  const following = useRef(true);
  const leftAt = useRef(0);
  const [metrics, setMetrics] = useState<Metrics>({ row: 20, view: 0 });
  const [top, setTop] = useState(0);
  const [away, setAway] = useState(false);
  const [corrections, setCorrections] = useState(0);

  const follow = (on: boolean): void => {
    if (following.current === on) return;
    following.current = on;
    leftAt.current = list.addedCount;
    setAway(!on);
  };

  useLayoutEffect(() => {
    const element = box.current;
    const sample = probe.current;
    if (element === null || sample === null) return undefined;
    const measure = (): void => {
      const size = sample.getBoundingClientRect();
      const style = getComputedStyle(element);
      const room = element.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
      if (size.width > 0 && room > 0) {
        list.setColumns(Math.floor(room / (size.width / PROBE_LENGTH) + 0.001));
        setMetrics({ row: size.height, view: element.clientHeight });
      }
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    observer.observe(sample);
    return () => observer.disconnect();
  }, [list]);

  useEffect(() => {
    // New lines would take the selected ones away: stay where the reader selects.
    const onSelection = (): void => {
      const selection = document.getSelection();
      if (
        selection !== null
        && !selection.isCollapsed
        && body.current?.contains(selection.anchorNode) === true
      )
        follow(false);
    };
    document.addEventListener('selectionchange', onSelection);
    return () => document.removeEventListener('selectionchange', onSelection);
  }, [list]);

  const viewRows = Math.ceil(metrics.view / metrics.row);
  const firstRow = following.current ? list.totalRows - viewRows : Math.floor(top / metrics.row);
  const shown = list.window(firstRow - SPARE_ROWS, firstRow + viewRows + SPARE_ROWS);

  useLayoutEffect(() => {
    const element = box.current;
    if (element === null) return;
    let corrected = false;
    const rows = body.current?.children ?? [];
    shown.lines.forEach((line, i) => {
      const row = rows[i];
      if (list.isUncertain(line) && row instanceof HTMLElement) {
        corrected = list.correct(shown.first + i, Math.max(1, Math.round(row.offsetHeight / metrics.row)))
          || corrected;
      }
    });
    const fallen = list.takeFallenRows();
    if (following.current) {
      element.scrollTop = element.scrollHeight;
    } else if (fallen !== 0) {
      element.scrollTop -= fallen * metrics.row;
    }
    if (corrected) setCorrections(corrections + 1);
    // Another filter changes the rows alone.
  }, [version, metrics, top, corrections, list.totalRows]);

  const onScroll = (): void => {
    const element = box.current;
    if (element === null) return;
    const atEnd = element.scrollTop + element.clientHeight >= element.scrollHeight - metrics.row / 2;
    setTop(element.scrollTop);
    follow(atEnd);
  };

  const toEnd = (): void => {
    follow(true);
    if (box.current !== null) {
      box.current.scrollTop = box.current.scrollHeight;
      box.current.focus({ preventScroll: true });
    }
  };

  const missed = list.addedCount - leftAt.current;
  return (
    <div class="lines-frame">
      <div
        class="lines"
        ref={box}
        onScroll={onScroll}
        tabIndex={0}
        role="log"
        aria-live="off"
        aria-label={label}
      >
        <div class="lines-probe" ref={probe} aria-hidden="true">
          {'M'.repeat(PROBE_LENGTH)}
        </div>
        {list.shownCount === 0
          ? (
            <p class="lines-empty">{empty}</p>
          )
          : (
            <div class="lines-all" style={{ height: `${list.totalRows * metrics.row}px` }}>
              <div
                class="lines-shown"
                ref={body}
                style={{ transform: `translateY(${shown.top * metrics.row}px)` }}
              >
                {shown.lines.map((line) => (
                  <Line key={line.key} line={line} />
                ))}
              </div>
            </div>
          )}
      </div>
      {away
        ? (
          <button type="button" class="lines-latest" onClick={toEnd}>
            <Icon name="down" />
            {missed > 0 ? texts.console.newer(formatCount(missed)) : texts.console.latest}
          </button>
        )
        : null}
    </div>
  );
}

const namesPlace = (text: string): boolean => text.includes('File "/ros/');

/** One line. Its text never changes, so it is drawn once. */
class Line extends Component<{ readonly line: DisplayLine; }> {
  override shouldComponentUpdate(next: { readonly line: DisplayLine; }): boolean {
    return next.line !== this.props.line;
  }

  override render({ line }: { readonly line: DisplayLine; }) {
    return (
      <div class={line.level === null ? 'line' : `line level-${line.level}`}>
        {line.prefix === '' ? null : <span class="line-prefix">{line.prefix}</span>}
        {line.parts === null
          ? (line.spans ?? []).map((span) => {
            const classes = styleClasses(span.style);
            if (classes === '' && namesPlace(span.text)) return <PlaceText text={span.text} />;
            return classes === '' ? span.text : <span class={classes}>{span.text}</span>;
          })
          : [
            <span class="line-level">{`[${line.parts.level}]`}</span>,
            <span class="line-stamp">{` ${line.parts.stamp} `}</span>,
            <span class="line-logger">{`${line.parts.logger}: `}</span>,
            <span class="line-message">
              {namesPlace(line.parts.message) ? <PlaceText text={line.parts.message} /> : line.parts.message}
            </span>,
          ]}
      </div>
    );
  }
}
