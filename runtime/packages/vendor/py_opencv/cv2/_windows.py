"""Windows: a page has none of programs, so what imshow() shows is published, and the page's Image panel shows it.

The picture of a window NAME is on the topic /cv2/NAME, the newest one for whoever comes later. Its trackbars, and
whether it asks for the mouse, are on /cv2/NAME/controls; keys, trackbars and the mouse of the panel come on
/cv2/NAME/input. Both are JSON in std_msgs/msg/String.
"""
import collections
import json
import re
import time

import numpy
from cv2._call import _array, error
from ros2wasm.side_node import SideNode, newest

NAMES_OF_TYPES = {1: 'mono8', 3: 'bgr8', 4: 'bgra8'}
#: How long one look for events sleeps, in seconds.
LOOK = 0.05


class _Window:
    def __init__(self, desk, name):
        from sensor_msgs.msg import Image
        from std_msgs.msg import String
        self.desk = desk
        self.name = name
        #: Value, largest value and callback, by name.
        self.trackbars = {}
        #: The callback of the mouse and what it gets besides.
        self.mouse = None
        words = re.sub(r'\W+', '_', str(name)).strip('_')
        topic = '/cv2/' + (words if words[:1].isalpha() else 'window_' + words).rstrip('_')
        self.pictures = desk.side.publisher(Image, topic, newest())
        self.controls = desk.side.publisher(String, topic + '/controls', newest())
        self.inputs = desk.side.subscription(String, topic + '/input', self.take, 100)
        self.tell()

    def tell(self):
        from std_msgs.msg import String
        bars = [{'name': name, 'value': bar[0], 'count': bar[1]} for name, bar in self.trackbars.items()]
        self.controls.publish(String(data=json.dumps({'trackbars': bars, 'mouse': self.mouse is not None})))

    def take(self, message):
        """An event of the panel. Another program may have sent it."""
        try:
            event = json.loads(message.data)
            if 'key' in event:
                self.desk.keys.append(int(event['key']) & 0xFF)
            elif 'trackbar' in event:
                self.move(event['trackbar'], int(event['value']))
            elif 'mouse' in event and self.mouse is not None:
                kind, x, y, flags = (int(one) for one in event['mouse'])
                callback, param = self.mouse
                self.desk.later.append(lambda: callback(kind, x, y, flags, param))
        except (KeyError, TypeError, ValueError):
            return

    def move(self, name, value):
        bar = self.trackbars.get(name)
        value = None if bar is None else max(0, min(value, bar[1]))
        if bar is None or bar[0] == value:
            return
        bar[0] = value
        self.desk.later.append(lambda: bar[2](value))

    def show(self, picture):
        from sensor_msgs.msg import Image
        message = Image()
        message.header.frame_id = str(self.name)
        message.height, message.width = picture.shape[:2]
        channels = picture.shape[2] if picture.ndim > 2 else 1
        message.encoding = NAMES_OF_TYPES[channels]
        message.step = message.width * channels
        message.data = picture.tobytes()
        self.pictures.publish(message)

    def close(self):
        self.desk.side.destroy(self.pictures, self.controls, self.inputs)


class _Desk:
    """All windows of the program, and the node that they publish by."""

    def __init__(self):
        self.side = SideNode('_cv2_windows')
        self.keys = collections.deque(maxlen=100)
        #: Callbacks of the program: they are called by waitKey(), outside of the executor.
        self.later = collections.deque(maxlen=1000)
        self.windows = {}

    def window(self, name):
        if name not in self.windows:
            self.windows[name] = _Window(self, name)
        return self.windows[name]

    def wait(self, seconds):
        """Until something comes, or for as long."""
        self.side.wait(seconds)
        while self.later:
            self.later.popleft()()

    def close(self, name):
        window = self.windows.pop(name, None)
        if window is not None:
            window.close()


_desk = _Desk()


def _shown(picture):
    """As windows show it: numbers with a fraction from 0 to 1, 16 bits by their upper half."""
    if picture.dtype == 'uint8':
        return picture
    if picture.dtype in ('uint16', 'int16', 'int32'):
        return (picture.astype('int64') >> 8).clip(0, 255).astype('uint8')
    return numpy.rint(picture * 255).clip(0, 255).astype('uint8')


def imshow(winname, mat):
    picture = None if mat is None else _array(mat, 'imshow', 'mat')
    if picture is None or picture.size == 0 or picture.ndim < 2:
        raise error(
            "OpenCV(4.13.0) error: (-215:Assertion failed) size.width>0 && size.height>0 in function 'imshow'",
            -215, 'imshow')
    if picture.ndim > 2 and picture.shape[2] not in NAMES_OF_TYPES:
        raise error('OpenCV(4.13.0) error: (-215:Assertion failed) a picture has 1, 3 or 4 channels', -215, 'imshow')
    _desk.window(winname).show(_shown(picture))


def waitKey(delay=0):
    """-1: no key came in time. With a delay of 0 it waits until one comes, or the program is stopped."""
    end = time.monotonic() + delay / 1000
    while not _desk.keys:
        left = LOOK if delay <= 0 else end - time.monotonic()
        if left <= 0:
            return -1
        _desk.wait(min(left, LOOK))
    return _desk.keys.popleft()


waitKeyEx = waitKey


def pollKey():
    _desk.wait(0)
    return _desk.keys.popleft() if _desk.keys else -1


def namedWindow(winname, flags=1):
    _desk.window(winname)


def destroyWindow(winname):
    _desk.close(winname)


def destroyAllWindows():
    for name in list(_desk.windows):
        _desk.close(name)


def createTrackbar(trackbarName, windowName, value, count, onChange):
    window = _desk.window(windowName)
    window.trackbars[trackbarName] = [max(0, min(int(value), int(count))), int(count), onChange]
    window.tell()


def getTrackbarPos(trackbarname, winname):
    window = _desk.windows.get(winname)
    bar = None if window is None else window.trackbars.get(trackbarname)
    return -1 if bar is None else bar[0]


def setTrackbarPos(trackbarname, winname, pos):
    window = _desk.windows.get(winname)
    if window is not None and trackbarname in window.trackbars:
        window.move(trackbarname, int(pos))
        window.tell()


def setMouseCallback(windowName, onMouse, param=None):
    window = _desk.window(windowName)
    window.mouse = (onMouse, param)
    window.tell()


def moveWindow(winname, x, y):
    """The visitor places panels."""


def resizeWindow(winname, *size):
    """The visitor sizes panels."""


def setWindowProperty(winname, prop_id, prop_value):
    """Windows are panels."""


def setWindowTitle(winname, title):
    """The topic is the title."""


def getWindowProperty(winname, prop_id):
    return 1.0 if winname in _desk.windows else -1.0
