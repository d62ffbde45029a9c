// Every English text of the page, in one place, ready for translation. No markup in here. Some panels have theirs
// beside it (texts_bag.ts, texts_source.ts, texts_views.ts): they come with the panel.

export const texts = {
  product: 'ros2wasm',
  skipToConsole: 'Skip to the consoles',
  starting: 'Starting\u2026',

  startAll: 'Start all',
  stopAll: 'Stop all',
  restartAll: 'Restart all',
  runningOf: (running: number, all: number): string => `${running} of ${all} running`,
  version: (version: string): string => `version ${version}`,
  by: (names: string): string => `by ${names}`,

  launch: {
    title: 'Launch arguments',
    apply: 'Apply and restart',
    defaults: 'Back to defaults',
    usual: (value: string): string => (value === '' ? 'default: empty' : `default: ${value}`),
    none: 'no default',
    python: ({ program, tried }: { readonly program?: string; readonly tried: readonly string[] }): string =>
      program !== undefined
        ? 'The launch file is written in Python: what only Python decides is asked of it again, in this page.'
        : tried.length === 0
          ? 'The launch file is written in Python: what only Python decides stays as it was packed.'
          : `The launch file is written in Python: what only Python decides was packed for each value of ${tried.join(', ')}; with other values it stays as it was packed.`,
    reran: 'Python was asked again for these values.',
    decided:
      'Some of what runs was decided in Python when the site was packed, for other values of the arguments.',
  },

  seed: {
    title: 'Repeatable run',
    label: 'Seed',
    about: 'One node runs at a time, and time is held at first: every run with this seed sends the same messages.',
    wrong: 'A seed is a whole number below 1,000,000,000.',
    apply: 'Restart with this seed',
    leave: 'Restart without a seed',
  },

  time: {
    group: 'Time of the site',
    pause: 'Pause the time of all nodes',
    resume: 'Resume the time of all nodes',
    step: (length: string): string => `Let time run for ${length}`,
    stepLength: 'Length of a step',
    speed: 'Speed of time',
    length: (ms: number): string => (ms < 1000 ? `${ms}\u00a0ms` : `${ms / 1000}\u00a0s`),
    times: (rate: number): string => `${rate}\u00d7`,
    state: { running: '', stepping: 'Stepping', paused: 'Paused' },
    seed: (seed: number): string => `Seed ${seed}`,
    trace: (seed: number, messages: number, hash: string): string =>
      `Seed ${seed}: ${messages} messages, sha256 ${hash}\u2026`,
  },

  theme: {
    system: 'Theme: as the system. Switch to light',
    light: 'Theme: light. Switch to dark',
    dark: 'Theme: dark. Switch to the system\u2019s',
  },

  link: {
    shared: 'Shared memory',
    port: 'Message ports',
    sharedLong:
      'This page is isolated by the browser, so the nodes share memory: a message is written once and wakes its readers directly.',
    portLong:
      'This page could not be isolated by the browser, so the nodes pass messages through ports. Nodes that start threads cannot run here; all else works, slower.',
    portFix:
      'For the faster link, open the page by itself in a normal window: not inside a frame, not in a private window that forbids service workers. Or serve it with the headers \u201cCross-Origin-Opener-Policy: same-origin\u201d and \u201cCross-Origin-Embedder-Policy: require-corp\u201d, as \u201cros2wasm serve\u201d does.',
  },

  checks: {
    none: 'This workspace says nothing of what must be seen. Its manifest can, under \u201cchecks\u201d.',
    again: 'Forget what was seen, and check again from now on',
    waiting: (within: string): string => `Not seen yet, within ${within}`,
    passed: 'Seen',
    failed: (within: string): string => `Not seen within ${within}`,
    after: (duration: string): string => `after ${duration}`,
    seen: (words: string): string => `Seen: ${words}`,
    passedOf: (passed: number, all: number): string => `${passed} of ${all} checks passed`,
  },
  panels: { nodes: 'Nodes', console: 'Consoles', topics: 'Topics', plot: 'Plot', graph: 'Graph', frames: 'Frames', diagnostics: 'Diagnostics', lifecycle: 'Lifecycle', timeline: 'States', checks: 'Checks', source: 'Source', terminal: 'Terminal', notebook: 'Notebook', publish: 'Publish', services: 'Services and actions', parameters: 'Parameters', teleop: 'Teleop', text: 'Text', log: 'Log', image: 'Image', turtlesim: 'Turtlesim', scene: '3D view', bag: 'Bag' },
  panelTabs: 'Panels',

  layout: {
    menu: 'Layout of the page',
    copyLink: 'Copy a link to this view',
    usual: 'Usual layout',
    add: 'Open a panel here',
    more: (title: string): string => `Move or close ${title}`,
    close: (title: string): string => `Close ${title}`,
    closed: 'Closed',
    moved: 'Moved',
    moveEarlier: 'One tab to the left',
    moveLater: 'One tab to the right',
    movePrevious: 'Into the group before',
    moveNext: 'Into the next group',
    splitLeft: 'Beside the others, left',
    splitRight: 'Beside the others, right',
    splitAbove: 'Above the others',
    splitBelow: 'Below the others',
    besideOther: (title: string): string => `Right of ${title}`,
    belowOther: (title: string): string => `Below ${title}`,
    border: (first: string, second: string): string => `Border between ${first} and ${second}`,
    numbered: (title: string, number: number): string => `${title} ${number}`,
    nothing: 'nothing',
    empty: 'Nothing is open here. The plus sign opens a panel.',
    notice: 'About the link you followed',
    dismiss: 'Dismiss',
    linkOther:
      'This link was made for another version of this site. Its view is shown as far as it fits.',
    linkBroken: 'The view in this link cannot be read. The usual one is shown.',
    linkLeftOut: (names: readonly string[]): string =>
      `This page has no such panels, so they are left out: ${names.join(', ')}.`,
    linkChanged: (files: string): string =>
      `Who made this link had changed sources, which are not in it: ${files}. Here they are as you have them.`,
    linkInAddress: 'The browser refused to copy. The link stands in the address bar.',
  },

  tabs: {
    join: 'Join other tabs of this site: their nodes and these see each other',
    open: (graph: string): string =>
      `Graph \u201c${graph}\u201d. Opens another tab that joins it and runs the nodes that nobody runs`,
    place: (number: number, count: number): string => `Tab ${number} of ${count}`,
    elsewhere: (tabs: readonly number[]): string => `runs in tab ${tabs.join(', ')}`,
  },
  nodes: {
    none: 'This workspace starts no nodes.',
    start: (label: string): string => `Start ${label}`,
    stop: (label: string): string => `Stop ${label}`,
    restart: (label: string): string => `Restart ${label}`,
    showConsole: (label: string): string => `Show only the console of ${label}`,
    showAll: 'Show the consoles of all nodes',
    program: 'Program',
    declared: 'Declared at',
    source: (label: string): string => `Source of ${label}`,
    changed: 'changed',
    changedLong: (files: readonly string[]): string => `Runs with sources that were changed in this browser: ${files.join(', ')}`,
    upSince: (duration: string): string => `for ${duration}`,
  },

  state: {
    stopped: 'Stopped',
    waitsForStart: (node: string): string => `Waits for ${node} to start`,
    waitsForLine: (node: string): string => `Waits for what ${node} prints`,
    waitsForEnd: (node: string): string => `Waits for ${node} to end`,
    waitsForChange: (name: string, state?: string): string =>
      state === undefined ? `Waits for a change of ${name}` : `Waits until ${name} is ${state}`,
    starting: 'Starting',
    running: 'Running',
    finished: 'Finished, code 0',
    exited: (code: number): string => `Exited with code ${code}`,
    crashed: 'Crashed',
    announceCrash: (label: string, message: string): string => `${label} crashed: ${message.split('\n', 1)[0] ?? ''}`,
    announceExit: (label: string, code: number): string => `${label} exited with code ${code}`,
  },

  console: {
    view: 'How consoles are shown',
    each: 'Each node',
    merged: 'Merged',
    filter: 'Filter lines',
    level: 'Lowest level shown',
    allLevels: 'All levels',
    atLeast: (level: string): string =>
      level === 'FATAL'
        ? 'Fatal only'
        : `${level.charAt(0)}${level.slice(1).toLowerCase()} and above`,
    of: (label: string): string => `Console of ${label}`,
    mergedLabel: 'Console of all nodes',
    empty: 'Nothing printed yet.',
    emptyForGood: 'Nothing printed.',
    emptyFiltered: (count: string): string => `None of ${count} lines match the filter.`,
    copy: (label: string): string => `Copy the console of ${label}`,
    save: (label: string): string => `Save the console of ${label}`,
    clear: (label: string): string => `Clear the console of ${label}`,
    input: (label: string): string => `Type into ${label}`,
    inputLabel: (label: string): string => `Standard input of ${label}`,
    inputHint: 'Type a line, then Enter; Ctrl-C stops',
    keysHint: 'Keys go to the node at once; Tab leads on',
    send: 'Send',
    latest: 'Latest',
    toSource: (file: string, line: number): string => `Show line ${line} of ${file}`,
    newer: (count: string): string => `${count} new`,
    showAll: 'Show all nodes',
    allNodes: 'all nodes',
    allTitle: 'All nodes',
    launch: 'the launch file',
    launchTitle: 'Launch file',
  },

  topics: {
    none: 'No topics yet. They appear when nodes create publishers or subscriptions.',
    noneShown: 'Only hidden topics so far.',
    noneMatch: 'No topic matches the filter.',
    filter: 'Filter topics',
    hidden: 'Show hidden topics',
    hiddenShort: 'Show hidden',
    publishers: (count: number): string => (count === 1 ? '1 publisher' : `${count} publishers`),
    subscriptions: (count: number): string =>
      count === 1 ? '1 subscription' : `${count} subscriptions`,
    publishersShort: 'pub',
    subscriptionsShort: 'sub',
    rate: 'Rate',
    bandwidth: 'Bandwidth',
    count: 'Messages',
    qos: 'QoS',
    lastMessage: 'Last message',
    lastOf: (name: string): string => `Last message of ${name}`,
    noMessage: 'No message has been published yet.',
    fetching: 'Fetching the last message\u2026',
    notKept: 'The last message was large and is gone with its publisher. Large ones are kept while their topic is open.',
    ago: (duration: string): string => `${duration} ago`,
    copy: (name: string): string => `Copy the last message of ${name} as YAML`,
    decoding: 'Loading the decoder\u2026',
    undecodable: (reason: string): string => `Cannot be shown: ${reason}.`,
    bytes: (count: string): string => `${count} bytes`,
    items: (count: string, type: string): string => `${count} \u00d7 ${type}`,
    shownOf: (shown: string, all: string): string => `the first ${shown} of ${all}`,
    qosWords: {
      reliable: 'reliable',
      best_effort: 'best effort',
      transient_local: 'transient local',
      volatile: 'volatile',
      keep_last: (depth: number): string => `keep\u00a0last\u00a0${depth}`,
      keep_all: 'keep all',
    },
  },


  about: {
    open: 'About this page',
    openLink: (link: string): string => `Link between the nodes: ${link}. About this page`,
    close: 'Close',
    title: 'About this page',
    what: 'A ROS 2 workspace, packed into static files. It runs in this browser: no server takes part, nothing is installed, and nothing you do here leaves this device.',
    workspace: 'Workspace',
    authors: 'Authors',
    license: 'License',
    distro: 'ROS 2',
    link: 'Link',
    size: 'Size',
    sizeOf: (files: string, bytes: string): string => `${files} files, ${bytes}`,
    offline: 'Offline',
    offlineYes: 'kept in this browser: opens again without a network',
    offlineNo: 'not kept: a file did not come, or this browser allows no service worker here',
    generator: 'Made with',
    digest: 'sha256',
    whoSigned: 'Who signed it?',
    unsigned: 'No signature lies beside this site.',
    signed: (key: string, comment: string): string =>
      `A signature by the key ${key} lies beside this site, with the comment \u201c${comment}\u201d. This page cannot vouch for itself: compare the key with what its author says elsewhere, then run ros2wasm verify with --key and this address.`,
    cite: 'Cite this site',
    copyCite: 'Copy BibTeX',
    licenses: 'Licenses of all parts',
    materials: 'Bill of materials (SPDX)',
    copyReport: 'Copy a report',
    reportHint: 'for a bug report: versions, states and problems, no console text.',
  },

  copied: 'Copied',
  copyFailed: 'The browser refused to copy.',
  clear: 'Clear',
  copy: 'Copy',
  restart: 'Restart',

  problem: {
    why: 'why',
    fix: 'fix',
    dismiss: 'Dismiss',
    copy: 'Copy this report',
    reload: 'Try again',
    startTitle: 'This page could not start',
    panelTitle: (panel: string): string => `The panel \u201c${panel}\u201d failed`,
    pageTitle: 'Something in this page failed',
    panelWhy: 'the other panels and the nodes go on; this is a mistake in the page',
    panelFix: 'open the panel again, and send us the report',
    nodeHint: 'The other nodes go on. The last lines of its console may tell more.',
  },
} as const;
