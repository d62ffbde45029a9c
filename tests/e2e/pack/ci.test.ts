// CI of a workspace: the workflows that `ros2wasm init --ci` writes, and the budget of a site.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { parse } from 'yaml';
import { CLI, type Finished, PackWorkspace, finished } from '../support/pack_workspace.ts';

const watchdog = { timeout: 600_000 };
const tools = mkdtempSync(join(tmpdir(), 'ros2wasm-ci-'));
let ws: PackWorkspace;

interface Step {
  readonly name?: string;
  readonly run?: string;
  readonly uses?: string;
  readonly with?: Readonly<Record<string, unknown>>;
}
interface GithubJob {
  readonly steps: readonly Step[];
  readonly needs?: string;
  readonly permissions?: Readonly<Record<string, string>>;
}
interface GithubWorkflow {
  readonly on: Readonly<Record<string, unknown>>;
  readonly permissions: Readonly<Record<string, string>>;
  readonly env: Readonly<Record<string, string>>;
  readonly jobs: Readonly<Record<string, GithubJob>>;
}
interface GitlabJob {
  readonly stage: string;
  readonly before_script?: readonly string[];
  readonly script: readonly string[];
  readonly artifacts: { readonly paths: readonly string[]; readonly reports?: { readonly junit: string; }; };
}
interface GitlabPipeline {
  readonly stages: readonly string[];
  readonly variables: Readonly<Record<string, string>>;
  readonly pack: GitlabJob;
  readonly pages: GitlabJob;
}

before(async () => {
  ws = new PackWorkspace();
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  manifest('');
  const packed = await ws.run(['lock']);
  assert.equal(packed.code, 0, packed.stderr);
});

after(() => {
  ws.close();
  rmSync(tools, { recursive: true });
});

function manifest(more: string): void {
  ws.write('workspace.yaml', `schema: 1
name: lab
packages: [src/*]
launch:
  - {package: quick, executable: hello}
checks:
  - {node: hello, log: '^hello$', within: 60 s}
${more}`);
}

/** A command of a workflow, by the shell and with the flags that both hosts use. */
function shell(command: string, environment: Readonly<Record<string, string>>): Promise<Finished> {
  return finished(spawn('bash', ['--noprofile', '--norc', '-eo', 'pipefail', '-c', command], {
    cwd: ws.root,
    env: {
      ...process.env,
      XDG_CACHE_HOME: join(ws.root, 'cache'),
      PATH: `${dirname(CLI)}${delimiter}${process.env['PATH'] ?? ''}`,
      ...environment,
    },
    stdio: ['ignore', 'pipe', 'pipe'],
  }));
}

async function expectPlayed(commands: readonly string[], environment: Readonly<Record<string, string>>): Promise<void> {
  assert.equal(commands.length, 2);
  for (const command of commands) {
    const { code, stderr } = await shell(command, environment);
    assert.equal(code, 0, `${command}\n${stderr}`);
  }
  assert.ok(existsSync(join(ws.root, 'site/site.json')));
  assert.match(ws.read('checks.xml').toString(), /<testsuites? [^>]*tests="1"[^>]*failures="0"/);
  rmSync(join(ws.root, 'site'), { recursive: true });
  rmSync(join(ws.root, 'checks.xml'));
}

type Parse = (file: { readonly name: string; readonly content: string; }, trace: unknown) => {
  readonly context: { readonly errors: { readonly getErrors: () => readonly { readonly message: string; }[]; }; };
};
interface Parser {
  readonly parseWorkflow: Parse;
  readonly parseAction: Parse;
  readonly NoOperationTraceWriter: new() => unknown;
}

/** GitHub's own reader of workflows, or of actions; its files are made for bundlers. */
async function githubFaults(what: 'parseWorkflow' | 'parseAction'): Promise<(content: string) => readonly string[]> {
  const outfile = join(tools, 'workflow_parser.cjs');
  await build({
    stdin: {
      contents:
        "export { parseWorkflow, NoOperationTraceWriter } from '@actions/workflow-parser'; export { parseAction } from '@actions/workflow-parser/actions/action-parser';",
      resolveDir: import.meta.dirname,
    },
    bundle: true,
    format: 'cjs',
    platform: 'node',
    outfile,
    logLevel: 'error',
  });
  const parser = await import(pathToFileURL(outfile).href) as Parser;
  return (content) => parser[what]({ name: 'ros2wasm.yml', content }, new parser.NoOperationTraceWriter()).context.errors.getErrors().map((e) => e.message);
}

// Guarantee, ci: `ros2wasm init --ci github` writes a workflow that GitHub's own reader takes, with actions named by their full
// sha and rights for publishing only where it publishes; its commands pack and play the checks
test('the workflow for GitHub', watchdog, async () => {
  const made = await ws.run(['init', '--ci', 'github']);
  assert.equal(made.code, 0, made.stderr);
  assert.equal(made.stdout, '.github/workflows/ros2wasm.yml\n');
  const text = ws.read('.github/workflows/ros2wasm.yml').toString();
  const faults = await githubFaults('parseWorkflow');
  assert.deepEqual(faults(text), []);
  assert.notDeepEqual(faults(text.replace('runs-on:', 'run-on:')), [], 'the reader does read');
  const workflow = parse(text) as GithubWorkflow;
  assert.deepEqual(Object.keys(workflow.on), ['push', 'pull_request']);
  assert.deepEqual(workflow.permissions, { contents: 'read' });
  const { pack, publish } = workflow.jobs;
  assert.ok(pack && publish);
  assert.equal(pack.permissions, undefined);
  assert.deepEqual(publish.permissions, { 'pages': 'write', 'id-token': 'write' });
  assert.equal(publish.needs, 'pack');
  for (const { uses } of [...pack.steps, ...publish.steps].filter((step) => step.uses !== undefined))
    assert.match(uses ?? '', /^actions\/[a-z-]+@[0-9a-f]{40}$/);
  const kept = pack.steps.find((step) => step.uses?.startsWith('actions/upload-artifact@'));
  assert.equal(kept?.with?.['path'], 'site\nchecks.xml\n');
  const published = pack.steps.find((step) => step.uses?.startsWith('actions/upload-pages-artifact@'));
  assert.equal(published?.with?.['path'], 'site');
  const runs = pack.steps.flatMap(({ run }) => (run === undefined ? [] : [run]));
  // A repository without its variables is told which.
  const bare = await shell(runs[0] ?? '', { ROS2WASM_PACKAGE: '', ROS2WASM_SHA256: '' });
  assert.notEqual(bare.code, 0);
  assert.match(bare.stderr, /ROS2WASM_PACKAGE: set this variable/);
  await expectPlayed(runs.slice(1), workflow.env);
});

interface Action {
  readonly inputs: Readonly<Record<string, { readonly required?: boolean; readonly default?: string; }>>;
  readonly outputs: Readonly<Record<string, { readonly value: string; }>>;
  readonly runs: {
    readonly using: string;
    readonly steps: readonly (Step & { readonly id?: string; readonly shell?: string; readonly env: Readonly<Record<string, string>>; })[];
  };
}

// Guarantee, ci: the repository is an action for GitHub (`action.yml`), as GitHub's own reader takes it, that installs a package with its sha256 only, packs, plays
// the checks and tells the hash of the site; no input becomes part of a command
test('the action', watchdog, async () => {
  const text = readFileSync(resolve('action.yml'), 'utf8');
  const faults = await githubFaults('parseAction');
  assert.deepEqual(faults(text), []);
  assert.notDeepEqual(faults(text.replace('using:', 'use:')), [], 'the reader does read');
  const action = parse(text) as Action;
  assert.equal(action.runs.using, 'composite');
  const output = join(ws.root, 'output of a step');
  const given: Readonly<Record<string, string>> = {
    package: pathToFileURL(join(ws.root, 'workspace.yaml')).href,
    sha256: '0'.repeat(64),
    site: 'a "site"',
  };
  const filled = (value: string): string =>
    value.replace(/\$\{\{ inputs\.(\w+) \}\}/g, (_, name: string) => {
      const input = action.inputs[name];
      assert.ok(input, name);
      return given[name] ?? input.default ?? '';
    });
  const play = (step: Action['runs']['steps'][number]): Promise<Finished> => {
    assert.equal(step.shell, 'bash');
    assert.doesNotMatch(step.run ?? '', /\$\{\{/, 'what somebody gives is data');
    const environment = Object.fromEntries(Object.entries(step.env).map(([name, value]) => [name, filled(value)]));
    return shell(step.run ?? '', { ...environment, GITHUB_OUTPUT: output });
  };
  const [install, pack, check, ...more] = action.runs.steps;
  assert.ok(install && pack && check && more.length === 0);
  const refused = await play(install);
  assert.notEqual(refused.code, 0, 'nothing is installed with another sha256');
  assert.match(refused.stdout + refused.stderr, /FAILED/);
  for (const step of [pack, check]) {
    const { code, stderr } = await play(step);
    assert.equal(code, 0, stderr);
  }
  assert.match(ws.read('checks.xml').toString(), /tests="1"[^>]*failures="0"/);
  const told = /^sha256=([0-9a-f]{64})$/m.exec(readFileSync(output, 'utf8'))?.[1] ?? '';
  assert.equal((await ws.run(['verify', 'a "site"', '--hash', told])).code, 0);
  assert.equal(action.outputs['sha256']?.value, ['${{ steps.', '.outputs.sha256 }}'].join(pack.id));
});

// Guarantee, ci: `ros2wasm init --ci gitlab` writes a pipeline with a report of the checks and a job for Pages; its commands pack
// and play the checks
test('the pipeline for GitLab', watchdog, async () => {
  const made = await ws.run(['init', '--ci', 'gitlab', '.']);
  assert.equal(made.code, 0, made.stderr);
  const pipeline = parse(ws.read('.gitlab-ci.yml').toString()) as GitlabPipeline;
  const { pack, pages } = pipeline;
  assert.deepEqual(pipeline.stages, [pack.stage, pages.stage]);
  assert.equal(pack.artifacts.reports?.junit, 'checks.xml');
  assert.deepEqual(pages.artifacts.paths, ['public']);
  const other = await shell(pack.before_script?.[0] ?? '', {
    ROS2WASM_PACKAGE: pathToFileURL(join(ws.root, 'workspace.yaml')).href,
    ROS2WASM_SHA256: '0'.repeat(64),
  });
  assert.notEqual(other.code, 0, 'nothing is installed with another sha256');
  assert.match(other.stdout + other.stderr, /FAILED/);
  await expectPlayed(pack.script, pipeline.variables);
});

test('a workflow of the user stays, and what the commands would miss is told', watchdog, async () => {
  ws.write('repo/.gitlab-ci.yml', 'mine: 1\n');
  const refused = await ws.run(['init', '--ci', 'gitlab', 'repo']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0630\]: `repo\/\.gitlab-ci\.yml` exists already/);
  assert.equal(ws.read('repo/.gitlab-ci.yml').toString(), 'mine: 1\n');
  const other = await ws.run(['init', '--ci', 'github', 'repo']);
  assert.equal(other.code, 0, other.stderr);
  assert.match(other.stderr, /there is no repo\/workspace\.yaml: change WORKSPACE/);
  const unknown = await ws.run(['init', '--ci', 'jenkins']);
  assert.equal(unknown.code, 2);
  assert.match(unknown.stderr, /error\[R2W0902\]: there is no workflow for `jenkins`; there are those for github, gitlab/);
});

// Guarantee, ci: a site over `site: budget:` fails the pack with a table of what grew, against the sizes beside the lock; the old
// site and the sizes stay
test('the budget of a site', watchdog, async () => {
  manifest('site: {budget: {total: 900 MB, compressed: 900 MB}}\n');
  const first = await ws.run(['pack', '-o', 'small']);
  assert.equal(first.code, 0, first.stderr);
  const sizes = ws.read('ros2wasm.sizes').toString();
  const was = Number(/^package quick: (\d+)$/m.exec(sizes)?.[1]);
  assert.ok(was > 0, sizes);
  const total = sizes.split('\n').reduce((sum, line) => sum + Number(/^[^#].*: (\d+)$/.exec(line)?.[1] ?? 0), 0);
  const site = ws.files('small');

  ws.write('src/quick/src/hello.cpp', '#include <iostream>\nint main() { std::cout << "hello" << std::endl; }\n');
  manifest(`site: {budget: ${total} B}\n`.replace(/(\d+) B/, (_, bytes: string) => `${Math.floor(Number(bytes) / 1000)}.${bytes.slice(-3)} kB`));
  const over = await ws.run(['pack', '-o', 'small']);
  assert.equal(over.code, 1, over.stderr);
  const row = new RegExp(`= why: what grew since ros2wasm.sizes was written, in bytes \\(was, is\\):\\n +${was} +(\\d+) +\\+(\\d+) {2}package quick`).exec(
    over.stderr,
  );
  assert.ok(row, over.stderr);
  assert.match(over.stderr, /error\[R2W0660\]: the site has [\d.]+ MB, [\d.]+ kB more than its budget\n +--> workspace\.yaml:8:/);
  assert.equal(Number(row[1]) - was, Number(row[2]));
  assert.deepEqual(ws.files('small'), site);
  assert.equal(ws.read('ros2wasm.sizes').toString(), sizes);
  const plan = await ws.run(['pack', '--plan']);
  assert.equal(plan.code, 0, plan.stderr);

  // As CI packs: within the budget too, the file stays as it was committed.
  manifest('site: {budget: 900 MB}\n');
  const locked = await ws.run(['pack', '--locked', '-o', 'small']);
  assert.equal(locked.code, 0, locked.stderr);
  assert.equal(ws.read('ros2wasm.sizes').toString(), sizes);
  const again = await ws.run(['pack', '-o', 'small']);
  assert.equal(again.code, 0, again.stderr);
  assert.match(ws.read('ros2wasm.sizes').toString(), new RegExp(`^package quick: ${row[1]}$`, 'm'));
});
