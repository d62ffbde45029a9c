// `ros2wasm rebuild SITE`: sites are made once more from what they carry, and are the same or are told to be others; what
// strangers put into a site's archive is refused.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { chmodSync, cpSync, existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { nightlyTest } from '../../support/nightly.ts';
import { type Finished, PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 500_000 };
const archive = 'sources.zip';
let ws: PackWorkspace;
/** Where temporary files of the program go: empty again after each call. */
let temporary = '';

const packageXml = (name: string, type: string, depends: string): string =>
  `<package format="3">
  <name>${name}</name><version>0.3.0</version><description>Part of a lab</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
  ${depends}<export><build_type>${type}</build_type></export>
</package>
`;

const files: Readonly<Record<string, string>> = {
  'LICENSE': 'A license of its own, for all packages of the lab.\n',
  'lab/workspace.yaml': `schema: 1
name: lab
packages: [src/*, ../beside]
launch:
  file: start/lab.launch.xml
ui: {text: sheet.md}
site: {sources: true}
`,
  'lab/sheet.md': '# Lab\n\n![a picture](images/dot.svg)\n',
  'lab/images/dot.svg': '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><circle r="1"/></svg>\n',
  'lab/start/lab.launch.xml': `<launch>
  <node pkg="lab_nodes" exec="count"><param from="$(find-pkg-share lab_nodes)/config/count.yaml"/></node>
  <node pkg="lab_nodes" exec="script.py"/>
  <node pkg="words" exec="speak"/>
</launch>
`,
  'lab/src/lab_nodes/package.xml': packageXml('lab_nodes', 'ament_cmake',
    '<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend><depend>lab_msgs</depend>'),
  'lab/src/lab_nodes/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(lab_nodes)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(lab_msgs REQUIRED)
add_executable(count src/count.cpp)
ament_target_dependencies(count rclcpp lab_msgs)
install(TARGETS count DESTINATION lib/\${PROJECT_NAME})
install(DIRECTORY scripts/ DESTINATION lib/\${PROJECT_NAME} USE_SOURCE_PERMISSIONS)
install(DIRECTORY config DESTINATION share/\${PROJECT_NAME})
ament_package()
`,
  'lab/src/lab_nodes/src/count.cpp': `#include <lab_msgs/msg/count.hpp>
#include <rclcpp/rclcpp.hpp>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("count");
  lab_msgs::msg::Count message;
  message.count = node->declare_parameter("first", 1);
  node->create_publisher<lab_msgs::msg::Count>("counts", 10)->publish(message);
}
`,
  'lab/src/lab_nodes/scripts/script.py': '#!/usr/bin/env python3\nprint("a script")\n',
  'lab/src/lab_nodes/config/count.yaml': 'count:\n  ros__parameters:\n    first: 7\n',
  'lab/src/words/package.xml': packageXml('words', 'ament_python', '<depend>rclpy</depend>'),
  'lab/src/words/setup.py': `from setuptools import setup
setup(name='words', version='0.3.0', packages=['words'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/words']), ('share/words', ['package.xml'])],
    entry_points={'console_scripts': ['speak = words.speak:main']})
`,
  'lab/src/words/setup.cfg': '[develop]\nscript_dir=$base/lib/words\n[install]\ninstall_scripts=$base/lib/words\n',
  'lab/src/words/resource/words': '',
  'lab/src/words/words/__init__.py': '',
  'lab/src/words/words/speak.py': 'from lab_msgs.msg import Count\n\n\ndef main():\n    print(Count(count=2))\n',
  'beside/package.xml': packageXml('lab_msgs', 'ament_cmake',
    `<buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend><member_of_group>rosidl_interface_packages</member_of_group>`),
  'beside/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(lab_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(\${PROJECT_NAME} "msg/Count.msg")
ament_package()
`,
  'beside/msg/Count.msg': 'int64 count\n',
};

function run(args: readonly string[]): Promise<Finished> {
  return ws.run(args, { TMPDIR: temporary });
}

before(async () => {
  ws = new PackWorkspace();
  temporary = mkdtempSync(join(tmpdir(), 'ros2wasm-rebuild-'));
  for (const [path, text] of Object.entries(files)) ws.write(path, text);
  chmodSync(join(ws.root, 'lab/src/lab_nodes/scripts/script.py'), 0o755);
  const packed = await run(['pack', 'lab', '-o', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);

after(() => {
  ws.close();
  rmSync(temporary, { recursive: true, force: true });
});

function members(zip: string): string[] {
  const listed = spawnSync('python3', ['-c', 'import sys, zipfile; print("\\n".join(zipfile.ZipFile(sys.argv[1]).namelist()))', zip], { encoding: 'utf8' });
  assert.equal(listed.status, 0, listed.stderr);
  return listed.stdout.trim().split('\n');
}

test('a site carries its manifest, lock, packages and what the manifest names, and nothing else', () => {
  const carried = members(join(ws.root, 'site', archive));
  assert.equal(carried[0], 'workspace/workspace.yaml');
  const expected = Object.keys(files).filter((path) => path !== 'LICENSE').map((path) => path.replace(/^lab\//, 'workspace/'));
  assert.deepEqual([...carried].sort(), [...expected, 'workspace/ros2wasm.lock'].sort());
});

// Guarantee, verified: `ros2wasm rebuild` makes a site once more from what it carries (C++, own messages, Python, a launch file) and gets the same bytes
test('what a site carries makes the same site: from a folder, from an archive', watchdog, async () => {
  const elsewhere = `${temporary}-site`;
  cpSync(join(ws.root, 'site'), elsewhere, { recursive: true });
  try {
    const rebuilt = await run(['rebuild', elsewhere]);
    assert.equal(rebuilt.code, 0, rebuilt.stderr);
    assert.match(rebuilt.stdout, /its sources make the same site\nsha256 [0-9a-f]{64}\n$/);
    assert.match(rebuilt.stderr, /built lab_msgs, lab_nodes, words/);
    assert.equal((await run(['pack', 'lab', '-o', 'lab.zip'])).code, 0);
    const again = await run(['--json', 'rebuild', 'lab.zip']);
    assert.equal(again.code, 0, again.stderr);
    assert.equal((JSON.parse(again.stdout) as { same: boolean; }).same, true);
    assert.deepEqual(readdirSync(temporary), []);
  } finally {
    rmSync(elsewhere, { recursive: true, force: true });
  }
});

nightlyTest('a site of a store, with files in parts, makes the same site', watchdog, async () => {
  const packed = await run(['pack', 'lab', '-o', 'course/lab', '--store', 'course/objects', '--max-file-size', '2']);
  assert.equal(packed.code, 0, packed.stderr);
  const rebuilt = await run(['rebuild', 'course/lab', '-o', 'again']);
  assert.equal(rebuilt.code, 0, rebuilt.stderr);
  assert.ok(existsSync(join(ws.root, 'again/site/site.json')));
});

function sha256Of(bytes: Buffer): string {
  return createHash('sha256').update(bytes).digest('hex');
}

/** Puts another archive into a copy of the site, which lists it then. */
function forged(name: string, bytes: Buffer): string {
  const site = join(ws.root, name);
  cpSync(join(ws.root, 'site'), site, { recursive: true });
  writeFileSync(join(site, archive), bytes);
  const json = JSON.parse(readFileSync(join(site, 'site.json'), 'utf8')) as { files: { path: string; size: number; sha256: string; }[]; };
  const listed = json.files.find(({ path }) => path === archive);
  assert.ok(listed);
  Object.assign(listed, { size: bytes.length, sha256: sha256Of(bytes) });
  writeFileSync(join(site, 'site.json'), JSON.stringify(json));
  const sums = [['site.json', ''], ...json.files.map(({ path, sha256 }) => [path, sha256] as const)]
    .map(([path = '', sha256]) => `${sha256 === '' ? sha256Of(readFileSync(join(site, path))) : sha256}  ${path}\n`);
  writeFileSync(join(site, 'SHA256SUMS'), sums.sort((a, b) => (a.slice(66) < b.slice(66) ? -1 : 1)).join(''));
  return name;
}

// Guarantee, verified: `ros2wasm rebuild` tells sources that do not make the site, and names the files
nightlyTest('sources that make another site are told, with the file that differs', watchdog, async () => {
  cpSync(join(ws.root, 'lab'), join(ws.root, 'other/lab'), { recursive: true });
  cpSync(join(ws.root, 'beside'), join(ws.root, 'other/beside'), { recursive: true });
  ws.write('other/lab/src/lab_nodes/src/count.cpp', (files['lab/src/lab_nodes/src/count.cpp'] ?? '').replace('"counts"', '"others"'));
  const changed = await run(['rebuild', 'site', '--workspace', 'other/lab']);
  assert.equal(changed.code, 1);
  const listed = await run(['--json', 'rebuild', 'site', '--workspace', 'other/lab']);
  const { same, differences } = JSON.parse(listed.stdout) as { same: boolean; differences: { path: string; change: string; }[]; };
  assert.equal(same, false);
  assert.ok(differences.some(({ path, change }) => path === 'programs/lab_nodes/count.wasm' && change === 'changed'));
  assert.match(changed.stderr, /error\[R2W0663\]: the sources make another site: sha256 [0-9a-f]{64}/);
  assert.match(changed.stderr, /programs\/lab_nodes\/count\.wasm: differs in /);
  const other = await run(['pack', 'other/lab', '-o', 'other/site']);
  assert.equal(other.code, 0, other.stderr);
  const swapped = await run(['rebuild', forged('swapped', readFileSync(join(ws.root, 'other/site', archive)))]);
  assert.equal(swapped.code, 1);
  assert.match(swapped.stderr, /error\[R2W0663\]/);
});

test('a site whose bytes are not those that it lists is not rebuilt', watchdog, async () => {
  cpSync(join(ws.root, 'site'), join(ws.root, 'damaged'), { recursive: true });
  const bytes = ws.read(`site/${archive}`);
  bytes[bytes.length >> 1] = (bytes[bytes.length >> 1] ?? 0) ^ 1;
  writeFileSync(join(ws.root, 'damaged', archive), bytes);
  const refused = await run(['rebuild', 'damaged']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0650\]: `sources\.zip`/);
  assert.doesNotMatch(refused.stderr, /built/);
});

// Guarantee, hostile input: a site's archive of sources with names that lead outside, links, bombs or no manifest: `rebuild` refuses it, and nothing is written
test('a hostile archive of sources writes nothing', watchdog, async () => {
  const make = (script: string): Buffer => {
    const file = join(temporary, 'made.zip');
    const made = spawnSync('python3', ['-c',
      `import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1], "w")\nz.writestr("workspace.yaml", "schema: 1\\nname: evil\\n")\n${script}\nz.close()\n`, file], {
      encoding: 'utf8',
    });
    assert.equal(made.status, 0, made.stderr);
    const bytes = readFileSync(file);
    rmSync(file);
    return bytes;
  };
  const link = 'i = zipfile.ZipInfo("src")\ni.create_system = 3\ni.external_attr = 0o120777 << 16\nz.writestr(i, "/etc")';
  const evil: readonly (readonly [string, string, string])[] = [
    ['up', 'z.writestr("../../evil", "x")', 'R2W0222'],
    ['absolute', `z.writestr(${JSON.stringify(join(temporary, 'evil'))}, "x")`, 'R2W0222'],
    ['link', link, 'R2W0223'],
    ['twice', 'z.writestr("WORKSPACE.yaml", "x")', 'R2W0224'],
    ['bomb', 'z.writestr("zeros", bytes(200 << 20), zipfile.ZIP_DEFLATED)', 'R2W0225'],
  ];
  for (const [name, script, code] of evil) {
    const refused = await run(['rebuild', forged(name, make(script))]);
    assert.equal(refused.code === 0, false, name);
    assert.match(refused.stderr, new RegExp(`error\\[${code}\\]: the archive of \`sources\\.zip\` was refused`), name);
    assert.deepEqual(readdirSync(temporary), [], name);
  }
  const none = await run(['rebuild', forged('none', Buffer.from('PK\x05\x06'.padEnd(22, '\0'), 'latin1'))]);
  assert.match(none.stderr, /error\[R2W0221\]: the archive of `sources\.zip` is damaged/);
  assert.deepEqual(readdirSync(temporary), []);
});

test('a site without sources, and sources that no archive holds, are told', watchdog, async () => {
  ws.write('plain/workspace.yaml', 'schema: 1\nname: plain\npackages: [../lab/src/words, ../beside]\nlaunch: [{package: words, executable: speak}]\n');
  assert.equal((await run(['pack', 'plain', '-o', 'plain/site'])).code, 0);
  const without = await run(['rebuild', 'plain/site']);
  assert.equal(without.code, 1);
  assert.match(without.stderr, /error\[R2W0662\]: the site `plain\/site` does not carry what it is made of/);
  const given = await run(['rebuild', 'plain/site', '--workspace', 'plain']);
  assert.equal(given.code, 0, given.stderr);

  ws.write('plain/workspace.yaml',
    'schema: 1\nname: plain\npackages: [../lab/src/words, ../beside]\nlaunch: [{package: words, executable: speak}]\nsite: {sources: true}\n');
  const extra = join(ws.root, 'lab/src/words/');
  symlinkSync('/usr/share', join(extra, 'elsewhere'));
  writeFileSync(join(extra, 'notes.txt'), '');
  writeFileSync(join(extra, 'Notes.txt'), '');
  try {
    const linked = await run(['pack', 'plain', '-o', 'plain/none']);
    assert.equal(linked.code, 1);
    assert.match(linked.stderr,
      /error\[R2W0661\]: the site cannot carry `\.\.\/lab\/src\/words\/elsewhere`, of which it is made\n.*it is a link to the folder `\/usr\/share`/);
    rmSync(join(extra, 'elsewhere'));
    const alike = await run(['pack', 'plain', '-o', 'plain/none']);
    assert.match(alike.stderr, /error\[R2W0661\]: .*notes\.txt`/);
    assert.ok(!existsSync(join(ws.root, 'plain/none')));
  } finally {
    for (const name of ['elsewhere', 'notes.txt', 'Notes.txt']) rmSync(join(extra, name), { force: true });
  }
});
