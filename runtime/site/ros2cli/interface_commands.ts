// ros2 interface list, packages, package, show, proto.

import { qualify } from '../decode/definitions.ts';
import { toYaml } from '../decode/yaml.ts';
import { type Command, CommandError, type Context, has } from './command.ts';

const kinds = [['msg', 'Messages', 'only-msgs', 'm'], ['srv', 'Services', 'only-srvs', 's'], ['action', 'Actions', 'only-actions', 'a']] as const;

async function namesIn(context: Context): Promise<string[]> {
  return [...(await context.session.interfaces()).keys()].sort();
}

export const interfaceCommands: readonly Command[] = [
  {
    words: ['interface', 'list'],
    help: 'List all interface types available',
    positionals: [],
    options: kinds.map(([, title, long, short]) => ({ names: [`--${long}`, `-${short}`], help: `Print out only the ${title.toLowerCase()}` })),
    run: async (context, given) => {
      const asked = kinds.filter(([, , option]) => has(given, option));
      const names = await namesIn(context);
      for (const [kind, title] of asked.length === 0 ? kinds : asked) {
        context.print([`${title}:`, ...names.filter((name) => name.split('/')[1] === kind).map((name) => `    ${name}`)].join('\n'));
      }
      return 0;
    },
  },
  {
    words: ['interface', 'packages'],
    help: 'Output a list of packages that provide interfaces',
    positionals: [],
    options: kinds.map(([, title, long, short]) => ({ names: [`--${long}`, `-${short}`], help: `Only those that provide ${title.toLowerCase()}` })),
    run: async (context, given) => {
      const asked = kinds.filter(([, , option]) => has(given, option)).map(([kind]) => kind as string);
      const names = (await namesIn(context)).filter((name) => asked.length === 0 || asked.includes(name.split('/')[1]!));
      for (const name of new Set(names.map((each) => each.split('/')[0]!))) context.print(name);
      return 0;
    },
  },
  {
    words: ['interface', 'package'],
    help: 'Output a list of available interface types within one package',
    positionals: [{ name: 'package_name', meaning: 'package' }],
    options: kinds.map(([, title, long, short]) => ({ names: [`--${long}`, `-${short}`], help: `Print out only the ${title.toLowerCase()}` })),
    run: async (context, given) => {
      const asked = kinds.filter(([, , option]) => has(given, option)).map(([kind]) => kind as string);
      const names = (await namesIn(context)).filter((name) => name.startsWith(`${given.positionals[0]}/`));
      if (names.length === 0) throw new CommandError(`Unknown package '${given.positionals[0]}'`);
      for (const name of names) if (asked.length === 0 || asked.includes(name.split('/')[1]!)) context.print(name);
      return 0;
    },
  },
  {
    words: ['interface', 'show'],
    help: 'Output the interface definition',
    positionals: [{ name: 'type', meaning: 'interface' }],
    options: [
      { names: ['--all-comments'], help: 'Show all comments, including for nested interface definitions' },
      { names: ['--no-comments'], help: 'Show no comments or whitespace' },
    ],
    run: async (context, given) => {
      const interfaces = await context.session.interfaces();
      const [type = ''] = given.positionals;
      if (!interfaces.has(type)) throw new CommandError(`Unknown interface '${type}'`);
      const own = has(given, 'no-comments') ? 'none' : 'all';
      context.print(showLines(interfaces, type, own, has(given, 'all-comments') ? 'all' : 'none', '', 0).join('\n'));
      return 0;
    },
  },
  {
    words: ['interface', 'proto'],
    help: 'Output an interface prototype',
    positionals: [{ name: 'type', meaning: 'interface' }],
    options: [{ names: ['--no-quotes'], help: 'if true output has no outer quotes.' }],
    run: async (context, given) => {
      const [type = ''] = given.positionals;
      const codec = await context.codec();
      const of = type.split('/')[1] === 'srv' ? `${type}_Request` : type.split('/')[1] === 'action' ? `${type}_Goal` : type;
      const draft = codec.draft(of);
      const parsed = codec.types.get(of);
      if (draft.kind === 'failed' || typeof parsed === 'string') throw new CommandError(draft.kind === 'failed' ? draft.reason : String(parsed));
      const text = toYaml(draft.value, parsed.shape, null);
      context.print(has(given, 'no-quotes') ? text : `"${text}"`);
      return 0;
    },
  },
];

const deepest = 32;

/** The lines of a definition, and below each field of another type those of that type, one tab further in. */
function showLines(
  interfaces: ReadonlyMap<string, string>,
  type: string,
  comments: 'all' | 'none',
  inner: 'all' | 'none',
  indent: string,
  depth: number,
): string[] {
  const lines: string[] = [];
  for (const line of (interfaces.get(type) ?? '').replace(/\n$/, '').split('\n')) {
    const code = line.replace(/\s*#.*$/, '');
    const isText = /^\s*string\S*\s+\w+\s*=?\s*['"]/.test(line);
    const text = comments === 'all' || isText ? line.trimEnd() : code.trimEnd();
    if (comments === 'none' && text.trim() === '') continue;
    lines.push(text === '' ? '' : `${indent}${text}`);
    const field = /^\s*([A-Za-z][\w/]*)(?:\[[^\]]*\])?\s+[A-Za-z]/.exec(code)?.[1];
    const full = field === undefined || /^(?:w?string)$/.test(field) ? null : qualify(field, type);
    if (full !== null && depth < deepest && interfaces.has(full)) {
      lines.push(...showLines(interfaces, full, inner, inner, `${indent}\t`, depth + 1));
    }
  }
  return lines;
}
