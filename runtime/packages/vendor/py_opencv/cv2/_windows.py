"""Windows: a page has none of programs, so what imshow() shows is published, and the page's Image panel shows it.

The picture of a window NAME is on the topic /cv2/NAME, the newest one for whoever comes later; keys that are pressed in
its panel come on /cv2/NAME/key. Cameras and videos are not there.
"""
import collections
import re
import sys
import time

import numpy
from cv2._call import _array, error

NAMES_OF_TYPES = {1: 'mono8', 3: 'bgr8', 4: 'bgra8'}
#: How long one look for a key sleeps, in seconds.
LOOK = 0.05


class _Windows:
    def __init__(self):
        self.node = None
        self.executor = None
        self.keys = collections.deque(maxlen=100)
        self.publishers = {}
        self.trackbars = {}

    def publisher(self, name):
        if name not in self.publishers:
            import rclpy
            from rclpy.qos import DurabilityPolicy, QoSProfile
            from sensor_msgs.msg import Image
            from std_msgs.msg import Int32
            if not rclpy.ok():
                rclpy.init()
            if self.node is None:
                from rclpy.executors import SingleThreadedExecutor
                self.node = rclpy.create_node('_cv2_windows', start_parameter_services=False, enable_rosout=False)
                self.executor = SingleThreadedExecutor()
                self.executor.add_node(self.node)
            words = re.sub(r'\W+', '_', str(name)).strip('_')
            topic = '/cv2/' + (words if words[:1].isalpha() else 'window_' + words).rstrip('_')
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self.publishers[name] = self.node.create_publisher(Image, topic, qos)
            self.node.create_subscription(Int32, topic + '/key', lambda message: self.keys.append(message.data), 10)
        return self.publishers[name]

    def wait(self, seconds):
        """Until a key comes, or for as long."""
        import rclpy
        if self.executor is None or not rclpy.ok():
            time.sleep(seconds)
        else:
            self.executor.spin_once(timeout_sec=seconds)

    def show(self, name, picture):
        from sensor_msgs.msg import Image
        message = Image()
        message.header.frame_id = str(name)
        message.height, message.width = picture.shape[:2]
        channels = picture.shape[2] if picture.ndim > 2 else 1
        message.encoding = NAMES_OF_TYPES[channels]
        message.step = message.width * channels
        message.data = picture.tobytes()
        self.publisher(name).publish(message)

    def close(self, name):
        publisher = self.publishers.pop(name, None)
        if publisher is not None:
            self.node.destroy_publisher(publisher)


_windows = _Windows()


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
    _windows.show(winname, _shown(picture))


def waitKey(delay=0):
    """-1: no key came in time. With a delay of 0 it waits until one comes, or the program is stopped."""
    end = time.monotonic() + delay / 1000
    while not _windows.keys:
        left = LOOK if delay <= 0 else end - time.monotonic()
        if left <= 0:
            return -1
        _windows.wait(min(left, LOOK))
    return _windows.keys.popleft()


waitKeyEx = waitKey


def pollKey():
    _windows.wait(0)
    return _windows.keys.popleft() if _windows.keys else -1


def namedWindow(winname, flags=1):
    """It opens with its first picture."""


def destroyWindow(winname):
    _windows.close(winname)


def destroyAllWindows():
    for name in list(_windows.publishers):
        _windows.close(name)


def createTrackbar(trackbarName, windowName, value, count, onChange):
    _windows.trackbars[windowName, trackbarName] = [int(value), int(count), onChange]


def getTrackbarPos(trackbarname, winname):
    bar = _windows.trackbars.get((winname, trackbarname))
    return -1 if bar is None else bar[0]


def setTrackbarPos(trackbarname, winname, pos):
    bar = _windows.trackbars.get((winname, trackbarname))
    if bar is not None and bar[0] != pos:
        bar[0] = max(0, min(int(pos), bar[1]))
        bar[2](bar[0])


def setMouseCallback(windowName, onMouse, param=None):
    """No window has a mouse."""


def moveWindow(winname, x, y):
    """The visitor places panels."""


def resizeWindow(winname, *size):
    """The visitor sizes panels."""


def setWindowProperty(winname, prop_id, prop_value):
    """Windows are panels."""


def setWindowTitle(winname, title):
    """The topic is the title."""


def getWindowProperty(winname, prop_id):
    return 1.0 if winname in _windows.publishers else -1.0


class VideoCapture:
    """A page gives no camera or video to a program: it is never opened."""

    def __init__(self, *source):
        if source:
            self.open(*source)

    def open(self, source, *options):
        print(
            f'[ WARN] cv2.VideoCapture({source!r}): a site has no cameras and videos for programs; '
            'subscribe to a topic with images', file=sys.stderr, flush=True)
        return False

    def isOpened(self):
        return False

    def read(self, image=None):
        return False, None

    def grab(self):
        return False

    def retrieve(self, image=None, flag=0):
        return False, None

    def get(self, propId):
        return 0.0

    def set(self, propId, value):
        return False

    def release(self):
        """Nothing is open."""


class VideoWriter:
    """Videos are not written: it is never opened."""

    def __init__(self, *options):
        if options:
            print(
                '[ WARN] cv2.VideoWriter: a site writes no videos; record the topic in a bag',
                file=sys.stderr, flush=True)

    def isOpened(self):
        return False

    def write(self, image):
        """Nothing is open."""

    def release(self):
        """Nothing is open."""


def VideoWriter_fourcc(*letters):
    return sum(ord(letter) << 8 * place for place, letter in enumerate(letters))


VideoWriter.fourcc = staticmethod(VideoWriter_fourcc)
