// Completion of a line that begins with `ros2`: from the table of commands, and what the graph has.

import { fileName } from '../contract/file_name.ts';
import { expandName, fullTypeName } from '../decode/ros_names.ts';
import type { GraphView, SiteDescription } from '../contract/session.ts';
import type { Command, Meaning } from './command.ts';
import { actionsOf, containersOf, servicesOf, shown, topicsOf } from './graph_lists.ts';
import { findOption, splitLine } from './parse.ts';
import { commands } from './table.ts';

export interface Completion {
  /** The beginning of the last word, and its place in the line. */
  readonly word: string;
  readonly start: number;
  /** Whole words, sorted. */
  readonly choices: readonly string[];
}

/** Values that only a node or the definitions can provide: the parameters of a node, a message of a type to begin with. */
export type Wanted =
  | { readonly kind: 'parameters'; readonly node: string; }
  | { readonly kind: 'prototype'; readonly type: string; };

export interface Known {
  readonly graph: GraphView;
  /** Names of interfaces that the site has. */
  readonly interfaces: readonly string[];
  /** The launch file that `ros2 launch` can start, and its arguments; of a site. */
  readonly launches?: Pick<SiteDescription, 'launchFile' | 'launch'>;
  /** The programs that `ros2 run` can start. */
  readonly programs: readonly { readonly package: string; readonly executable: string; }[];
  /** The answer to `wanted()`, once it is there. */
  readonly told?: readonly string[];
}

/** `line`: what stands before the caret. */
export function complete(line: string, known: Known): Completion {
  const start = /\S*$/.exec(line)!.index;
  const word = line.slice(start);
  const before = splitLine(line.slice(0, start)) ?? [];
  const offered = choices(before, word, known);
  return { word, start, choices: [...new Set(offered)].filter((choice) => choice.startsWith(word) && choice !== '').sort() };
}

/** The values that must be requested before this line can be completed; undefined: none. */
export function wanted(line: string): Wanted | undefined {
  const start = /\S*$/.exec(line)!.index;
  const before = splitLine(line.slice(0, start)) ?? [];
  const own = before[0] !== 'ros2' ? undefined : commands.find(({ words }) => words[0] === before[1] && (words.length === 1 || words[1] === before[2]));
  if (own === undefined || line.slice(start).startsWith('-')) return undefined;
  const begin = 1 + own.words.length;
  const option = before.length > begin ? findOption(own, before.at(-1)!) : undefined;
  if (option?.value !== undefined) return undefined;
  const given = positionalsOf(own, before.slice(begin));
  const [first = '', second = ''] = given;
  const prototype = (kind: 'msg' | 'srv' | 'action', suffix: string): Wanted | undefined => {
    const type = fullTypeName(second, kind);
    return type === undefined ? undefined : { kind: 'prototype', type: `${type}${suffix}` };
  };
  switch (own.positionals[given.length]?.meaning) {
    case 'parameter':
      return { kind: 'parameters', node: expandName(first, '') };
    case 'message_values':
      return prototype('msg', '');
    case 'service_values':
      return prototype('srv', '_Request');
    case 'goal_values':
      return prototype('action', '_Goal');
    default:
      return undefined;
  }
}

function choices(before: readonly string[], word: string, known: Known): readonly string[] {
  if (before.length === 0) return ['ros2'];
  if (before[0] !== 'ros2') return [];
  if (before.length === 1) return commands.map(({ words }) => words[0]);
  const [, group, verb] = before;
  const own = commands.filter(({ words }) => words[0] === group);
  const single = own.find(({ words }) => words.length === 1);
  if (single !== undefined) return ofCommand(single, before, 2, word, known);
  if (before.length === 2) return own.flatMap(({ words: [, name] }) => name === undefined ? [] : [name]);
  const command = own.find(({ words }) => words[1] === verb);
  return command === undefined ? [] : ofCommand(command, before, 3, word, known);
}

/** `begin`: where its own words begin. */
function ofCommand(command: Command, before: readonly string[], begin: number, word: string, known: Known): readonly string[] {
  const last = before.at(-1)!;
  const option = before.length > begin ? findOption(command, last) : undefined;
  if (option?.value !== undefined) return option.choices ?? [];
  if (word.startsWith('-')) return [...command.options.flatMap(({ names }) => names), '--help'];
  const given = positionalsOf(command, before.slice(begin));
  const final = command.positionals.at(-1);
  const next = command.positionals[given.length] ?? (final?.many === true ? final : undefined);
  return next === undefined ? [] : meant(next.meaning, given, known);
}

function positionalsOf(command: Command, words: readonly string[]): string[] {
  const found: string[] = [];
  for (let i = 0; i < words.length; i += 1) {
    const option = findOption(command, words[i]!);
    if (option === undefined) found.push(words[i]!);
    else if (option.value !== undefined) i += 1;
  }
  return found;
}

function meant(meaning: Meaning, given: readonly string[],
  { graph, interfaces, programs, launches: { launchFile, launch } = {}, told = [] }: Known): readonly string[]
{
  const ofKind = (kind: string): string[] => interfaces.filter((name) => name.split('/')[1] === kind);
  /** The type of what was named before, when it is known. */
  const typeOf = (list: readonly { readonly name: string; readonly types: readonly string[]; }[], all: readonly string[]): readonly string[] =>
    list.find(({ name }) => name === given[0])?.types ?? all;
  switch (meaning) {
    case 'topic':
      return shown(topicsOf(graph), false).map(({ name }) => name);
    case 'node':
      return shown(graph.nodes, false).map(({ name }) => name);
    case 'service':
      return shown(servicesOf(graph), false).map(({ name }) => name);
    case 'action':
      return actionsOf(graph).map(({ name }) => name);
    case 'message_type':
      return typeOf(topicsOf(graph), ofKind('msg'));
    case 'service_type':
      return typeOf(servicesOf(graph), ofKind('srv'));
    case 'action_type':
      return typeOf(actionsOf(graph), ofKind('action'));
    case 'interface':
      return interfaces;
    case 'package':
      return interfaces.map((name) => name.split('/')[0]!);
    case 'transition':
      return ['configure', 'activate', 'deactivate', 'cleanup', 'shutdown'];
    case 'program_package':
      return programs.map((program) => program.package);
    case 'executable':
      return programs.flatMap((program) => program.package === given[0] ? [program.executable] : []);
    case 'container':
      return containersOf(graph);
    case 'launch_package':
      return launchFile === undefined ? [] : [launchFile.package ?? launchFile.file];
    case 'launch_file':
      return launchFile !== undefined && launchFile.package === given[0] ? [fileName(launchFile.file)] : [];
    case 'launch_argument':
      return (launch?.arguments ?? []).map(({ name }) => `${name}:=`);
    case 'parameter':
    case 'message_values':
    case 'service_values':
    case 'goal_values':
      return told;
    case 'text':
      return [];
  }
}
