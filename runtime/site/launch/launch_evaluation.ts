// Evaluates the site's launch file with the visitor's launch arguments: runs launch_evaluator.wasm, the same code that
// packed the site, and fetches the files that the arguments lead to. Parts that only Python can decide are evaluated in Python
// again where the site has it (launch_worker.ts). Nothing of it is loaded without such arguments.

import { type Evaluate, openEvaluator } from './launch_evaluator.ts';
import { askWithPython } from '../workers/launch_worker.ts';
import type { Platform } from '../workers/platform.ts';
import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import type { LaunchView, SiteDescription } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { readArguments, readNodes, readSteps } from '../contract/site_reader.ts';

type Json = Readonly<Record<string, unknown>>;
/** Each turn fetches what the one before found missing: an include in an include in an include. */
const mostTurns = 200;
const shared = 'share/';

function textsOf(value: unknown): readonly string[] {
  return Array.isArray(value) ? value.filter((item): item is string => typeof item === 'string') : [];
}

function listOf(value: unknown): readonly Json[] {
  return Array.isArray(value) ? value.filter((item): item is Json => typeof item === 'object' && item !== null) : [];
}

function textOf(json: Json, key: string): string {
  const value = json[key];
  return typeof value === 'string' ? value : '';
}

/** The first of the evaluator's findings, whose codes are those of the command line; the others are further reasons. */
function refusal(errors: readonly Json[]): SiteError {
  const [first = {}, ...more] = errors;
  const source = first['source'] as Json | undefined;
  const place = source === undefined ? undefined : `${textOf(source, 'file')}:${String(source['line'])}:${String(source['column'])}`;
  return new SiteError(textOf(first, 'code') as DiagnosticCode, textOf(first, 'message'), {
    why: [...textsOf(first['why']), ...more.map((one) => textOf(one, 'message'))],
    fix: [...textsOf(first['fix']), 'correct the launch arguments, or leave them out to start the site as it was made'],
    ...(place === undefined ? {} : { place }),
  });
}

/** The question for the evaluator, besides launch.json and files. */
interface LaunchQuestion {
  readonly given: Readonly<Record<string, string>>;
  readonly describe?: boolean;
}

/** A part of a JSON object. */
function restOf(question: LaunchQuestion, available: readonly string[]): string {
  return JSON.stringify({ ...question, shared: available }).slice(1);
}

/** Throws what the evaluator refuses. */
export async function evaluateLaunch(...asked: Parameters<typeof askEvaluator>): Promise<Json> {
  return accepted(await askEvaluator(...asked));
}

function accepted(answer: Json): Json {
  const errors = listOf(answer['errors']);
  if (errors.length > 0) throw refusal(errors);
  return answer;
}

/** Asks, and fetches what is missing, until there is an answer. `launch`: the text of launch.json. */
async function askEvaluator(
  evaluate: Evaluate,
  launch: string,
  question: LaunchQuestion,
  available: readonly string[],
  fetchText: (path: string) => Promise<string>,
): Promise<Json> {
  const files: Record<string, string> = {};
  const rest = restOf(question, available);
  for (let turn = 0; turn < mostTurns; turn += 1) {
    const answer = evaluate(`{"launch":${launch},"files":${JSON.stringify(files)},${rest}`) as Json;
    const needs = textsOf(answer['needs']).filter((path) => files[path] === undefined);
    if (needs.length === 0) return answer;
    const texts = await Promise.all(needs.map(fetchText));
    needs.forEach((path, i) => {
      files[path] = texts[i] ?? '';
    });
  }
  throw new SiteError('R2W0733', `the launch file asks for more and more files: ${Object.keys(files).length} so far`);
}

/**
 * The site as it is with these launch arguments. Throws SiteError R2W0730 when its launch file has none, R2W0731 to R2W0733,
 * and what is wrong with the launch file by the codes that `pack` has for it.
 */
export async function siteWithArguments(
  site: SiteDescription,
  given: ReadonlyMap<string, string>,
  platform: Platform,
): Promise<SiteDescription> {
  if (given.size === 0) return site;
  const { launch } = site;
  if (launch === undefined) {
    throw new SiteError('R2W0730', `this site has no launch argument \`${[...given.keys()].join('`, `')}\``, {
      why: 'its manifest names no launch file that declares one',
      fix: 'leave the launch arguments out',
    });
  }
  const text = async (path: string): Promise<string> => new TextDecoder().decode(await platform.bytes(path));
  const [module, data] = await Promise.all([platform.compile(launch.evaluator), text(launch.data)]);
  const available = site.files.map(({ path }) => path).filter((path) => path.startsWith(shared));
  const question = { given: Object.fromEntries(given) };
  const packed = await askEvaluator(await openEvaluator(module), data, question, available, text);
  // Python would answer the same again for the values that it had when the site was packed, so it runs for other values only.
  const reran = packed['decided'] === true && launch.python?.program !== undefined;
  const answer = accepted(reran ? (await askWithPython(site, launch, data, restOf(question, available), platform)) as Json : packed);
  const nodes = readNodes(answer);
  const ids = new Set(nodes.map(({ id }) => id));
  // A check of a node that does not run with these arguments has nothing to look at.
  const checks = site.checks.filter(({ aim }) => {
    const id = 'node' in aim && aim.kind !== 'parameter' ? aim.node : undefined;
    return id === undefined || ids.has(id);
  });
  const without = site.checks.length - checks.length;
  const packedWith = new Map(launch.arguments.map(({ name, packed }) => [name, packed]));
  const view: LaunchView = {
    ...launch,
    arguments: readArguments(answer, 'arguments').map((one) => {
      const packed = packedWith.get(one.name) ?? one.default;
      return packed === undefined ? one : { ...one, packed };
    }),
    notes: [...(without === 0 ? [] : [`${without} of ${site.checks.length} checks are skipped: their nodes do not run`]),
      ...listOf(answer['warnings']).map((one) => textOf(one, 'message')), ...textsOf(answer['remarks'])],
    decided: answer['decided'] === true,
    reran,
  };
  return { ...site, nodes, launchSteps: readSteps(answer, ids), checks, launch: view };
}
