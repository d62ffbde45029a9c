// The channel's cv2 in Node.js and Chromium, against what OpenCV 4.6 of Debian says to the same calls
// (tests/support/opencv; made_natively.json is the output of `python3 looks.py` with python3-opencv).
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };
const SUPPORT = resolve(import.meta.dirname, '../../support/opencv');
const OUTPUT = resolve(import.meta.dirname, '../../output');

type Told = null | boolean | number | string | readonly Told[] | { readonly [name: string]: Told; };

/** Names for which `pack` takes Pyodide's opencv-python in place of the channel's cv2. */
const SOURCE = readFileSync(resolve(import.meta.dirname, '../../../bundler/workspace/python_libraries.cpp'), 'utf8');
const [, LIST = ''] = /kNotOfOpenCv = [^{]*\(\{(.*?)\}\)/s.exec(SOURCE) ?? assert.fail();
const absent = [...LIST.matchAll(/"(\w+)"/g)].map(([, name]) => name);

/** Both directions, within one program: what is published comes back as an array. */
const BRIDGE = `import cv2
import numpy as np
import rclpy
from cv_bridge import CvBridge, CvBridgeError
from image_geometry import PinholeCameraModel, StereoCameraModel
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, CompressedImage, Image


ABSENT = ${JSON.stringify(absent)}


class Bridge(Node):
    def __init__(self):
        super().__init__('bridge')
        self.bridge = CvBridge()
        self.create_subscription(Image, 'picture', self.take, 10)
        self.create_subscription(CompressedImage, 'small', self.take_small, 10)
        self.pictures = self.create_publisher(Image, 'picture', 10)
        self.small = self.create_publisher(CompressedImage, 'small', 10)
        self.create_timer(0.1, self.give)
        self.told = set()

    def give(self):
        picture = np.zeros((4, 6, 3), np.uint8)
        picture[:] = (10, 20, 200)
        self.pictures.publish(self.bridge.cv2_to_imgmsg(picture, encoding='bgr8'))
        self.small.publish(self.bridge.cv2_to_compressed_imgmsg(cv2.resize(picture, (32, 16)), dst_format='png'))

    def say(self, text):
        if text not in self.told:
            self.told.add(text)
            self.get_logger().info(text)

    def take(self, message):
        self.say(f'{message.encoding} {message.step} {self.bridge.imgmsg_to_cv2(message, "rgb8")[3, 5].tolist()}')
        gray = self.bridge.imgmsg_to_cv2(message, desired_encoding='mono8')
        self.say(f'gray {gray.shape} {gray.dtype} {int(gray[0, 0])}')
        depth = self.bridge.cv2_to_imgmsg(np.full((2, 3), 1.5, np.float32))
        self.say(f'depth {depth.encoding} {depth.step} {self.bridge.imgmsg_to_cv2(depth).tolist()[0]}')
        wide = self.bridge.imgmsg_to_cv2(self.bridge.cv2_to_imgmsg(np.full((2, 2), 25700, np.uint16), 'mono16'), 'mono8')
        self.say(f'wide {wide.dtype} {int(wide[0, 0])}')
        for attempt in (lambda: self.bridge.cv2_to_imgmsg(gray, 'bgr8'), lambda: self.bridge.imgmsg_to_cv2(message, 'nothing')):
            try:
                attempt()
            except CvBridgeError as error:
                self.say(f'refused: {error}')

    def take_small(self, message):
        picture = self.bridge.compressed_imgmsg_to_cv2(message)
        self.say(f'small {message.format} {picture.shape} {picture[0, 0].tolist()}')


def cameras():
    info = CameraInfo(width=160, height=120, d=[-0.25, 0.08, 0.001, -0.002, 0.01], binning_x=2)
    info.header.frame_id = 'eye'
    info.k = [200.0, 0, 80, 0, 200, 60, 0, 0, 1]
    info.r = [1.0, 0, 0, 0, 1, 0, 0, 0, 1]
    info.p = [200.0, 0, 80, 0, 0, 200, 60, 0, 0, 0, 1, 0]
    model = PinholeCameraModel()
    model.fromCameraInfo(info)
    pixel = model.project3dToPixel((0.2, -0.1, 2.0))
    ray = model.projectPixelTo3dRay(pixel)
    told = [model.fx(), model.cx(), *pixel, *ray, *model.rectifyPoint((10, 20)), model.getDeltaX(10, 2.0), model.full_K[0, 0]]
    info.binning_x = 0
    right = CameraInfo(width=160, height=120, k=info.k, r=info.r, p=[200.0, 0, 80, -20, 0, 200, 60, 0, 0, 0, 1, 0])
    stereo = StereoCameraModel()
    stereo.fromCameraInfo(info, right)
    told += [stereo.getZ(10), stereo.getDisparity(2.0), *stereo.projectPixelTo3d((100, 70), 10)]
    flat = np.zeros((120, 160), np.uint8)
    stereo.left.rectifyImage(np.full((120, 160), 200, np.uint8), flat)
    return f'{model.tfFrame()} {[round(float(one), 3) for one in told]} {flat[60, 80]}'


def main():
    rclpy.init()
    node = Bridge()
    node.say(cameras())
    node.say(f'has {[name for name in ABSENT if hasattr(cv2, name)]} of {len(ABSENT)}')
    rclpy.spin(node)
`;

const workspace = new PackWorkspace();
after(() => workspace.close());

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  workspace.write('src/eyes/package.xml', `<package format="3">
  <name>eyes</name>
  <version>1.0.0</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <depend>rclpy</depend>
  <depend>sensor_msgs</depend>
  <depend>python3-numpy</depend>
  <depend>python3-opencv</depend>
  <export><build_type>ament_python</build_type></export>
</package>
`);
  workspace.write('src/eyes/setup.py', `from setuptools import setup
setup(name='eyes', version='1.0.0', packages=['eyes'], entry_points={'console_scripts': ['looks = eyes.looks:main', 'window = eyes.window:main', 'bridge = eyes.bridge:main']})
`);
  workspace.write('src/eyes/setup.cfg', '[develop]\nscript_dir=$base/lib/eyes\n[install]\ninstall_scripts=$base/lib/eyes\n');
  workspace.write('src/eyes/eyes/__init__.py', '');
  workspace.write('src/eyes/eyes/looks.py', readFileSync(join(SUPPORT, 'looks.py'), 'utf8'));
  workspace.write('src/eyes/eyes/window.py', `import cv2
import numpy as np
import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('watcher')
    picture = np.zeros((48, 64, 3), np.uint8)
    step = 0
    say = node.get_logger().info
    cv2.namedWindow('My mask')
    cv2.createTrackbar('Hue', 'My mask', 30, 179, lambda value: say(f'hue {value} {cv2.getTrackbarPos("Hue", "My mask")}'))
    cv2.setMouseCallback('My mask', lambda event, x, y, flags, param: event == cv2.EVENT_LBUTTONDOWN and say(f'{param} {x} {y} {flags}'), 'click')
    while rclpy.ok():
        picture[:] = (0, 128, 255)
        cv2.putText(picture, str(step), (5, 30), cv2.FONT_HERSHEY_SIMPLEX, 0.8, (255, 255, 255), 2)
        cv2.imshow('My mask', picture)
        key = cv2.waitKey(50)
        if key != -1:
            node.get_logger().info(f'key {key & 0xFF}')
        if key & 0xFF == ord('q'):
            break
        step += 1
        rclpy.spin_once(node, timeout_sec=0)
    cv2.destroyAllWindows()
`);
  workspace.write('src/eyes/eyes/bridge.py', BRIDGE);
  workspace.write('workspace.yaml', `schema: 1
name: eyes
packages: [src/*]
launch:
  - {package: eyes, executable: looks}
  - {package: eyes, executable: window}
  - {package: eyes, executable: bridge}
`);
  const packed = await workspace.run(['pack', '--offline']);
  assert.equal(packed.code, 0, packed.stderr);
});

/** Where two values differ by more than numbers of floating point on other processors may. */
function differences(here: Told, there: Told, place: string): readonly string[] {
  if (typeof here === 'number' && typeof there === 'number') {
    return Math.abs(here - there) <= 2e-3 * Math.max(1, Math.abs(there)) ? [] : [`${place}: ${here} instead of ${there}`];
  }
  if (Array.isArray(here) && Array.isArray(there) && here.length === there.length) {
    return here.flatMap((one: Told, i) => differences(one, (there as readonly Told[])[i]!, `${place}[${i}]`));
  }
  return JSON.stringify(here) === JSON.stringify(there) ? [] : [`${place}: ${JSON.stringify(here)} instead of ${JSON.stringify(there)}`];
}

const natively = new Map(Object.entries(JSON.parse(readFileSync(join(SUPPORT, 'made_natively.json'), 'utf8')) as Record<string, Told>));

/** The line of the headless run that has the hash of the others. */
let last = '';

function compared(output: string): number {
  const found = [...output.matchAll(/^(?:\[[^\]]*\] )?(\{"\w+": .*\})$/gm)].map(([, line]) => JSON.parse(line!) as Record<string, Told>);
  const seen = new Map(found.flatMap((one) => Object.entries(one)));
  assert.deepEqual([...seen.keys()].toSorted(), [...natively.keys()].toSorted());
  assert.deepEqual([...seen].flatMap(([name, value]) => differences(value, natively.get(name) ?? null, name)), []);
  return seen.size;
}

// Compatibility, works: Python: expressions of numpy over arrays of 256 kB and more
// Compatibility, works: Python: `import cv2` without a network: OpenCV over npm's OpenCV.js, with the functions that courses use
test('cv2 gives the shapes, types, values and errors of OpenCV on a desktop', watchdog, async () => {
  const ran = await workspace.run(['run', 'site', '--for', '120s', '--until', 'looks: done']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.equal(compared(ran.stdout), natively.size);
  [last = ''] = /looks: done \w+/.exec(ran.stdout) ?? [];
});

// Compatibility, works: Python: cv_bridge (images and compressed images as arrays and back, encodings, errors) and image_geometry
test('cv_bridge gives arrays of images and images of arrays, and cv2 has no name of those that ask for the other cv2', watchdog, async () => {
  const ran = await workspace.run(['run', 'site', '--for', '60s', '--until', 'small png']);
  assert.equal(ran.code, 0, ran.stderr);
  const lines = [...ran.stdout.matchAll(/\[bridge\]: (.*)$/gm)].map(([, text]) => text);
  assert.deepEqual(lines, [
    'eye [100.0, 40.0, 50.0, 50.0, 0.099, -0.05, 0.994, 9.028, 18.637, 0.2, 200.0, 2.0, 10.0, 0.2, 0.1, 2.0] 200',
    `has [] of ${absent.length}`,
    'bgr8 18 [200, 20, 10]',
    'gray (4, 6) uint8 73',
    'depth 32FC1 12 [1.5, 1.5, 1.5]',
    'wide uint8 100',
    'refused: encoding specified as bgr8, but image has incompatible type 8UC1',
    'refused: Unrecognized image encoding [nothing]',
    'small png (16, 32, 3) [10, 20, 200]',
  ]);
  assert.ok(absent.length > 100);
});

// Compatibility, works: Python: `cv2.imshow` opens an Image panel, with keys for `cv2.waitKey`, trackbars and the mouse
test('in Chromium cv2 gives the same, a window opens a panel, and its keys come to waitKey', watchdog, async () => {
  const browser = await chromium.launch(chromiumOptions());
  try {
    await withTabs(browser, join(workspace.root, 'site'), 'shared', async (open) => {
      const page = await open('');
      page.setDefaultTimeout(120_000);
      const picture = page.locator('.panel-image .picture-view');
      await picture.waitFor();
      assert.equal(await page.locator('.panel-image .image-topic').inputValue(), '/cv2/My_mask');
      await picture.focus();
      await page.keyboard.press('a');
      const hue = page.locator('.panel-image').getByRole('slider', { name: 'Hue' });
      assert.equal(await hue.inputValue(), '30');
      await hue.press('ArrowRight');
      await picture.click();
      await picture.focus();
      await page.screenshot({ path: join(OUTPUT, 'cv2_window.png') });
      await page.keyboard.press('q');
      await page.locator('.panel-nodes').getByText('Finished, code 0').nth(1).waitFor();
      await page.getByRole('tab', { name: 'Consoles' }).click();
      await shows(page, 'key 97');
      await shows(page, 'hue 31 31');
      await page.waitForFunction(() => /click (2[4-9]|3\d) (1[5-9]|2\d|3[0-3]) 1/.test(document.body.innerText));
      await shows(page, 'key 113');
      await page.close();
      await shows(await open('?nodes=looks-1'), last);
    });
  } finally {
    await browser.close();
  }
});
