// The page's icons: small line drawings in one 16 by 16 grid, hidden from assistive technology because a
// text or label always stands beside them.

const PATHS = {
  play: 'M5 3.2v9.6L12.6 8Z',
  stop: 'M4 4h8v8H4Z',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  step: 'M3.5 3.4v9.2L10 8ZM12.5 3.4v9.2',
  restart: 'M12.9 6.2A5.2 5.2 0 1 0 13.2 8M13.4 2.8v3.6H9.8',
  copy: 'M5.5 5.5h7v8h-7ZM10.5 5.5v-3h-7v8h2',
  clear: 'M3 4.5h10M6.5 4.5v-2h3v2M4.5 4.5l.6 9h5.8l.6-9M6.8 7v4M9.2 7v4',
  input: 'M1.8 4h12.4v8H1.8ZM4.2 6.6h.01M6.7 6.6h.01M9.2 6.6h.01M11.7 6.6h.01M4.8 9.5h6.4',
  sun: 'M8 5.1a2.9 2.9 0 1 0 0 5.8 2.9 2.9 0 0 0 0-5.8ZM8 1v1.6M8 13.4V15M1 8h1.6M13.4 8H15M3 3l1.2 1.2M11.8 11.8 13 13M13 3l-1.2 1.2M4.2 11.8 3 13',
  moon: 'M13.4 9.6A5.8 5.8 0 0 1 6.4 2.6a5.8 5.8 0 1 0 7 7Z',
  system: 'M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8ZM8 1.8v12.4',
  info: 'M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8ZM8 7.2v4M8 4.8h.01',
  chevron: 'm6 3.5 4.5 4.5L6 12.5',
  search: 'M7 2.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9ZM10.4 10.4 14 14',
  down: 'M8 2.5v11M3.5 9 8 13.5 12.5 9',
  close: 'm3.5 3.5 9 9M12.5 3.5l-9 9',
  check: 'm2.8 8.6 3.4 3.4 7-8',
  warning: 'M8 2 1.6 13.4h12.8ZM8 6.4v3.4M8 11.6h.01',
  crash: 'M5.4 1.8h5.2l3.6 3.6v5.2l-3.6 3.6H5.4l-3.6-3.6V5.4ZM5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4',
  ring: 'M8 3.2a4.8 4.8 0 1 0 0 9.6 4.8 4.8 0 0 0 0-9.6Z',
  disc: 'M8 3.6a4.4 4.4 0 1 0 0 8.8 4.4 4.4 0 0 0 0-8.8Z',
  arc: 'M8 3.2A4.8 4.8 0 1 1 3.2 8',
  nodes: 'M4 6.2a2 2 0 1 0 0-4 2 2 0 0 0 0 4ZM12 13.8a2 2 0 1 0 0-4 2 2 0 0 0 0 4ZM4 6.2v2.6a3 3 0 0 0 3 3h3',
  code: 'M5.4 4.4 1.8 8l3.6 3.6M10.6 4.4 14.2 8l-3.6 3.6',
  console: 'M1.8 2.8h12.4v10.4H1.8ZM4.4 6l2.2 2-2.2 2M8.2 10.2h3.4',
  topics:
    'M8 6.8a1.2 1.2 0 1 0 0 2.4 1.2 1.2 0 0 0 0-2.4ZM5.2 10.8a4 4 0 0 1 0-5.6M10.8 5.2a4 4 0 0 1 0 5.6M3.1 12.9a6.9 6.9 0 0 1 0-9.8M12.9 3.1a6.9 6.9 0 0 1 0 9.8',
  tabs: 'M1.8 5.8h8.4v7.4H1.8ZM5.2 5.8v-3h9v7.4h-4',
  plus: 'M8 3v10M3 8h10',
  minus: 'M3 8h10',
  fit: 'M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10',
  frames: 'M5 11V2.5M5 11h8.5M5 11l-3 3M3.4 4.2 5 2.5l1.6 1.7M11.8 9.4l1.7 1.6-1.7 1.6',
  health: 'M1.5 8.5h3l1.8-4.6 3 8.4 2-5.2.9 1.4h2.3',
  lifecycle:
    'M8 2.4a2.1 2.1 0 1 0 0 4.2 2.1 2.1 0 0 0 0-4.2ZM3.6 9.6a2.1 2.1 0 1 0 0 4.2 2.1 2.1 0 0 0 0-4.2ZM12.4 9.6a2.1 2.1 0 1 0 0 4.2 2.1 2.1 0 0 0 0-4.2ZM6.8 6.2 4.8 9.8M9.2 6.2l2 3.6M5.8 11.7h4.4',
  graph: 'M1.8 6h4.4v4H1.8ZM9.8 2.2h4.4v4H9.8ZM9.8 9.8h4.4v4H9.8ZM6.2 8H8M8 4.2v7.6M8 4.2h1.8M8 11.8h1.8',
  more: 'M3 7.4v1.2M8 7.4v1.2M13 7.4v1.2',
  layout: 'M1.8 2.8h12.4v10.4H1.8ZM6.4 2.8v10.4M6.4 8h7.8',
  publish: 'M1.8 8.2 14.2 2 9.8 14 7.4 9.4ZM7.4 9.4 14.2 2',
  call: 'M2 5.2h10.5M9.6 2.4l2.9 2.8-2.9 2.8M14 10.8H3.5M6.4 8l-2.9 2.8 2.9 2.8',
  sliders: 'M2 4h6.4M11.6 4H14M8.4 2.4v3.2h3.2V2.4ZM2 12h2.4M7.6 12H14M4.4 10.4v3.2h3.2v-3.2Z',
  drive: 'M8 10V5.6M8 5.6a1.8 1.8 0 1 0 0-3.6 1.8 1.8 0 0 0 0 3.6ZM2.6 10h10.8v3.6H2.6Z',
  plot: 'M2.2 2.2v11.6h11.6M4.4 10.6l2.8-4 2.6 2.2 3.6-5',
  text: 'M3.2 1.8h6.4l3.2 3.2v9.2H3.2ZM9.2 1.8v3.6h3.6M5.6 8.2h4.8M5.6 10.8h4.8',
  notebook: 'M4 1.8h9v12.4H4ZM6.4 1.8v12.4M2.6 4.6h2.6M2.6 8h2.6M2.6 11.4h2.6M8.6 5h2.4',
  up: 'M8 13.5v-11M3.5 7 8 2.5 12.5 7',
  edit: 'M2.6 13.4l.6-3 7.4-7.4 2.4 2.4-7.4 7.4ZM9.2 4.4l2.4 2.4',
  log: 'M2.4 4h.01M5.2 4h8.4M2.4 8h.01M5.2 8h8.4M2.4 12h.01M5.2 12h5.4',
  image: 'M1.8 2.8h12.4v10.4H1.8ZM1.8 11.2l3.6-3.6 3 3 2.2-2.2 3.6 3.6M10.6 5.8h.01',
  scene: 'M8 1.8 13.6 5v6L8 14.2 2.4 11V5ZM2.4 5 8 8.2 13.6 5M8 8.2v6',
  simulation: 'M1.8 12.6h12.4M3.4 12.6V7.2h5v5.4M10.6 12.4a2 2 0 1 0 0-4 2 2 0 0 0 0 4ZM6 1.6v3.2M4.2 3.4 6 5.2l1.8-1.8',
  hand:
    'M4.6 8.6V4.2a1 1 0 0 1 2 0v3V2.8a1 1 0 0 1 2 0v4.4V3.6a1 1 0 0 1 2 0v4V5.4a1 1 0 0 1 2 0v4.8a4 4 0 0 1-4 4H8a4 4 0 0 1-3.2-1.6L2.4 9.4a1 1 0 0 1 1.5-1.3Z',
  push: 'M1.8 8h7.4M6.4 5.2 9.2 8l-2.8 2.8M11.2 3.4h3v9.2h-3Z',
  goal: 'M8 1.8a4.4 4.4 0 0 0-4.4 4.4C3.6 9.6 8 14.2 8 14.2s4.4-4.6 4.4-8A4.4 4.4 0 0 0 8 1.8ZM8 4.8v2.8M6.6 6.2h2.8',
  estimate: 'M2.4 13.6 12 4M12 4H7.6M12 4v4.4M2.4 9.4v4.2h4.2',
  target: 'M8 3.4a4.6 4.6 0 1 0 0 9.2 4.6 4.6 0 0 0 0-9.2ZM8 1.4v4M8 10.6v4M1.4 8h4M10.6 8h4',
  ruler: 'm1.8 10.6 8.8-8.8 3.6 3.6-8.8 8.8ZM4.4 8l1.4 1.4M6.6 5.8l2 2M8.8 3.6l1.4 1.4',
  above: 'M2.4 2.4h11.2v11.2H2.4ZM8 2.4v11.2M2.4 8h11.2',
  left: 'm10 3.5-4.5 4.5L10 12.5',
  right: 'm6 3.5 4.5 4.5L6 12.5',
  home: 'M2.2 8 8 2.6 13.8 8M4 6.6v6.8h8V6.6',
  list: 'M2.4 4h1.8M6.4 4h7.2M2.4 8h1.8M6.4 8h7.2M2.4 12h1.8M6.4 12h7.2',
  timeline: 'M1.8 3.6h5v3.2h-5ZM8.4 3.6h5.8v3.2H8.4ZM1.8 9.2h8v3.2h-8ZM11.4 9.2h2.8v3.2h-2.8Z',
  turtle:
    'M7.6 4.2c2.6 0 4 1.8 4 3.9s-1.4 3.9-4 3.9-4.4-2-4.4-3.9 1.8-3.9 4.4-3.9ZM11.6 7a1.7 1.7 0 1 1 0 2.2M9.6 4.6l1-2M5 4.9l-1.4-1.6M9.6 11.6l1 2M5 11.3l-1.4 1.6',
  bag: 'M4.6 5.6a3 3 0 1 0 0 6 3 3 0 0 0 0-6ZM11.4 5.6a3 3 0 1 0 0 6 3 3 0 0 0 0-6ZM4.6 11.6h6.8M4.6 8.6h.01M11.4 8.6h.01',
  link: 'M6.6 9.4 9.4 6.6M7.2 4.6l1.4-1.4a3 3 0 0 1 4.2 4.2l-1.4 1.4M8.8 11.4l-1.4 1.4a3 3 0 0 1-4.2-4.2l1.4-1.4',
} as const;

export type IconName = keyof typeof PATHS;

const FILLED: ReadonlySet<IconName> = new Set<IconName>(['play', 'stop', 'disc']);

export function Icon({ name, class: extra }: { readonly name: IconName; readonly class?: string; }) {
  return (
    <svg
      class={`icon ${FILLED.has(name) ? 'icon-filled' : ''} ${extra ?? ''}`}
      viewBox="0 0 16 16"
      aria-hidden="true"
      focusable="false"
    >
      <path d={PATHS[name]} />
    </svg>
  );
}

/** The sign of ros2wasm: two nodes and what flows between them. The same drawing as icon.svg. */
export function Mark() {
  return (
    <svg class="mark" viewBox="0 0 32 32" aria-hidden="true" focusable="false">
      <rect class="mark-ground" width="32" height="32" rx="8" />
      <path class="mark-line" d="M10.5 13.5v3a5 5 0 0 0 5 5h2.5" />
      <circle class="mark-ink" cx="10.5" cy="10" r="4" />
      <circle class="mark-accent" cx="22" cy="21.5" r="4" />
    </svg>
  );
}
