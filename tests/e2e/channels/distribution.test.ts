// `distribution:` of a manifest's sources: packages that nothing else has come from the release repositories that a distribution
// file names, by one line in the manifest.
import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { git, type GitServer, serveGit } from '../../support/git_server.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 240_000 };
/** Python packages that need each other in a row. */
const COUNT = 9;

let ws: PackWorkspace;
let repositories: GitServer;
let host: Server;
let address = '';
let asked = 0;

const packageXml = (name: string, type: string, depends: string): string =>
  `<package format="3">
  <name>${name}</name><version>1.0.0</version><description>Part of a lab</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>MIT</license>
  ${depends}<export><build_type>${type}</build_type></export>
</package>
`;

/** A release repository has the sources of one package below each tag. */
function release(repository: string, name: string, files: Readonly<Record<string, string>>): void {
  const folder = join(ws.root, 'git', repository);
  ws.write(`git/${repository}/README`, '');
  git(folder, 'init', '--quiet');
  git(folder, 'checkout', '--quiet', '--orphan', `work_${name}`);
  git(folder, 'rm', '-r', '--quiet', '--force', '--ignore-unmatch', '.');
  for (const [path, text] of Object.entries(files)) ws.write(`git/${repository}/${path}`, text);
  git(folder, 'add', '--all');
  git(folder, 'commit', '--quiet', '--message', name);
  git(folder, 'tag', `release/jazzy/${name}/1.0.0-1`);
}

function releasePython(repository: string, name: string, text: string, depends: string): void {
  release(repository, name, {
    'package.xml': packageXml(name, 'ament_python', depends),
    'setup.py': `from setuptools import setup\nsetup(name='${name}', version='1.0.0', packages=['${name}'])\n`,
    'setup.cfg': `[develop]\nscript_dir=$base/lib/${name}\n[install]\ninstall_scripts=$base/lib/${name}\n`,
    [`${name}/__init__.py`]: text,
  });
}

function distribution(version: string): string {
  const entry = (repository: string, names: readonly string[]): string =>
    `  ${repository}:
    doc: {type: git, url: "https://example.org/${repository}.git", version: main}
    release:
      packages: [${names.join(', ')}]
      tags: {release: "release/jazzy/{package}/{version}"}
      url: ${repositories.address}/${repository}
      version: ${version}
`;
  const words = [...Array(COUNT).keys()].map((i) => `word_${i}`);
  return `%YAML 1.1
# ROS distribution file
---
release_platforms: {ubuntu: [noble]}
repositories:
${entry('words', words)}${entry('shapes', ['shapes'])}${entry('gone', ['gone_package'])}  only_sources:
    source: {type: git, url: "https://example.org/only_sources.git", version: main}
type: distribution
version: 2
`;
}

async function succeeds(...words: readonly string[]): Promise<string> {
  const { code, stdout, stderr } = await ws.run(words);
  assert.equal(code, 0, stderr);
  return stdout + stderr;
}

test('search names the sources of a distribution, by ROS name or by conda name', watchdog, async () => {
  ws.write('list.yaml', distribution('1.0.0-1'));
  const said = await succeeds('search', 'ros-jazzy-word-*', '--distribution', 'list.yaml');
  assert.equal(said.match(/^word_\d 1\.0\.0 source {2}http:/gm)?.length, COUNT);
  assert.match(await succeeds('search', 'shapes >=1', '--distribution', 'list.yaml'),
    /^shapes 1\.0\.0 source {2}\S+\/shapes release\/jazzy\/shapes\/1\.0\.0-1$/m);
  const none = await ws.run(['search', 'shapes >=2', '--distribution', 'list.yaml']);
  assert.equal(none.code, 1);
});

const manifest = (sources: string, more = ''): string =>
  `schema: 1
name: lab
packages: [src/*]
${sources}launch:
  - {package: lab, executable: speak}
  - {package: draw, executable: draw}
${more}`;

before(async () => {
  ws = new PackWorkspace();
  repositories = await serveGit(join(ws.root, 'git'));
  for (let i = 0; i < COUNT; i += 1) {
    const next = i + 1 < COUNT ? `word_${i + 1}` : undefined;
    const text = next === undefined ? 'NUMBER = 1\n' : `from ${next} import NUMBER as BEFORE\nNUMBER = BEFORE + 1\n`;
    releasePython('words', `word_${i}`, text, next === undefined ? '' : `<exec_depend>${next}</exec_depend>`);
  }
  release('shapes', 'shapes', {
    'package.xml': packageXml('shapes', 'ament_cmake', '<buildtool_depend>ament_cmake</buildtool_depend><exec_depend>rviz2</exec_depend>'),
    'CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(shapes)
find_package(ament_cmake REQUIRED)
add_library(shapes INTERFACE)
target_include_directories(shapes INTERFACE "$<BUILD_INTERFACE:\${CMAKE_CURRENT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:include>")
install(DIRECTORY include/ DESTINATION include)
install(TARGETS shapes EXPORT export_shapes)
ament_export_targets(export_shapes)
ament_package()
`,
    'include/shapes/corners.hpp': 'inline int corners() { return 4; }\n',
  });
  ws.addPythonPackage('lab', { speak: "from word_0 import NUMBER\n\n\ndef main():\n    print(f'{NUMBER} words', flush=True)\n" }, ['rclpy', 'word_0']);
  ws.addPackage('draw', { draw: '#include <cstdio>\n#include <shapes/corners.hpp>\nint main() { std::printf("%d corners\\n", corners()); }\n' }, {
    depends: ['shapes'],
    cmake: 'find_package(shapes REQUIRED)\ntarget_link_libraries(draw shapes::shapes)\n',
  });
  host = createServer((request, response) => {
    asked += 1;
    const text = distribution('1.0.0-1');
    const etag = `"${text.length}"`;
    response.setHeader('ETag', etag);
    response.statusCode = request.headers['if-none-match'] === etag ? 304 : 200;
    response.end(response.statusCode === 304 ? undefined : text);
  });
  await new Promise<void>((done) => {
    host.listen(0, '127.0.0.1', done);
  });
  address = `http://127.0.0.1:${(host.address() as AddressInfo).port}/jazzy/distribution.yaml`;
});
after(() => {
  host.closeAllConnections();
  host.close();
  repositories.close();
  ws.close();
});

test('without the line, what is missing is named, and the line is offered', watchdog, async () => {
  ws.write('workspace.yaml', manifest(''));
  const { code, stderr } = await ws.run(['pack', '-o', 'site']);
  assert.equal(code, 1);
  assert.match(stderr, /package `draw` is skipped: no channel has `shapes`, which it needs/);
  assert.match(stderr, /`sources:` names a git repository that has it or a distribution file that has released it/);
});

test('one line in the manifest brings all that is missing, locked by commits', watchdog, async () => {
  ws.write('workspace.yaml', manifest(`sources: [{distribution: "${address}"}]\n`));
  const said = await succeeds('pack', '-o', 'site');
  assert.match(said, /from word_0 release\/jazzy\/word_0\/1\.0\.0-1, commit \w{10}: word_0/);
  assert.doesNotMatch(said, /rviz2/);
  const lock = ws.read('ros2wasm.lock').toString();
  assert.equal(lock.match(/^ {4}package: /gm)?.length, COUNT + 1);
  assert.equal(asked, 1);
  assert.match(await succeeds('run', 'site', '--for', '20s', '--until', `${COUNT} words`), new RegExp(`${COUNT} words`));
  assert.match(await succeeds('run', 'site', '--for', '20s', '--until', 'corners'), /4 corners/);
});

test('with the lock nobody is asked, and all comes from the cache', watchdog, async () => {
  const files = ws.files('site');
  const requests = repositories.requests();
  await succeeds('pack', '-o', 'site', '--frozen', '--offline');
  await succeeds('pack', '-o', 'site', '--locked');
  assert.deepEqual(ws.files('site'), files);
  assert.equal(asked, 1);
  assert.equal(repositories.requests(), requests);
  assert.equal((await ws.run(['check'])).code, 0);
  rmSync(join(ws.cache, 'ros2wasm/sources'), { recursive: true });
  rmSync(join(ws.cache, 'ros2wasm/index'), { recursive: true });
  await succeeds('cache', 'fetch');
  // The list itself is not here now, and a name that neither it nor the lock has does not ask for it.
  ws.write('workspace.yaml', manifest(`dependencies: [no_such_package_here]\nsources: [{distribution: "${address}"}]\n`));
  assert.match((await ws.run(['pack', '-o', 'site', '--offline'])).stderr, /no_such_package_here/);
  ws.write('workspace.yaml', manifest(`sources: [{distribution: "${address}"}]\n`));
  await succeeds('pack', '-o', 'site', '--offline');
  assert.deepEqual(ws.files('site'), files);
});

test('a package whose tag is gone, and a file that is not a distribution, are named', watchdog, async () => {
  ws.write('ros/distribution.yaml', distribution('1.0.0-1'));
  ws.write('workspace.yaml', manifest('sources: [{distribution: ros/distribution.yaml, packages: [gone_package]}]\n'));
  const gone = await ws.run(['pack', '-o', 'site']);
  assert.match(gone.stderr, /error\[R2W0251\]: the git repository `http:\/\/127\.0\.0\.1:\d+\/gone` cannot be fetched/);
  ws.write('ros/distribution.yaml', distribution('2.0.0-1'));
  ws.write('workspace.yaml', manifest('sources: [{distribution: ros/distribution.yaml}]\n'));
  rmSync(join(ws.root, 'ros2wasm.lock'));
  const older = await ws.run(['pack', '-o', 'site']);
  assert.match(older.stderr,
    /error\[R2W0252\]: the git repository `.*\/words` has no revision `release\/jazzy\/word_0\/2\.0\.0-1`\n[^]*= fix: write `revision: release\/jazzy\/word_0\/1\.0\.0-1`/);
  ws.write('ros/distribution.yaml', 'repositories: []\n');
  const other = await ws.run(['pack', '-o', 'site']);
  assert.match(other.stderr, /error\[R2W0256\]: `ros\/distribution\.yaml` is not a distribution file that can be used/);
});
