"""cv2.VideoCapture and cv2.VideoWriter."""
import os
import sys

from cv2._call import error
from cv2._camera import open_camera
from cv2._videos import open_video

POS_MSEC, POS_FRAMES, WIDTH, HEIGHT, FPS, FOURCC, COUNT = 0, 1, 3, 4, 5, 6, 7
CAMERA_SIZES = {WIDTH: 'width', HEIGHT: 'height', FPS: 'fps'}


class _FileSource:
    """Reads the frames of a video in order."""

    def __init__(self, video):
        self.video = video
        self.at = 0
        first = video.frame(0)
        self.shape = (0, 0) if first is None else first.shape[:2]

    def next(self):
        if self.at >= self.video.count:
            return None
        self.at += 1
        return self.video.frame(self.at - 1)

    def get(self, prop):
        video = self.video
        milliseconds = 1000 * max(0, self.at - 1) / video.fps if video.fps else 0.0
        return float({
            POS_MSEC: milliseconds, POS_FRAMES: self.at, WIDTH: self.shape[1], HEIGHT: self.shape[0], FPS: video.fps,
            FOURCC: video.fourcc, COUNT: video.count}.get(prop, 0.0))

    def set(self, prop, value):
        if prop != POS_FRAMES:
            return False
        self.at = max(0, min(int(value), self.video.count))
        return True

    def close(self):
        self.video.close()


class _CameraSource:
    def __init__(self, camera):
        self.camera = camera

    def next(self):
        return self.camera.next()

    def get(self, prop):
        return self.camera.get(CAMERA_SIZES[prop]) if prop in CAMERA_SIZES else 0.0

    def set(self, prop, value):
        return prop in CAMERA_SIZES and value > 0 and self.camera.set(CAMERA_SIZES[prop], value)

    def close(self):
        self.camera.close()


def _source(wanted):
    if isinstance(wanted, int):
        camera = open_camera(wanted) if wanted >= 0 else None
        return None if camera is None else _CameraSource(camera)
    name = os.fspath(wanted)
    video = open_video(name)
    if video is None:
        print(
            f'[ WARN] cv2.VideoCapture({name!r}): the file is not opened. Sites read AVI files with MJPEG, and '
            'numbered pictures (img_%03d.png)', file=sys.stderr, flush=True)
        return None
    return _FileSource(video)


class VideoCapture:
    """A camera of the visitor, or a video file."""

    def __init__(self, *source, **named):
        self._source = None
        self._grabbed = None
        self._raises = False
        if source or named:
            self.open(*source, **named)

    def open(self, *source, **named):
        wanted = source[0] if source else named.get('filename', named.get('index'))
        self.release()
        self._source = _source(wanted)
        if self._source is None and self._raises:
            raise error(
                "OpenCV(4.13.0) error: (-2:Unspecified error) could not open the source in function 'open'", -2, 'open')
        return self.isOpened()

    def isOpened(self):
        return self._source is not None

    def grab(self):
        self._grabbed = None if self._source is None else self._source.next()
        return self._grabbed is not None

    def retrieve(self, image=None, flag=0):
        if self._grabbed is None:
            return False, None
        if image is None:
            return True, self._grabbed.copy()
        image[...] = self._grabbed
        return True, image

    def read(self, image=None):
        return self.retrieve(image) if self.grab() else (False, None)

    def get(self, propId):
        return 0.0 if self._source is None else self._source.get(propId)

    def set(self, propId, value):
        return self._source is not None and self._source.set(propId, value)

    def release(self):
        if self._source is not None:
            self._source.close()
        self._source = self._grabbed = None

    def getBackendName(self):
        return 'ROS2WASM'

    def setExceptionMode(self, enable):
        self._raises = bool(enable)

    def getExceptionMode(self):
        return self._raises

    def __del__(self):
        if sys.meta_path is not None:
            self.release()


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
