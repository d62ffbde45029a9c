// A world that includes a model by its address on Gazebo Fuel, packed with a mirror of Fuel on this machine and without a network:
// the model and what it includes are locked, verified, in the site, and in the world that the simulator starts.

// Compatibility, works: models of Gazebo Fuel that worlds, models and launch files name by their address, also inside other such models,
// fetched when the site is packed

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';
import type { Finished } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };
const MODELS = 'https://fuel.gazebosim.org/1.0/Somebody/models';

const link = (inside: string): string => `<link name="link"><collision name="c">${inside}</collision><visual name="v">${inside}</visual></link>`;
const model = (name: string, inside: string): string => `<sdf version="1.6"><model name="${name}"><static>true</static>${inside}</model></sdf>\n`;
const config = (name: string): string => `<model><name>${name}</name><sdf version="1.6">model.sdf</sdf></model>\n`;

const launch = `<launch>
  <executable cmd="gzserver -s libgazebo_ros_init.so -s libgazebo_ros_factory.so $(find-pkg-share lab)/lab.world"/>
  <executable cmd="ros2 service call /get_model_list gazebo_msgs/srv/GetModelList {}"/>
</launch>
`;

let workspace: PackWorkspace;
let host: Server;
let port: number;
let requests: string[] = [];
/** By path: the bytes of archives. */
const archives = new Map<string, Buffer>();

function offer(name: string, version: string, files: Readonly<Record<string, string>>): void {
  const program = `import json, sys, zipfile
with zipfile.ZipFile(sys.argv[1], 'w', zipfile.ZIP_DEFLATED) as out:
    for path, text in json.loads(sys.argv[2]).items():
        out.writestr(zipfile.ZipInfo(path), text)
`;
  const file = join(workspace.root, 'model.zip');
  execFileSync('python3', ['-c', program, file, JSON.stringify(files)]);
  const bytes = readFileSync(file);
  archives.set(`/1.0/Somebody/models/${name}/${version}/${name}.zip`, bytes);
}

function manifest(simulation: string): void {
  workspace.write('workspace.yaml', `schema: 1
name: lab
mirrors: {"https://fuel.gazebosim.org": ["http://127.0.0.1:${port}"]}
${simulation}packages: [src/*]
launch: src/lab/sim.launch.xml
`);
}

async function succeeds(...words: readonly string[]): Promise<Finished> {
  const ended = await workspace.run(words);
  assert.equal(ended.code, 0, ended.stderr);
  return ended;
}

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('lab', {}, {
    cmake: 'install(FILES lab.world sim.launch.xml DESTINATION share/${PROJECT_NAME})\n',
    depends: ['gazebo_ros'],
  });
  workspace.write('src/lab/sim.launch.xml', launch);
  workspace.write('src/lab/lab.world', `<sdf version="1.6"><world name="lab">
<include><uri>model://sun</uri></include>
<include><uri>${MODELS}/Red Ball</uri><name>ball_of_fuel</name><pose>0 0 2 0 0 0</pose></include>
</world></sdf>
`);
  // As Fuel's models do, it names its own file by another name than its address has.
  offer('Red Ball', '3', {
    'model.config': config('ball'),
    'model.sdf': model('ball', link('<geometry><mesh><uri>model://ball/meshes/ball.obj</uri></mesh></geometry>')
      + `<include><uri>${MODELS}/Stand/2/files</uri></include>`),
    'meshes/ball.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n',
    'thumbnails/1.png': 'a picture',
  });
  archives.set('/1.0/Somebody/models/Red Ball/tip/Red Ball.zip', archives.get('/1.0/Somebody/models/Red Ball/3/Red Ball.zip') ?? assert.fail());
  offer('Stand', '2', { 'model.sdf': model('stand', link('<geometry><box><size>1 1 1</size></box></geometry>')) });
  host = createServer((request, response) => {
    const path = decodeURIComponent(request.url ?? '');
    requests.push(path);
    const bytes = archives.get(path);
    if (bytes === undefined) response.writeHead(404).end();
    else response.writeHead(200, { 'X-Ign-Resource-Version': path.includes('Ball') ? '3' : '2' }).end(bytes);
  });
  await new Promise<void>((listening) => {
    host.listen(0, '127.0.0.1', listening);
  });
  port = (host.address() as AddressInfo).port;
}, watchdog);

after(() => {
  host.close();
  workspace.close();
});

test('without a word of the manifest the model is named, and nothing is fetched', watchdog, async () => {
  manifest('');
  const { stderr } = await succeeds('check');
  assert.match(stderr, /warning\[R2W0532\]: `src\/lab\/lab\.world` needs the model `Red Ball` of Gazebo Fuel\n --> src\/lab\/lab\.world:3:15/);
  assert.match(stderr, /= fix: simulation: \{fuel: true\}/);
  assert.match((await succeeds('lock')).stderr, /R2W0532/);
  assert.deepEqual(requests, []);
});

test('it is fetched with the models in it, locked by version and hash, and fetched no more', watchdog, async () => {
  manifest('simulation: {fuel: true}\n');
  assert.doesNotMatch((await succeeds('check')).stderr, /R2W05/);
  const made = await succeeds('pack', '-o', 'site');
  assert.match(made.stdout + made.stderr, /fetched the model Somebody\/Red Ball of Gazebo Fuel/);
  assert.deepEqual(requests, ['/1.0/Somebody/models/Red Ball/tip/Red Ball.zip', '/1.0/Somebody/models/Stand/2/Stand.zip']);
  const lock = readFileSync(join(workspace.root, 'ros2wasm.lock'), 'utf8');
  assert.match(lock, new RegExp(`sources:
  - archive: "?${MODELS}/Red%20Ball/3/Red%20Ball\\.zip"?
    sha256: "?[0-9a-f]{64}"?
    size: ${archives.get('/1.0/Somebody/models/Red Ball/3/Red Ball.zip')?.length}
    model: "?Somebody/Red Ball"?
  - archive: "?${MODELS}/Stand/2/Stand\\.zip"?
    sha256: "?[0-9a-f]{64}"?
    size: \\d+
    model: "?Somebody/Stand/2"?
`));
  const files = (JSON.parse(readFileSync(join(workspace.root, 'site/site.json'), 'utf8')) as { readonly files: readonly { readonly path: string; }[]; })
    .files.map(({ path }) => path).filter((path) => path.includes('/fuel/'));
  assert.deepEqual(files, [
    'share/ros2wasm_sim/fuel/somebody/red_ball/tip/meshes/ball.obj',
    'share/ros2wasm_sim/fuel/somebody/red_ball/tip/model.config',
    'share/ros2wasm_sim/fuel/somebody/red_ball/tip/model.sdf',
    'share/ros2wasm_sim/fuel/somebody/stand/2/model.sdf',
  ]);
  await succeeds('verify', 'site');
  requests = [];
  const again = await succeeds('pack', '-o', 'again', '--offline', '--frozen');
  assert.deepEqual(requests, []);
  const sha = /^sha256 \S+$/m;
  assert.equal(sha.exec(again.stdout)?.[0], sha.exec(made.stdout)?.[0]);
});

test('the simulator has the model, and finds its files', watchdog, async () => {
  const { code, stdout, stderr } = await workspace.run(['run', 'site', '--stepped', '--until', 'success=True', '--for', '60s']);
  assert.equal(code, 0, stdout + stderr);
  assert.match(stdout, /model_names=\['ball_of_fuel'\]/);
  assert.doesNotMatch(stdout + stderr, /not found|WARN/);
});

test('an archive of the mirror that is not the locked one is refused, and a model that cannot be had is named', watchdog, async () => {
  const place = '/1.0/Somebody/models/Stand/2/Stand.zip';
  offer('Stand', '2', { 'model.sdf': model('stand', '<link name="another"/>') });
  const lock = readFileSync(join(workspace.root, 'ros2wasm.lock'), 'utf8');
  for (const sha of lock.match(/(?<=sha256: "?)[0-9a-f]{64}(?="?\n {4}size: \d+\n {4}model)/g) ?? assert.fail(lock))
    for (const area of ['archives', 'sources']) rmSync(join(workspace.cache, 'ros2wasm', area, sha.slice(0, 2), sha), { recursive: true, force: true });
  const other = await workspace.run(['pack', '-o', 'other']);
  // The mirror has other bytes, so the address itself is asked, which cannot be reached here.
  assert.notEqual(other.code, 0, other.stderr);
  assert.match(other.stderr, /error\[R2W0233\]: `\S+Stand\.zip` could not be downloaded\n --> src\/lab\/lab\.world:3:15/);
  assert.ok(!existsSync(join(workspace.root, 'other')));
  await succeeds('lock', '--update', 'Stand');
  archives.delete(place);
  archives.delete('/1.0/Somebody/models/Red Ball/tip/Red Ball.zip');
  rmSync(join(workspace.root, 'ros2wasm.lock'));
  const gone = await workspace.run(['pack', '-o', 'other']);
  assert.notEqual(gone.code, 0, gone.stderr);
  assert.match(gone.stderr, /error\[R2W0233\]: `\S+Red%20Ball\.zip` could not be downloaded\n --> src\/lab\/lab\.world:3:15/);
  const offline = await workspace.run(['pack', '-o', 'other', '--offline']);
  assert.match(offline.stderr, /error\[R2W0232\]: the model `Somebody\/Red Ball` of Gazebo Fuel is not on this machine/);
});
