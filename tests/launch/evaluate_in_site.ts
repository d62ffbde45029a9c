// Evaluates launch.json as a site does: node evaluate_in_site.ts EVALUATOR LAUNCH_JSON SHARED [NAME:=VALUE ...]
// SHARED: the folder that has the site's share/ in it. The output has the form of `ros2wasm launch --json`.

import { readdirSync, readFileSync, statSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';

import { readGiven } from '../../runtime/site/contract/launch_arguments.ts';
import { evaluateLaunch } from '../../runtime/site/launch/launch_evaluation.ts';
import { openEvaluator } from '../../runtime/site/launch/launch_evaluator.ts';

const [evaluator = '', data = '', folder = '', ...given] = process.argv.slice(2);

const shared = readdirSync(join(folder, 'share'), { recursive: true, encoding: 'utf8' })
  .map((path) => `share/${path}`)
  .filter((path) => statSync(join(folder, path)).isFile());

const evaluate = await openEvaluator(await WebAssembly.compile(readFileSync(evaluator)));
const question = { given: Object.fromEntries(readGiven(given)), describe: true };
const answer = await evaluateLaunch(evaluate, readFileSync(data, 'utf8'), question, shared, (path) => readFile(join(folder, path), 'utf8'));
process.stdout.write(`${JSON.stringify(answer['description'])}\n`);
