"""The camera of the visitor, which the page opens when the visitor agrees; a moving test picture in headless runs.

The program publishes requests on /cv2/camera_N/wanted (latched); the page answers on /cv2/camera_N/told (both JSON in
std_msgs/msg/String) and publishes one picture on /cv2/camera_N/image per request for a picture.
"""
import json
import sys
import time

import numpy
from ros2wasm.side_node import SideNode, has_page, newest

#: Longest wait for a frame, in seconds, as in OpenCV.
PATIENCE = 10.0
LOOK = 0.05
USUAL = {'width': 640, 'height': 480, 'fps': 30.0}
MOST_SIDE = 4096
#: The bars of the test picture, as BGR.
COLOURS = (
    (255, 255, 255), (0, 255, 255), (255, 255, 0), (0, 255, 0), (255, 0, 255), (0, 0, 255), (255, 0, 0), (0, 0, 0))


class PageCamera:
    """The constructor waits for the answer of the visitor."""

    fourcc = 0

    def __init__(self, number):
        from sensor_msgs.msg import Image
        from std_msgs.msg import String
        self.number = number
        self.size = dict(USUAL)
        #: Number of requests so far.
        self.turn = 0
        self.told = {}
        self.picture = None
        self.side = SideNode('_cv2_camera')
        topic = f'/cv2/camera_{number}'
        self.wanted = self.side.publisher(String, topic + '/wanted', newest())
        self.answers = self.side.subscription(String, topic + '/told', self.take_answer, 10)
        self.images = self.side.subscription(Image, topic + '/image', self.take_picture, 1)
        self.tell()
        while self.told.get('state') not in ('open', 'refused'):
            self.side.wait(LOOK)
        if not self.is_open():
            reason = str(self.told.get('reason', ''))[:200]
            print(
                f'[ WARN] cv2.VideoCapture({number}): the camera is not opened: {reason}', file=sys.stderr, flush=True)
            self.close()

    def is_open(self):
        return self.told.get('state') == 'open'

    def tell(self, **more):
        from std_msgs.msg import String
        self.turn += 1
        self.wanted.publish(String(data=json.dumps({'turn': self.turn, **self.size, **more})))

    def take_answer(self, message):
        """From the page, or any other program that publishes on the topic."""
        try:
            told = json.loads(message.data)
        except ValueError:
            return
        if isinstance(told, dict):
            self.told = told

    def take_picture(self, message):
        rows, columns = message.height, message.width
        if message.encoding == 'bgr8' and message.step == 3 * columns and len(message.data) == 3 * rows * columns > 0:
            self.picture = numpy.frombuffer(message.data, 'uint8').reshape(rows, columns, 3).copy()

    def next(self):
        """The next picture; None if none comes within PATIENCE, or the camera was closed."""
        if not self.is_open():
            return None
        self.side.wait(0)
        self.picture = None
        self.tell(picture=True)
        end = time.monotonic() + PATIENCE
        while self.picture is None and self.is_open() and time.monotonic() < end:
            self.side.wait(LOOK)
        return self.picture

    def get(self, name):
        value = self.told.get(name, self.size[name])
        return float(value) if isinstance(value, (int, float)) else 0.0

    def set(self, name, value):
        """Wait until the page has changed the camera to the nearest size or rate."""
        self.size[name] = float(value) if name == 'fps' else int(value)
        self.tell()
        end = time.monotonic() + PATIENCE
        while self.is_open() and self.told.get('turn') != self.turn and time.monotonic() < end:
            self.side.wait(LOOK)
        return self.is_open()

    def close(self):
        if self.told.get('state') != 'closed':
            self.told = {'state': 'closed'}
            self.side.destroy(self.wanted, self.answers, self.images)


class TestPicture:
    """A bar that moves over colours, at a camera's frame rate."""

    fourcc = 0

    def __init__(self, number):
        self.size = dict(USUAL)
        self.count = 0
        self.begin()
        print(
            f'[ WARN] cv2.VideoCapture({number}): a headless run has no camera; a moving test picture takes its place',
            file=sys.stderr, flush=True)

    def begin(self):
        width, height = self.size['width'], self.size['height']
        colours = numpy.array(COLOURS, 'uint8')
        row = colours[numpy.arange(width) * len(colours) // width]
        self.background = numpy.repeat(row[None], height, axis=0)
        self.due = time.monotonic()

    def is_open(self):
        return True

    def next(self):
        left = self.due - time.monotonic()
        if left > 0:
            time.sleep(left)
        self.due = max(self.due + 1 / self.size['fps'], time.monotonic() - PATIENCE)
        picture = self.background.copy()
        height = self.size['height']
        thick = max(1, height // 24)
        at = self.count * thick // 4 % height
        picture[at:at + thick] = 128
        self.count += 1
        return picture

    def get(self, name):
        return float(self.size[name])

    def set(self, name, value):
        most = 1000.0 if name == 'fps' else MOST_SIDE
        self.size[name] = max(1.0 if name == 'fps' else 1, min(type(most)(value), most))
        self.begin()
        return True

    def close(self):
        """Nothing is open."""


def open_camera(number):
    """Returns None if the visitor refuses or no camera is available."""
    if not has_page():
        return TestPicture(number)
    camera = PageCamera(number)
    return camera if camera.is_open() else None
