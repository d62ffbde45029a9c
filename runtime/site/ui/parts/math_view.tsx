// A formula: TeX to MathML elements. Only elements and attributes that are listed here are made, whatever the text says.

import { createElement } from 'preact';
import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';

type Temml = typeof import('temml').default;

const ELEMENTS: ReadonlySet<string> = new Set([
  'math',
  'semantics',
  'mrow',
  'mi',
  'mn',
  'mo',
  'ms',
  'mtext',
  'mspace',
  'mfrac',
  'msqrt',
  'mroot',
  'mstyle',
  'mpadded',
  'mphantom',
  'menclose',
  'msub',
  'msup',
  'msubsup',
  'munder',
  'mover',
  'munderover',
  'mmultiscripts',
  'mprescripts',
  'mtable',
  'mtr',
  'mtd',
  'merror',
]);
const ATTRIBUTES: ReadonlySet<string> = new Set([
  'display',
  'mathvariant',
  'stretchy',
  'fence',
  'separator',
  'lspace',
  'rspace',
  'width',
  'height',
  'depth',
  'voffset',
  'accent',
  'accentunder',
  'movablelimits',
  'largeop',
  'symmetric',
  'minsize',
  'maxsize',
  'columnalign',
  'rowspacing',
  'columnspacing',
  'columnlines',
  'rowlines',
  'linethickness',
  'displaystyle',
  'scriptlevel',
  'notation',
  'form',
]);
const MOST_DEPTH = 100;
/** Without a font for formulas an index of low letters would not be lowered: it is made as high as its line. */
const LOWERED: ReadonlySet<string> = new Set(['msub', 'msubsup']);
const STRUT = '0.8em';

export function MathView({ tex, block }: { readonly tex: string; readonly block: boolean; }) {
  const [temml, setTemml] = useState<Temml | null>(null);
  useEffect(() => {
    let current = true;
    import('temml').then(
      (loaded) => {
        if (current) setTemml(() => loaded.default);
      },
      // Without it the formula stands as it was written.
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, []);
  const formula = temml === null ? null : formulaOf(temml, tex, block);
  if (formula === null) return <code>{tex}</code>;
  return block ? <div class="text-math">{formula}</div> : <>{formula}</>;
}

function formulaOf(temml: Temml, tex: string, block: boolean): ComponentChildren {
  try {
    const tree: unknown = temml.__renderToMathMLTree(tex, {
      displayMode: block,
      throwOnError: true,
      trust: false,
      strict: false,
      maxSize: [20, 400],
      maxExpand: 500,
    });
    return elementOf(tree, 0);
  } catch {
    return null;
  }
}

function elementOf(node: unknown, depth: number): ComponentChildren {
  if (typeof node !== 'object' || node === null || depth > MOST_DEPTH) return null;
  const { type, text, attributes, children } = node as {
    readonly type?: unknown;
    readonly text?: unknown;
    readonly attributes?: unknown;
    readonly children?: unknown;
  };
  if (typeof text === 'string') return text;
  const inside = (Array.isArray(children) ? children : []).map((child: unknown) => elementOf(child, depth + 1));
  if (typeof type !== 'string' || !ELEMENTS.has(type)) return inside;
  const kept = Object.entries(
    typeof attributes === 'object' && attributes !== null ? attributes : {},
  ).filter(([name, value]) => ATTRIBUTES.has(name) && typeof value === 'string');
  const [base, below, ...others] = inside;
  const parts = LOWERED.has(type) ? [base, createElement('mrow', null, below, createElement('mspace', { height: STRUT })), ...others] : inside;
  return createElement(type, Object.fromEntries(kept), ...parts);
}
