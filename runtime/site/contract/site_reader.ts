// Checks site.json: what comes from outside goes through here.

import { protocolVersion } from '../../protocol/generated/constants.ts';
import { readCheck, readTask } from './check_reader.ts';
import type { SiteNotebook } from './notebook.ts';
import { SiteError } from './site_error.ts';
import { type FilePart, placesOf, readStore, type SiteStore } from './site_places.ts';
import { fail, flag, type Json, list, number, object, path, readSource, text } from './site_values.ts';
import type {
  CommandNode,
  LaunchArgument,
  LaunchFile,
  LaunchMoment,
  LaunchPython,
  LaunchStep,
  LaunchView,
  LineTest,
  NodeMoment,
  PythonProgram,
  SiteAuthor,
  SiteCitation,
  SiteDescription,
  SiteFile,
  SiteNode,
  SiteProgram,
} from './session.ts';
import type { SiteSources } from './site_sources.ts';

function readPython(value: unknown, what: string): PythonProgram {
  const json = object(value, what);
  const archive = (item: unknown, where: string): string => path(typeof item === 'string' ? item : '', where);
  const entry = text(json, 'entry', what);
  // A module and a function of it, or a path.
  if (!entry.includes(':')) path(entry, `${what}.entry`);
  return { archives: list(json, 'archives', what, archive), ...readLibraries(json, what), entry };
}

function readLibraries(json: Json, what: string): { readonly libraries?: readonly string[]; } {
  if (json['libraries'] === undefined) return {};
  return { libraries: list(json, 'libraries', what, (item, where) => path(typeof item === 'string' ? item : '', where)) };
}

function readLineTest(value: unknown, what: string): LineTest {
  const json = object(value, what);
  const how = text(json, 'how', what);
  if (how !== 'contains' && how !== 'begins' && how !== 'ends' && how !== 'is') {
    return fail(`${what}.how is ${how}: it is contains, begins, ends or is`);
  }
  return { how, text: text(json, 'text', what), anyCase: flag(json, 'any_case'), holds: json['holds'] !== false };
}

function readMoment(value: unknown, what: string): LaunchMoment {
  const json = object(value, what);
  const event = text(json, 'event', what);
  const once = {
    ...(flag(json, 'once') ? { once: true } : {}),
    ...(json['handler'] === undefined ? {} : { handler: number(json, 'handler', what) }),
  };
  if (event === 'shutdown') return { event, ...once };
  if (event !== 'start' && event !== 'exit' && event !== 'transition' && event !== 'output') {
    return fail(`${what}.event is ${event}: it is start, exit, transition, output or shutdown`);
  }
  const node = text(json, 'node', what);
  if (event === 'output') {
    const stream = text(json, 'stream', what);
    if (stream !== 'stdout' && stream !== 'stderr') return fail(`${what}.stream is ${stream}: it is stdout or stderr`);
    return { event, node, stream, tests: json['tests'] === undefined ? [] : list(json, 'tests', what, readLineTest), ...once };
  }
  if (event !== 'transition') return { event, node, ...once };
  const part = (key: string, name: 'transition' | 'startState' | 'goalState'): object => (json[key] === undefined ? {} : { [name]: text(json, key, what) });
  return {
    event,
    node,
    name: text(json, 'name', what),
    ...part('transition', 'transition'),
    ...part('start_state', 'startState'),
    ...part('goal_state', 'goalState'),
    ...once,
  };
}

function readStartOn(value: unknown, what: string): NodeMoment {
  const moment = readMoment(value, what);
  return moment.event === 'shutdown' ? fail(`${what}.event is shutdown: nothing starts then`) : moment;
}

function readStep(value: unknown, what: string): LaunchStep {
  const json = object(value, what);
  const source = readSource(json);
  const at = {
    ...(json['on'] === undefined ? {} : { on: readMoment(json['on'], `${what}.on`) }),
    after: number(json, 'after', what, 0),
    ...(source === undefined ? {} : { source }),
  };
  const kind = text(json, 'do', what);
  switch (kind) {
    case 'log':
      return { do: kind, level: text(json, 'level', what), text: text(json, 'text', what), ...at };
    case 'shutdown':
      return { do: kind, reason: text(json, 'reason', what, ''), ...at };
    case 'end':
      return { do: kind, node: text(json, 'node', what), ...at };
    case 'transition': {
      const id = (item: unknown,
        where: string): number => (typeof item === 'number' && Number.isInteger(item) && item >= 0 && item < 256 ? item : fail(`${where} is not a transition`));
      return { do: kind, node: text(json, 'node', what), name: text(json, 'name', what), transitions: list(json, 'transitions', what, id), ...at };
    }
    default:
      return fail(`${what}.do is ${kind}: it is log, shutdown, end or transition`);
  }
}

function readProgram(value: unknown, what: string): SiteProgram {
  const json = object(value, what);
  const kind = text(json, 'kind', what, 'cpp');
  if (kind !== 'cpp' && kind !== 'python') fail(`${what}.kind is ${kind}: this runtime runs programs of kind cpp and python`);
  const names = text(json, 'names', what, '');
  return {
    package: text(json, 'package', what),
    executable: text(json, 'executable', what),
    kind,
    program: path(text(json, 'program', what), `${what}.program`),
    ...(names === '' ? {} : { names: path(names, `${what}.names`) }),
    ...(kind === 'python' ? { python: readPython(json['python'], `${what}.python`) } : {}),
    threads: flag(json, 'threads'),
  };
}

/** No program runs it. */
function readCommand(json: Json, what: string): Pick<CommandNode, 'kind' | 'package' | 'executable'> {
  return { kind: 'command', package: '', executable: text(json, 'executable', what) };
}

function readNode(value: unknown, what: string): SiteNode {
  const json = object(value, what);
  const environment = object(json['environment'] ?? {}, `${what}.environment`);
  const source = readSource(json);
  return {
    ...(json['kind'] === 'command' ? readCommand(json, what) : readProgram(json, what)),
    id: text(json, 'id', what),
    label: text(json, 'label', what, text(json, 'id', what)),
    arguments: list(json, 'arguments', what, (item) => (typeof item === 'string' ? item : fail(`${what}.arguments`))),
    environment: Object.fromEntries(Object.keys(environment).map((key) => [key, text(environment, key, what)])),
    output: text(json, 'output', what, 'screen'),
    respawn: flag(json, 'respawn'),
    respawnDelay: number(json, 'respawn_delay', what, 0),
    ...(json['respawn_max_retries'] === undefined ? {} : { respawnMaxRetries: number(json, 'respawn_max_retries', what) }),
    ...(json['start_on'] === undefined ? {} : { startOn: readStartOn(json['start_on'], `${what}.start_on`) }),
    startAfter: number(json, 'start_after', what, 0),
    shutdownOnExit: text(json, 'on_exit', what, '') === 'shutdown',
    ...(source === undefined ? {} : { source }),
  };
}

function readHash(json: Json, what: string): string {
  const hash = text(json, 'sha256', what);
  return /^[0-9a-f]{64}$/.test(hash) ? hash : fail(`${what}.sha256 is not a sha256`);
}

function readPart(value: unknown, what: string): FilePart {
  const json = object(value, what);
  return { size: number(json, 'size', what), sha256: readHash(json, what) };
}

function readFile(value: unknown, what: string, store: SiteStore | undefined): SiteFile {
  const json = object(value, what);
  const file = {
    path: path(text(json, 'path', what), what),
    size: number(json, 'size', what, 0),
    sha256: text(json, 'sha256', what, ''),
    reason: text(json, 'reason', what, ''),
  };
  if (json['kept'] === undefined && json['parts'] === undefined) return file;
  const kept = json['kept'] === undefined ? {} : { kept: text(json, 'kept', what) };
  const parts = json['parts'] === undefined ? {} : { parts: list(json, 'parts', what, readPart) };
  return { ...file, at: placesOf({ path: file.path, sha256: readHash(json, what), ...kept, ...parts }, store).map(({ at }) => at) };
}

/** In launch order, with ids of their own. `value`: has them as `nodes`. */
export function readNodes(value: unknown): readonly SiteNode[] {
  const nodes = list(object(value, 'the document'), 'nodes', 'site', readNode);
  const ids = new Set(nodes.map((node) => node.id));
  if (ids.size !== nodes.length) fail('two nodes have the same id');
  for (const { startOn } of nodes) {
    if (startOn !== undefined && !ids.has(startOn.node)) fail(`the launch speaks of ${startOn.node}, which is not a node of the site`);
  }
  return nodes;
}

/** `value`: has them as `steps`. `nodes`: the ids that they may speak of. */
export function readSteps(value: unknown, nodes: ReadonlySet<string>): readonly LaunchStep[] {
  const steps = list(object(value, 'site.launch'), 'steps', 'site.launch', readStep);
  for (const of of steps.flatMap((step) => [step.on?.node, step.do === 'transition' || step.do === 'end' ? step.node : undefined])) {
    if (of !== undefined && !nodes.has(of)) fail(`the launch speaks of ${of}, which is not a node of the site`);
  }
  return steps;
}

export function readArguments(value: unknown, what: string): readonly LaunchArgument[] {
  return list(object(value, what), 'arguments', what, (item, where) => {
    const json = object(item, where);
    return {
      name: text(json, 'name', where),
      value: text(json, 'value', where),
      ...(json['default'] === undefined ? {} : { default: text(json, 'default', where) }),
      description: text(json, 'description', where, ''),
      choices: list(json, 'choices', where, (choice) => (typeof choice === 'string' ? choice : fail(`${where}.choices`))),
    };
  });
}

function readLaunchPython(value: unknown): LaunchPython {
  const what = 'site.launch.python';
  const json = object(value, what);
  return {
    tried: list(json, 'tried', what, (item) => (typeof item === 'string' ? item : fail(`${what}.tried`))),
    ...(json['program'] === undefined ? {} : { program: path(text(json, 'program', what), `${what}.program`) }),
    archives: list(json, 'archives', what, (item) => path(typeof item === 'string' ? item : fail(`${what}.archives`), `${what}.archives`)),
  };
}

function readLaunch(value: unknown): LaunchView {
  const json = object(value, 'site.launch');
  return {
    data: path(text(json, 'data', 'site.launch'), 'site.launch.data'),
    evaluator: path(text(json, 'evaluator', 'site.launch'), 'site.launch.evaluator'),
    arguments: readArguments(json, 'site.launch').map((one) => ({ ...one, packed: one.value })),
    notes: [],
    decided: false,
    reran: false,
    ...(json['python'] === undefined ? {} : { python: readLaunchPython(json['python']) }),
  };
}

/** Sites of before launch files were named have none. */
function readLaunchFile(value: unknown): LaunchFile | undefined {
  const json = object(value, 'site.launch');
  if (json['file'] === undefined) return undefined;
  const file = text(json, 'file', 'site.launch');
  return json['package'] === undefined ? { file } : { file, package: text(json, 'package', 'site.launch') };
}

function readSources(value: unknown): SiteSources {
  const what = 'site.sources';
  const json = object(value, what);
  const files = list(json, 'files', what, (item, where) => {
    const one = object(item, where);
    return { path: path(text(one, 'path', where), where), file: text(one, 'file', where), sha256: text(one, 'sha256', where) };
  });
  return { archive: path(text(json, 'archive', what), what), files };
}

function readNotebook(value: unknown): SiteNotebook {
  const what = 'site.notebook';
  const json = object(value, what);
  const archive = (item: unknown, where: string): string => path(typeof item === 'string' ? item : '', where);
  return {
    file: path(text(json, 'file', what), `${what}.file`),
    program: path(text(json, 'program', what), `${what}.program`),
    archives: list(json, 'archives', what, archive),
    ...readLibraries(json, what),
  };
}

/** `family` and `given` are those of ros2wasm's own reading of `name`; a site made before them has the name only. */
function readAuthor(value: unknown, what: string): SiteAuthor {
  const json = object(value, what);
  const name = text(json, 'name', what, '');
  return { name, family: text(json, 'family', what, name), given: text(json, 'given', what, '') };
}

function readCitation(json: Readonly<Record<string, unknown>>): SiteCitation {
  return { date: text(json, 'date_released', 'site.citation'), doi: text(json, 'doi', 'site.citation', '') };
}

/** Throws SiteError: R2W0700 for a broken file, R2W0709 for another protocol. */
export function readSite(value: unknown): SiteDescription {
  const json = object(value, 'the document');
  if (number(json, 'schema', 'site') !== 1) fail(`schema ${String(json['schema'])} is not known here`);
  const protocol = number(json, 'protocol', 'site');
  if (protocol !== protocolVersion) {
    throw new SiteError('R2W0709', `the site speaks protocol ${protocol}, its runtime protocol ${protocolVersion}`, {
      why: 'site.json and the runtime files come of different versions of ros2wasm',
      fix: 'pack the workspace again and put the whole folder in place',
    });
  }
  const nodes = readNodes(json);
  const ids = new Set(nodes.map((node) => node.id));
  const launchSteps = readSteps(json['launch'] ?? {}, ids);
  const launchFile = readLaunchFile(json['launch'] ?? {});
  const interfaces = text(json, 'interfaces', 'site', '');
  const store = json['store'] === undefined ? undefined : readStore(json['store']) ?? fail('site.store is not a store of objects');
  return {
    protocol,
    generator: text(json, 'generator', 'site', ''),
    name: text(json, 'name', 'site', ''),
    title: text(json, 'title', 'site', ''),
    version: text(json, 'version', 'site', ''),
    distro: text(json, 'distro', 'site', ''),
    license: text(json, 'license', 'site', ''),
    authors: list(json, 'authors', 'site', readAuthor),
    ...(json['citation'] === undefined ? {} : { citation: readCitation(object(json['citation'], 'site.citation')) }),
    nodes,
    programs: list(json, 'programs', 'site', readProgram),
    launchSteps,
    ...(launchFile === undefined ? {} : { launchFile }),
    ...(json['launch_file'] === undefined ? {} : { launch: readLaunch(json['launch_file']) }),
    interfaces: interfaces === '' ? '' : path(interfaces, 'site.interfaces'),
    packages: list(json, 'packages', 'site', (item) => (typeof item === 'string' ? item : fail('site.packages'))),
    ...(json['sources'] === undefined ? {} : { sources: readSources(json['sources']) }),
    checks: list(json, 'checks', 'site', (item, what) => readCheck(item, what, ids)),
    tasks: list(json, 'tasks', 'site', (item, what) => readTask(item, what, ids)),
    ...(json['notebook'] === undefined ? {} : { notebook: readNotebook(json['notebook']) }),
    ui: object(json['ui'] ?? {}, 'site.ui'),
    embed: list(json, 'embed', 'site', (item) => (typeof item === 'string' ? item : fail('site.embed'))),
    files: list(json, 'files', 'site', (item, what) => readFile(item, what, store)),
    ...(store === undefined ? {} : { stored: true }),
  };
}
