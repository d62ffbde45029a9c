// Words of handing in what was done of a lab or a course.

export const handInTexts = {
  name: 'Your name, or the ID that your course asks for',
  save: 'Save the file to hand in',
  about: 'The file says which tasks are done and when, and which hints and solutions were shown. This browser signs it. Nothing is sent anywhere.',
  noSite: 'The site\u2019s own list, site.json, did not come. Try again when the network is back.',
  noName: 'Type your name first.',
  noKey: {
    insecure: 'This page is not on https://, so the browser cannot sign a file. Ask for the address that begins with https://.',
    unsupported: 'This browser cannot sign the file (Ed25519). Chrome 137, Firefox 129 and Safari 17 can, and newer ones.',
  },
  saved: (file: string): string => `Saved as ${file}. Hand it in as it is: one changed letter, and its signature does not fit.`,
  savedOnce: (file: string): string => `Saved as ${file}, signed with a key for this visit only, as the browser keeps nothing here. Hand it in as it is.`,
} as const;
