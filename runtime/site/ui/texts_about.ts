// English texts of the dialog about the page, which come with it.

export const aboutTexts = {
  close: 'Close',
  what:
    'A ROS 2 workspace, packed into static files. It runs in this browser: no server takes part, nothing is installed, and nothing you do here leaves this device.',
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
  unsigned: 'This site has no signature.',
  signed: (key: string, comment: string): string =>
    `A signature by the key ${key} is beside this site, with the comment \u201c${comment}\u201d. This page cannot vouch for itself: compare the key with what its author says elsewhere, then run ros2wasm verify with --key and this address.`,
  cite: 'Cite this site',
  copyCite: 'Copy BibTeX',
  licenses: 'Licenses of all parts',
  materials: 'Bill of materials (SPDX)',
  copyReport: 'Copy a report',
  reportHint: 'for a bug report: versions, states and problems, no console text.',

  /** The kind of link between the nodes. */
  sharedLong: 'This page is isolated by the browser, so the nodes share memory: a message is written once and wakes its readers directly.',
  portLong:
    'This page could not be isolated by the browser, so the nodes pass messages through ports. Nodes that start threads cannot run here; all else works, slower.',
  portFix:
    'For the faster link, open the page by itself in a normal window: not inside a frame, not in a private window that forbids service workers. Or serve it with the headers \u201cCross-Origin-Opener-Policy: same-origin\u201d and \u201cCross-Origin-Embedder-Policy: require-corp\u201d, as \u201cros2wasm serve\u201d does.',
};
