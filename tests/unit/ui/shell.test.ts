// The shell of a terminal, as lab sheets use it: folders and files, variables, pipes, and what stands for other tools.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Sources } from '../../../runtime/site/contract/session.ts';
import { changedFolder } from '../../../runtime/site/ui/shell/file_words.ts';
import { FileTree } from '../../../runtime/site/ui/shell/file_tree.ts';
import { resolvePath, shortPath, workspacePath } from '../../../runtime/site/ui/shell/paths.ts';
import { Shell } from '../../../runtime/site/ui/shell/shell.ts';
import { transformLines } from '../../../runtime/site/ui/shell/tf_echo.ts';
import { FakeSession } from './fake_session.ts';

const SOURCES: ReadonlyMap<string, string> = new Map([
  ['src/lab_py/lab_py/talk.py', 'import rclpy\n\n\ndef main():\n    rclpy.init()\n    rclpy.spin(node)\n'],
  ['src/lab_py/setup.py', 'from setuptools import setup\nsetup(name="lab_py")\n'],
]);

function fakeSources(): Sources {
  return {
    list: () => [...SOURCES.keys()].map((file) => ({ path: `lib/${file}`, file, sha256: '', state: 'packed' })),
    packed: (path) => Promise.resolve(SOURCES.get(path.slice('lib/'.length)) ?? ''),
    changed: () => undefined,
    change: () => 'kept',
    onChange: () => () => undefined,
  };
}

interface Typed {
  readonly session: FakeSession;
  readonly shell: Shell;
  readonly opened: string[];
  /** Gives what a line prints, errors behind a `! `. */
  readonly type: (line: string) => Promise<readonly string[]>;
}

function openShell(session = new FakeSession({ nodes: [{ executable: 'talker' }], files: ['share/lab_py/launch/lab.launch.py'] })): Typed {
  session.sources = fakeSources();
  const printed: string[] = [];
  const typed: string[] = [];
  const opened: string[] = [];
  const shell = new Shell({
    session,
    print: (text) => printed.push(...text.split('\n')),
    warn: (text) => printed.push(...text.split('\n').map((line) => `! ${line}`)),
    clear: () => printed.splice(0),
    takeInput: () => undefined,
    open: (panel, state) => opened.push(`${panel} ${JSON.stringify(state ?? null)}`) > 0,
    history: () => typed,
    forgetHistory: () => typed.splice(0),
  });
  const type = async (line: string): Promise<readonly string[]> => {
    typed.push(line);
    await shell.run(line, new AbortController());
    return printed.splice(0);
  };
  return { session, shell, opened, type };
}

test('paths: home, dots, and where the files of a workspace stand', () => {
  assert.equal(resolvePath('/home/user', '../x/./y//z/..'), '/home/x/y');
  assert.equal(resolvePath('/a', '~/b'), '/home/user/b');
  assert.equal(resolvePath('/a', '../../..'), '/');
  assert.equal(shortPath('/home/user/ros2_ws'), '~/ros2_ws');
  assert.equal(shortPath('/home/username'), '/home/username');
  assert.equal(workspacePath('src/a/b.py'), '/home/user/ros2_ws/src/a/b.py');
  assert.equal(workspacePath('a/b.py'), '/home/user/ros2_ws/src/a/b.py');
  // A name from a site leads nowhere else than below the root.
  assert.equal(workspacePath('../../../../../etc/passwd'), '/etc/passwd');
});

test('folders: cd, pwd, ls, and their errors', async () => {
  const { shell, type } = openShell();
  assert.deepEqual(await type('pwd'), ['/home/user']);
  assert.equal(shell.prompt, '~$');
  assert.deepEqual(await type('ls'), ['ros2_ws']);
  assert.deepEqual(await type('cd ros2_ws/src/lab_py && ls'), ['lab_py  setup.py']);
  assert.equal(shell.prompt, '~/ros2_ws/src/lab_py$');
  assert.deepEqual(await type('ls -l'), [
    'drwxr-xr-x user user        0 lab_py',
    `-rw-r--r-- user user ${String(SOURCES.get('src/lab_py/setup.py')?.length).padStart(8)} setup.py`,
  ]);
  assert.deepEqual(await type('ls -a lab_py'), ['.  ..  talk.py']);
  assert.deepEqual(await type('cd setup.py; cd nowhere; cd a b'), [
    '! cd: setup.py: Not a directory',
    '! cd: nowhere: No such file or directory',
    '! cd: too many arguments',
  ]);
  assert.deepEqual(await type('ls nowhere setup.py'), ["! ls: cannot access 'nowhere': No such file or directory", 'setup.py']);
  assert.deepEqual(await type('cd -; pwd; cd; pwd; cd ~/ros2_ws; pwd'), ['~', '/home/user', '/home/user', '/home/user/ros2_ws']);
  assert.deepEqual(await type('ls /opt/ros/jazzy/share/lab_py/launch'), ['lab.launch.py']);
  assert.deepEqual(await type('cd src/lab_py; ls lab_py .. | wc -l; ls .. > ~/list && cat ~/list; rm ~/list'), ['5', 'lab_py']);
  assert.deepEqual(await type('ls -z'), ["! ls: invalid option -- 'z'"]);
  const tree = new FileTree([], []);
  assert.deepEqual(changedFolder([], tree, '/', '/'), { folder: '/home/user' });
});

test('each terminal has a folder of its own, and all see the same files', async () => {
  const first = openShell();
  const second = openShell(first.session);
  await first.type('mkdir -p ~/notes/deep && cd ~/notes');
  assert.deepEqual(await first.type('echo hello > a.txt && echo more >> a.txt'), []);
  assert.deepEqual(await second.type('pwd; cat notes/a.txt; ls notes'), ['/home/user', 'hello', 'more', 'a.txt  deep']);
  assert.deepEqual(await second.type('rm notes/a.txt; ls notes; rm notes; rm -r notes; ls'), ['deep', "! rm: cannot remove 'notes': Is a directory",
    'ros2_ws']);
});

test('files are read, counted, sorted and searched, alone and in pipes', async () => {
  const { type } = openShell();
  await type('cd ~/ros2_ws/src/lab_py');
  assert.deepEqual(await type('cat setup.py'), ['from setuptools import setup', 'setup(name="lab_py")']);
  assert.deepEqual(await type('head -n 1 setup.py; head -1 setup.py; tail -n 1 setup.py; tail -n +2 setup.py'), [
    'from setuptools import setup',
    'from setuptools import setup',
    'setup(name="lab_py")',
    'setup(name="lab_py")',
  ]);
  assert.deepEqual(await type('head -n 1 setup.py lab_py/talk.py'), ['==> setup.py <==', 'from setuptools import setup', '', '==> lab_py/talk.py <==',
    'import rclpy']);
  assert.deepEqual(await type('wc -l setup.py'), ['2 setup.py']);
  assert.deepEqual(await type('wc setup.py'), ['      2       5      50 setup.py']);
  assert.deepEqual(await type('cat setup.py lab_py/talk.py | grep -n rclpy | wc -l'), ['3']);
  assert.deepEqual(await type('grep -rn rclpy. .'), ['./lab_py/talk.py:5:    rclpy.init()', './lab_py/talk.py:6:    rclpy.spin(node)']);
  assert.deepEqual(await type('grep nothing setup.py || echo none'), ['none']);
  assert.deepEqual(await type('echo -e "10\\n9\\n9\\n1" | sort -n | uniq -c'), ['      1 1', '      2 9', '      1 10']);
  assert.deepEqual(await type('echo -e "b\\na" | sort -r | head -n 1'), ['b']);
  assert.deepEqual(await type('cat nowhere lab_py'), ['! cat: nowhere: No such file or directory', '! cat: lab_py: Is a directory']);
  assert.match((await type('tail -f setup.py'))[0] ?? '', /^! tail: -f is not possible here/);
  assert.match((await type('cat'))[0] ?? '', /^! cat: a file is missing/);
  assert.match((await type('pwd | less'))[0] ?? '', /^! less: cannot stand behind \|/);
});

test('head ends a program that goes on', async () => {
  const { type } = openShell();
  // It would wait for Ctrl-C.
  const lines = await type('ros2 run tf2_ros tf2_echo map base 50 | head -n 2 && echo done');
  assert.equal(lines.length, 3);
  assert.match(lines[0] ?? '', /^\[INFO\] \[\d+\.\d{9}\] \[tf2_echo\]: Waiting for transform map -> {2}base: Invalid frame ID "base"/);
  assert.equal(lines[2], 'done');
});

test('variables, the exit code, quotes', async () => {
  const { type } = openShell();
  assert.deepEqual(await type('X=3; echo "$X ${X}4" \'$X\' \\$X $HOME $ROS_DISTRO'), ['3 34 $X $X /home/user jazzy']);
  const [note, ...rest] = await type('export ROS_DOMAIN_ID=7 && export OTHER=1 && echo $ROS_DOMAIN_ID$OTHER');
  assert.match(note ?? '', /^ROS_DOMAIN_ID is set in this terminal/);
  assert.deepEqual(rest, ['71']);
  assert.deepEqual(await type('printenv | grep -i ROS_D'), ['ROS_DISTRO=jazzy', 'ROS_DOMAIN_ID=7']);
  assert.deepEqual(await type('false; echo $?; true; echo $?; unset X; echo "[$X]"'), ['1', '0', '[]']);
  assert.deepEqual(await type('export 1x=3'), ['! export: \u20181x=3\u2019: not a valid identifier']);
  assert.deepEqual(await type('wrong 2>/dev/null'), ['! wrong: command not found; help says what there is']);
  assert.match((await type('ros2 topic list &'))[0] ?? '', /open another terminal/i);
});

test('history is numbered, and forgotten on request', async () => {
  const { type } = openShell();
  await type('pwd');
  assert.deepEqual(await type('history'), ['    1  pwd', '    2  history']);
  assert.deepEqual(await type('history 1'), ['    3  history 1']);
  await type('history -c');
  assert.deepEqual(await type('history'), ['    1  history']);
});

test('editors open the panel Source, also by folder and with a line', async () => {
  const { opened, type } = openShell();
  await type('cd ~/ros2_ws/src/lab_py');
  assert.match((await type('nano +5 lab_py/talk.py'))[0] ?? '', /open in the panel Source/);
  await type('code .');
  assert.deepEqual(opened, ['source {"file":"src/lab_py/lab_py/talk.py","line":5}', 'source {"file":"src/lab_py/lab_py/talk.py"}']);
  assert.match((await type('vim new.py'))[0] ?? '', /^! new\.py: not a Python source of the site/);
  assert.match((await type('echo x > setup.py'))[0] ?? '', /^! setup\.py: a source of the site\. nano setup\.py opens it/);
  assert.match((await type('rm setup.py'))[0] ?? '', /the site has it/);
  assert.deepEqual(await type('echo x > /etc/passwd; mkdir /x; touch /y'), [
    '! bash: /etc/passwd: Permission denied',
    '! mkdir: /x: Permission denied',
    '! touch: /y: Permission denied',
  ]);
});

test('ros2 pkg create makes the files of a package, and says what they are for', async () => {
  const { type } = openShell();
  const said = await type(
    'cd ~/ros2_ws/src && ros2 pkg create --build-type ament_python --node-name my_node my_package --license Apache-2.0 --dependencies rclpy std_msgs',
  );
  assert.equal(said[0], 'going to create a new package');
  assert.ok(said.includes('build type: ament_python') && said.includes("dependencies: ['rclpy', 'std_msgs']"), said.join('\n'));
  assert.match(said.at(-1) ?? '', /^! my_package is in this page only/);
  assert.deepEqual(await type('ls my_package my_package/my_package'), [
    'my_package:',
    'my_package  package.xml  resource  setup.cfg  setup.py',
    '',
    'my_package/my_package:',
    '__init__.py  my_node.py',
  ]);
  assert.deepEqual(await type('cat my_package/package.xml | grep depend'), ['  <depend>rclpy</depend>', '  <depend>std_msgs</depend>']);
  assert.match((await type('grep console -A my_package/setup.py; grep "my_node =" my_package/setup.py')).at(-1) ?? '', /'my_node = my_package\.my_node:main'/);
  assert.match((await type('ros2 pkg create my_package'))[1] ?? '', /already exists/);
  assert.match((await type('ros2 pkg create My-Package'))[0] ?? '', /is not valid/);
  await type('ros2 pkg create cpp_package --node-name hello');
  assert.deepEqual(await type('ls cpp_package/src; grep -c hello cpp_package/CMakeLists.txt'), ['hello.cpp', '2']);
});

test('the daemon answers as the tool does; what needs nothing here says so', async () => {
  const { opened, type } = openShell();
  assert.deepEqual(await type('ros2 daemon status; ros2 daemon stop; ros2 daemon stop; ros2 daemon status; ros2 daemon start; ros2 daemon start'), [
    'The daemon is running',
    'The daemon has been stopped',
    'The daemon is not running',
    'The daemon is not running',
    'The daemon has been started',
    'The daemon is already running',
  ]);
  const said = await type('cd ~/ros2_ws && colcon build --symlink-install && source install/setup.bash && ros2 run tf2_tools view_frames');
  assert.match(said[0] ?? '', /changes of Python files apply when their nodes restart.*C\+\+ is built where the site is packed/);
  assert.match(said[1] ?? '', /^nothing to source/);
  assert.equal(said[2], 'view_frames: the panel \u201cFrames\u201d of this page is open');
  assert.deepEqual(opened, ['frames null']);
  assert.match((await type('python3 talk.py'))[0] ?? '', /ros2 run PACKAGE EXECUTABLE/);
  assert.match((await type('ros2 run tf2_ros tf2_echo map'))[0] ?? '', /^! Usage: tf2_echo/);
});

test('a transform is written as tf2_echo writes it', () => {
  const half = Math.SQRT1_2;
  assert.deepEqual(transformLines({ translation: [1, 2, 0], rotation: [0, 0, half, half] }, 12.5), [
    'At time 12.500000000',
    '- Translation: [1.000, 2.000, 0.000]',
    '- Rotation: in Quaternion (xyzw) [0.000, 0.000, 0.707, 0.707]',
    '- Rotation: in RPY (radian) [0.000, 0.000, 1.571]',
    '- Rotation: in RPY (degree) [0.000, 0.000, 90.000]',
    '- Matrix:',
    '  0.000 -1.000  0.000  1.000',
    '  1.000  0.000  0.000  2.000',
    '  0.000  0.000  1.000  0.000',
    '  0.000  0.000  0.000  1.000',
  ]);
});

test('Tab completes words of the shell and names of files', async () => {
  const { shell, type } = openShell();
  const known = { graph: { nodes: [] }, interfaces: [], programs: [], told: [] };
  await type('cd ~/ros2_ws');
  await shell.look();
  assert.deepEqual(shell.offer('his', known), { word: 'his', start: 0, choices: ['history'] });
  assert.deepEqual(shell.offer('cat sr', known), { word: 'sr', start: 4, choices: ['src/'] });
  assert.deepEqual(shell.offer('pwd && cat src/lab_py/s', known), { word: 'src/lab_py/s', start: 11, choices: ['src/lab_py/setup.py'] });
  assert.deepEqual(shell.offer('pwd; ros2 topic ec', known).choices, ['echo']);
});
