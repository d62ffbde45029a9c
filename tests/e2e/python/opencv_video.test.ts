// cv2.VideoCapture: the visitor's camera in Chromium, which has a test stream in its place, a moving test picture headless,
// and files.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { encode } from 'fast-png';
import { mjpegAvi } from '../../support/mjpeg_avi.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };

const WATCH = `import cv2
import numpy as np
import rclpy


def main():
    # Before rclpy.init(), as many programs do.
    capture = cv2.VideoCapture(0)
    rclpy.init()
    node = rclpy.create_node('watch')
    say = node.get_logger().info
    say(f'opened {capture.isOpened()}')
    if not capture.isOpened():
        say(f'read {capture.read()}')
        return
    say(f'size {capture.get(cv2.CAP_PROP_FRAME_WIDTH)} {capture.get(cv2.CAP_PROP_FRAME_HEIGHT)} {capture.get(cv2.CAP_PROP_FPS) > 0}')
    good, first = capture.read()
    say(f'first {good} {first.shape} {first.dtype} colours {len(np.unique(first.reshape(-1, 3), axis=0)) > 2}')
    changed = 0
    for _ in range(5):
        good, picture = capture.read()
        changed += bool((picture != first).any())
    say(f'changed {changed > 0}')
    say(f'set {capture.set(cv2.CAP_PROP_FRAME_WIDTH, 320)} {capture.set(cv2.CAP_PROP_FRAME_HEIGHT, 240)}')
    say(f'then {capture.grab()} {capture.retrieve()[1].shape} {capture.get(cv2.CAP_PROP_FRAME_WIDTH)}')
    while rclpy.ok() and capture.isOpened():
        good, picture = capture.read()
        if not good:
            break
        rclpy.spin_once(node, timeout_sec=0.05)
    capture.release()
    say(f'released {capture.isOpened()} {capture.read()}')
`;

const FILES = `import os

import cv2
import rclpy
from ament_index_python.packages import get_package_share_directory


def told(capture):
    found = []
    while True:
        good, picture = capture.read()
        if not good:
            return found
        found.append([int(round(float(one), -1)) for one in picture.mean(axis=(0, 1))])


def main():
    rclpy.init()
    say = rclpy.create_node('files').get_logger().info
    folder = get_package_share_directory('eyes') + '/videos'
    for name in ('ride.avi', 'img_%03d.png'):
        capture = cv2.VideoCapture(os.path.join(folder, name))
        facts = [capture.get(one) for one in (cv2.CAP_PROP_FRAME_COUNT, cv2.CAP_PROP_FPS, cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT)]
        say(f'{name} {capture.isOpened()} {facts} {told(capture)}')
        say(f'again {capture.set(cv2.CAP_PROP_POS_FRAMES, 1)} {told(capture)} {capture.get(cv2.CAP_PROP_POS_FRAMES)}')
    for name in ('broken.avi', 'other.avi', 'nothing.mp4', 'none_%d.png', 'eyes.txt'):
        capture = cv2.VideoCapture(os.path.join(folder, name))
        say(f'{name} {capture.isOpened()} {capture.read()}')
    say('done')
`;

const workspace = new PackWorkspace();
after(() => workspace.close());

before(async () => {
  workspace.write('src/eyes/package.xml', `<package format="3">
  <name>eyes</name>
  <version>1.0.0</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <depend>rclpy</depend>
  <depend>ament_index_python</depend>
  <depend>python3-numpy</depend>
  <depend>python3-opencv</depend>
  <export><build_type>ament_python</build_type></export>
</package>
`);
  workspace.write('src/eyes/setup.py', `from glob import glob
from setuptools import setup
setup(name='eyes', version='1.0.0', packages=['eyes'], data_files=[('share/eyes/videos', glob('videos/*'))],
      entry_points={'console_scripts': ['watch = eyes.watch:main', 'files = eyes.files:main']})
`);
  workspace.write('src/eyes/setup.cfg', '[develop]\nscript_dir=$base/lib/eyes\n[install]\ninstall_scripts=$base/lib/eyes\n');
  workspace.write('src/eyes/eyes/__init__.py', '');
  workspace.write('src/eyes/eyes/watch.py', WATCH);
  workspace.write('src/eyes/eyes/files.py', FILES);
  const video = mjpegAvi({ width: 32, height: 16, fps: 10, colours: [[200, 0, 0], [0, 200, 0], [0, 0, 200]] });
  workspace.write('src/eyes/videos/ride.avi', video);
  workspace.write('src/eyes/videos/broken.avi', video.slice(0, 200));
  workspace.write('src/eyes/videos/other.avi', mjpegAvi({ width: 8, height: 8, fps: 10, colours: [[1, 2, 3]], codec: 'XVID' }));
  workspace.write('src/eyes/videos/eyes.txt', 'no video');
  for (const [number, red] of [[1, 100], [2, 200]] as const)
    workspace.write(`src/eyes/videos/img_00${number}.png`,
      encode({ width: 2, height: 2, channels: 3, data: new Uint8Array(12).map((_, at) => (at % 3 === 0 ? red : 0)) }));
  workspace.write('workspace.yaml', `schema: 1
name: eyes
packages: [src/*]
launch:
  - {package: eyes, executable: watch}
  - {package: eyes, executable: files}
`);
  const packed = await workspace.run(['pack', '--offline']);
  assert.equal(packed.code, 0, packed.stderr);
});

const SEEN = ['opened True', 'size 640.0 480.0 True', 'first True (480, 640, 3) uint8 colours True', 'changed True', 'set True True',
  'then True (240, 320, 3) 320.0'];

// Compatibility, works: Python: `cv2.VideoCapture` of AVI files with MJPEG and of numbered pictures
// Compatibility, differs: Python: `cv2.VideoCapture` of other videos -> is not opened; prints a line
// Compatibility, differs: Python: `cv2.VideoCapture(0)` in a headless run -> a moving test picture; prints a line
test('headless, a moving test picture takes the place of the camera, and files are read', watchdog, async () => {
  const run = async (until: string): Promise<string> => {
    const ran = await workspace.run(['run', 'site', '--for', '60s', '--until', until]);
    assert.equal(ran.code, 0, ran.stderr);
    return `${ran.stdout}\n${ran.stderr}`;
  };
  const watched = await run('then True');
  for (const line of SEEN) assert.ok(watched.includes(`[watch]: ${line}`), `${line}\n${watched}`);
  const all = await run('\\[files\\]: done');
  assert.match(watched, /cv2\.VideoCapture\(0\): a headless run has no camera; a moving test picture takes its place/);
  const lines = [...all.matchAll(/\[files\]: (.*)$/gm)].map(([, text]) => text);
  assert.deepEqual(lines, [
    'ride.avi True [3.0, 10.0, 32.0, 16.0] [[0, 0, 200], [0, 200, 0], [200, 0, 0]]',
    'again True [[0, 200, 0], [200, 0, 0]] 3.0',
    'img_%03d.png True [2.0, 25.0, 2.0, 2.0] [[0, 0, 100], [0, 0, 200]]',
    'again True [[0, 0, 200]] 2.0',
    ...['broken.avi', 'other.avi', 'nothing.mp4', 'none_%d.png', 'eyes.txt'].map((name) => `${name} False (False, None)`),
    'done',
  ]);
  assert.equal(all.match(/the file is not opened\. Sites read AVI files with MJPEG/g)?.length, 5);
});

// Compatibility, works: Python: `cv2.VideoCapture(0)` is the visitor's camera after the visitor agrees; a refusal is printed,
// and the camera is not opened
test("the camera is the visitor's, who is asked", watchdog, async () => {
  const browser = await chromium.launch(chromiumOptions(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']));
  try {
    await withTabs(browser, join(workspace.root, 'site'), 'shared', async (open, context) => {
      const refused = await open('?nodes=watch-1');
      refused.setDefaultTimeout(120_000);
      await refused.getByRole('region', { name: 'Camera' }).getByRole('button', { name: 'Refuse' }).click();
      await shows(refused, 'cv2.VideoCapture(0): the camera is not opened: the visitor refused');
      await shows(refused, 'opened False');
      await shows(refused, 'read (False, None)');
      await refused.close();

      await context.grantPermissions(['camera']);
      const page = await open('?nodes=watch-1');
      page.setDefaultTimeout(120_000);
      const bar = page.getByRole('region', { name: 'Camera' });
      await bar.getByRole('button', { name: 'Use camera' }).click();
      for (const line of SEEN) await shows(page, line);
      await bar.getByRole('button', { name: 'Stop the camera' }).click();
      await shows(page, 'released False (False, None)');
    });
  } finally {
    await browser.close();
  }
});
