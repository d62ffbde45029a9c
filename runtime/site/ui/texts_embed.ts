// English texts of the page inside another one.

export const embedTexts = {
  whole: 'Open the whole page',
  wholeLong: (title: string): string => `Open the whole page of ${title} in a tab of its own`,
  foot: 'About these panels',
  /** Errors that are reported to the page around this one: the problem, and a fix. */
  refusals: {
    version: (version: number) => [`this page speaks version ${version} of these messages`, `write \`ros2wasm: ${version}\` in every one`],
    form: (most: number) => [
      'the message is not a plain value, or it is too large or too deep',
      `send objects, lists, texts, finite numbers and flags: at most ${most} characters as JSON, 8 deep`,
    ],
    command: (name: string | undefined, known: string) => [
      name === undefined ? 'the message has no `do`' : `\`${name}\` is not a command`,
      `commands are: ${known}`,
    ],
    name: (key: string, most: number) => [`\`${key}\` is not a valid name`, `give \`${key}\` as a text of 1 to ${most} characters`],
    missing: (key: string) => [`there is no \`${key}\``, `give \`${key}\``],
    fields: (key: string) => [`\`${key}\` has no fields`, `give \`${key}\` as an object with the message's fields`],
    tooOften: (perSecond: number) => ['this page is asked too often', `ask at most ${perSecond} times a second`],
    busy: () => ['too much is under way', 'wait for the answers to what was asked'],
    publishers: (most: number) => ['too many topics are published on', `publish on at most ${most} topics`],
    subscriptions: (most: number) => ['too many topics are subscribed to', `have at most ${most} subscriptions, or \`unsubscribe\``],
    node: (name: string) => [`there is no node \`${name}\``, 'take an id or a name that `state` gives'],
    type: (reason: string) => [reason, 'take a type that the site uses, by its full name: `std_msgs/msg/String`'],
    subscription: () => ['there is no such subscription', 'give the number that `subscribe` answered'],
    checks: () => ['this site has no checks', 'write `checks:` in the manifest'],
    parameter: (node: string, reason: string) => [`${node} refuses: ${reason}`, ''],
    origin: (origin: string) => [`the page ${origin} may look at this site, but not act on it`, 'pack the site with `site: {embed: [ORIGIN]}` in its manifest'],
  } satisfies Record<string, (...given: never[]) => readonly [what: string, fix: string]>,
  originWhy: 'the author of the site lists the origins of pages that may',
  tooLarge: (bytes: number, most: number): string => `a message of ${bytes} bytes: at most ${most} are passed on`,
};
