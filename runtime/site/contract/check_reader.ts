// Checks the checks and the tasks of site.json.

import type { CheckAim, Comparison, SiteCheck } from './site_checks.ts';
import type { SiteTask, TaskCheck } from './site_tasks.ts';
import { fail, type Json, list, number, object, readSource, text } from './site_values.ts';

/** The manifest's reader took it; so does JavaScript. */
function pattern(json: Json, key: string, what: string): string {
  const value = text(json, key, what);
  try {
    new RegExp(value, 'u');
  } catch {
    fail(`${what}.${key} is not a regular expression: ${value}`);
  }
  return value;
}

function readBounds(json: Json, what: string): { above?: number; below?: number; } {
  return {
    ...(json['above'] === undefined ? {} : { above: number(json, 'above', what) }),
    ...(json['below'] === undefined ? {} : { below: number(json, 'below', what) }),
  };
}

function readComparison(json: Json, what: string): Comparison {
  const { equals } = json;
  if (!['boolean', 'number', 'string', 'undefined'].includes(typeof equals)) fail(`${what}.equals is not a plain value`);
  return {
    ...readBounds(json, what),
    ...(equals === undefined ? {} : { equals: equals as boolean | number | string }),
    ...(json['matches'] === undefined ? {} : { matches: pattern(json, 'matches', what) }),
  };
}

function readAim(json: Json, what: string): CheckAim {
  const kind = text(json, 'kind', what);
  switch (kind) {
    case 'rate':
      return { kind, topic: text(json, 'topic', what), ...readBounds(json, what) };
    case 'message':
      return { kind, topic: text(json, 'topic', what), field: text(json, 'field', what), value: readComparison(json, what) };
    case 'log':
      return { kind, log: pattern(json, 'log', what), ...(json['node'] === undefined ? {} : { node: text(json, 'node', what) }) };
    case 'parameter':
      return { kind, node: text(json, 'node', what), parameter: text(json, 'parameter', what), value: readComparison(json, what) };
    case 'state': {
      const state = text(json, 'state', what);
      if (state !== 'running' && state !== 'exited' && state !== 'crashed') fail(`${what}.state is ${state}`);
      return { kind, node: text(json, 'node', what), state };
    }
    case 'exit_code':
      return { kind, node: text(json, 'node', what), exitCode: number(json, 'exit_code', what) };
    default:
      return fail(`${what}.kind is ${kind}, which is not known here`);
  }
}

/** `ids`: of the site's nodes. */
export function readCheck(value: unknown, what: string, ids: ReadonlySet<string>): SiteCheck {
  return { ...readTaskCheck(value, what, ids), withinMs: number(object(value, what), 'within_ms', what) };
}

export function readTask(value: unknown, what: string, ids: ReadonlySet<string>): SiteTask {
  const json = object(value, what);
  const checks = list(json, 'checks', what, (item, where) => readTaskCheck(item, where, ids));
  if (checks.length === 0) fail(`${what} has no checks`);
  return {
    title: text(json, 'title', what),
    text: text(json, 'text', what, ''),
    hint: text(json, 'hint', what, ''),
    solution: text(json, 'solution', what, ''),
    checks,
  };
}

function readTaskCheck(value: unknown, what: string, ids: ReadonlySet<string>): TaskCheck {
  const json = object(value, what);
  const aim = readAim(json, what);
  if (aim.kind !== 'parameter' && 'node' in aim && aim.node !== undefined && !ids.has(aim.node)) {
    fail(`${what}.node is ${aim.node}, which is none of the site`);
  }
  const source = readSource(json);
  return {
    title: text(json, 'title', what, ''),
    aim,
    ...(source === undefined ? {} : { source }),
  };
}
