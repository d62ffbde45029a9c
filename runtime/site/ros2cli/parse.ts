// From a line to words, and from words to what a command was given. Pure.

import type { Command, Given, Option } from './command.ts';

/** `$NAME`, `${NAME}` and `$?`. */
const variable = /^\$(?:(\w+|\?)|\{(\w+)\})/;

/** The words of a line, with the quotes and backslashes of a shell; undefined: a quote is left open. `valueOf`: of a variable. */
export function splitLine(line: string, valueOf?: (name: string) => string): string[] | undefined {
  const words: string[] = [];
  let word: string | undefined;
  let quote = '';
  for (let i = 0; i < line.length; i += 1) {
    const c = line[i]!;
    const named = c === '$' && quote !== "'" && valueOf !== undefined ? variable.exec(line.slice(i)) : null;
    if (named !== null) {
      word = (word ?? '') + (valueOf?.(named[1] ?? named[2] ?? '') ?? '');
      i += named[0].length - 1;
    } else if (quote !== '') {
      if (c === quote) quote = '';
      else if (quote === '"' && c === '\\' && '"\\$`'.includes(line[i + 1] ?? ' ')) word += line[++i]!;
      else word += c;
    } else if (c === "'" || c === '"') {
      quote = c;
      word ??= '';
    } else if (/\s/.test(c)) {
      if (word !== undefined) words.push(word);
      word = undefined;
    } else {
      word = (word ?? '') + (c === '\\' && i + 1 < line.length ? line[++i]! : c);
    }
  }
  if (quote !== '') return undefined;
  if (word !== undefined) words.push(word);
  return words;
}

export type Parsed =
  | { readonly kind: 'run'; readonly command: Command; readonly given: Given; }
  | { readonly kind: 'help'; readonly text: string; }
  | { readonly kind: 'wrong'; readonly text: string; };

/** `words` begin after `ros2`. */
export function parseCommand(table: readonly Command[], words: readonly string[]): Parsed {
  const [group, verb] = words;
  if (group === undefined || isHelp(group)) return { kind: 'help', text: overview(table) };
  const own = table.filter((command) => command.words[0] === group);
  if (own.length === 0) {
    return { kind: 'wrong', text: `${overviewUsage}\nros2: error: argument Call \`ros2 <command> -h\` for more detailed usage.: invalid choice: '${group}'` };
  }
  const single = own.find((command) => command.words.length === 1);
  if (single !== undefined) return parseWords(single, words.slice(1));
  if (verb === undefined || isHelp(verb)) return { kind: 'help', text: groupHelp(group, own) };
  const command = own.find((each) => each.words[1] === verb);
  if (command === undefined)
    return {
      kind: 'wrong',
      text: `usage: ros2 ${group} [-h] <command> ...\nros2 ${group}: error: invalid choice: '${verb}' (choose from ${
        own.map(({ words: [, name] }) => `'${name}'`).join(', ')
      })`,
    };
  return parseWords(command, words.slice(2));
}

function isHelp(word: string): boolean {
  return word === '-h' || word === '--help';
}

function parseWords(command: Command, words: readonly string[]): Parsed {
  const positionals: string[] = [];
  const options = new Map<string, string>();
  const wrong = (what: string): Parsed => ({ kind: 'wrong', text: `${usage(command)}\nros2 ${command.words.join(' ')}: error: ${what}` });
  let onlyPositionals = false;
  for (let i = 0; i < words.length; i += 1) {
    const word = words[i]!;
    if (command.positionals[positionals.length]?.rest === true) {
      positionals.push(...words.slice(i));
      break;
    }
    // A number below zero is a value, and a lone dash too.
    if (onlyPositionals || !/^-[^\d.]|^-\d$/.test(word) || (/^-\d$/.test(word) && findOption(command, word) === undefined)) {
      positionals.push(word);
      continue;
    }
    if (word === '--') {
      onlyPositionals = true;
      continue;
    }
    if (isHelp(word)) return { kind: 'help', text: commandHelp(command) };
    // `-rf` may be an option of that name.
    const cut = word.startsWith('--') ? word.indexOf('=') : word.length > 2 && findOption(command, word) === undefined ? 2 : -1;
    const name = cut < 0 ? word : word.slice(0, cut);
    const attached = cut < 0 ? undefined : word.slice(word.startsWith('--') ? cut + 1 : cut);
    const option = findOption(command, name);
    if (option === undefined) return wrong(`unrecognized arguments: ${word}`);
    const names = option.names.join('/');
    if (option.value === undefined) {
      if (attached !== undefined) return wrong(`argument ${names}: ignored explicit argument '${attached}'`);
      options.set(keyOf(option), '');
      continue;
    }
    const isNext = (): boolean => i + 1 < words.length && !/^-[^\d.]/.test(words[i + 1]!);
    const value = attached ?? (option.alone !== undefined && !isNext() ? option.alone : isNext() || option.many !== true ? words[++i] : undefined);
    if (value !== undefined && option.many === true) {
      const all = [value];
      while (isNext()) all.push(words[++i]!);
      options.set(keyOf(option), all.join(' '));
      continue;
    }
    if (value === undefined) return wrong(`argument ${names}: expected ${option.many === true ? 'at least one argument' : 'one argument'}`);
    if (option.choices?.includes(value) === false) {
      return wrong(`argument ${names}: invalid choice: '${value}' (choose from ${option.choices.map((each) => `'${each}'`).join(', ')})`);
    }
    if (option.number === true && !(Number(value) > 0)) return wrong(`argument ${names}: '${value}' is not a number above 0`);
    const before = option.repeated === true ? options.get(keyOf(option)) : undefined;
    options.set(keyOf(option), before === undefined ? value : `${before}\n${value}`);
  }
  const wanted = command.positionals.filter(({ optional, rest }) => optional !== true && rest !== true);
  if (positionals.length < wanted.length) {
    return wrong(`the following arguments are required: ${wanted.slice(positionals.length).map(({ name }) => name).join(', ')}`);
  }
  const last = command.positionals.at(-1);
  if (positionals.length > command.positionals.length && last?.many !== true && last?.rest !== true) {
    return wrong(`unrecognized arguments: ${positionals.slice(command.positionals.length).join(' ')}`);
  }
  return { kind: 'run', command, given: { positionals, options } };
}

export function findOption(command: Command, name: string): Option | undefined {
  return command.options.find(({ names }) => names.includes(name));
}

/** Under which an option stands in Given. */
export function keyOf(option: Option): string {
  return option.names[0]!.replace(/^-+/, '');
}

function valueOf({ value, many, alone }: Option): string {
  if (value === undefined) return '';
  return alone === undefined ? ` ${value}${many === true ? ` [${value} ...]` : ''}` : ` [${value}]`;
}

function usage(command: Command): string {
  const options = command.options.map((option) => `[${option.names[0]}${valueOf(option)}]`);
  const positionals = command.positionals.map(({ name, optional, many, rest }) =>
    rest === true ? '...' : many === true ? `[${name} ...]` : optional === true ? `[${name}]` : name
  );
  return ['usage: ros2', ...command.words, '[-h]', ...options, ...positionals].join(' ');
}

function commandHelp(command: Command): string {
  const rows = command.options.map((option) => `  ${`${option.names.join(', ')}${valueOf(option)}`.padEnd(30)} ${option.help}`);
  return [usage(command), '', command.help, ...(rows.length === 0 ? [] : ['', 'options:', ...rows])].join('\n');
}

function groupHelp(group: string, own: readonly Command[]): string {
  const rows = own.map(({ words: [, verb], help }) => `  ${(verb ?? '').padEnd(12)} ${help}`);
  return [`usage: ros2 ${group} [-h] <command> ...`, '', 'Commands:', ...rows].join('\n');
}

const overviewUsage = 'usage: ros2 [-h] <command> ...';

function overview(table: readonly Command[]): string {
  const groups = [...new Set(table.map(({ words }) => words[0]))];
  const rows = groups.map((group) => {
    const verbs = table.filter(({ words }) => words[0] === group).flatMap(({ words: [, verb] }) => verb === undefined ? [] : [verb]);
    return `  ${group.padEnd(12)} ${verbs.join(', ')}`;
  });
  return [overviewUsage, '', 'Commands:', ...rows, '', '  Call `ros2 <command> -h` for more detailed usage.'].join('\n');
}
