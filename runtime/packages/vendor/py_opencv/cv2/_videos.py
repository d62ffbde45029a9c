"""Videos for cv2.VideoCapture: AVI files with a JPEG in each frame, and numbered pictures (img_%03d.png)."""
import os
import re
import struct

import numpy
from cv2._codecs import IMREAD_COLOR, haveImageReader, imdecode, imread

#: Upper bound on nested lists of a RIFF file.
MOST_DEPTH = 4
#: Upper bound on the first number of numbered pictures.
MOST_FIRST = 100
MJPEG = (b'MJPG', b'mjpg', b'AVRn', b'dmb1')


class Video:
    """Frames by number; None for a frame that cannot be read."""

    fourcc = 0
    fps = 0.0
    count = 0

    def frame(self, number):
        raise NotImplementedError

    def close(self):
        """Nothing is open."""


class NumberedPictures(Video):
    """One file per frame, at OpenCV's frame rate for pictures."""

    fps = 25.0

    def __init__(self, pattern, first, count):
        self.pattern, self.first, self.count = pattern, first, count

    def frame(self, number):
        return imread(self.pattern % (self.first + number))


class OnePicture(Video):
    """A single picture is a video of one frame."""

    fps = 25.0
    count = 1

    def __init__(self, name):
        self.name = name

    def frame(self, number):
        return imread(self.name)


class AviVideo(Video):
    def __init__(self, file, frames, fourcc, fps):
        self.file, self.frames = file, frames
        self.fourcc = int.from_bytes(fourcc, 'little')
        self.fps = fps
        self.count = len(frames)

    def frame(self, number):
        at, size = self.frames[number]
        self.file.seek(at)
        return imdecode(numpy.frombuffer(self.file.read(size), 'uint8'), IMREAD_COLOR)

    def close(self):
        self.file.close()


def numbered_pictures(pattern):
    """Returns None if the name has no field for a number, or no picture has such a name."""
    if not re.fullmatch(r'[^%]*%(0?\d{1,2})?d[^%]*', pattern):
        return None
    first = next((number for number in range(MOST_FIRST + 1) if os.path.exists(pattern % number)), None)
    if first is None or not haveImageReader(pattern % first):
        return None
    count = 1
    while os.path.exists(pattern % (first + count)):
        count += 1
    return NumberedPictures(pattern, first, count)


class _AviReader:
    """Finds the frames of the first video stream. Raises ValueError if the file is not valid."""

    def __init__(self, file):
        self.file = file
        self.end = file.seek(0, os.SEEK_END)
        self.streams = 0
        self.video = None
        self.fourcc = b''
        self.fps = 0.0
        self.frames = []

    def read(self):
        self.parts(0, self.end, 0)
        if self.video is None or not self.frames:
            raise ValueError
        return self

    def parts(self, at, end, depth):
        end = min(end, self.end)
        while at + 8 <= end:
            self.file.seek(at)
            name, size = struct.unpack('<4sI', self.file.read(8))
            inner = at + 8
            if name in (b'RIFF', b'LIST'):
                if depth >= MOST_DEPTH:
                    raise ValueError
                kind = self.file.read(4)
                if name == b'RIFF' and kind not in (b'AVI ', b'AVIX'):
                    raise ValueError
                if kind != b'INFO':
                    self.parts(inner + 4, inner + size, depth + 1)
            elif depth == 0:
                raise ValueError
            else:
                self.part(name, inner, min(size, self.end - inner))
            at = inner + size + (size & 1)

    def part(self, name, at, size):
        if name == b'strh' and size >= 32:
            head = self.file.read(32)
            scale, rate = struct.unpack_from('<II', head, 20)
            if head[:4] == b'vids' and self.video is None:
                self.video = b'%02d' % self.streams
                self.fourcc = head[4:8]
                self.fps = rate / scale if scale else 0.0
            self.streams += 1
        elif name == b'strf' and size >= 20 and self.video == b'%02d' % (self.streams - 1):
            self.fourcc = self.file.read(20)[16:20]
        elif self.video is not None and name in (self.video + b'dc', self.video + b'db') and size > 0:
            self.frames.append((at, size))


def avi(name):
    """Returns None if the file is not an AVI file, or its frames are not JPEG."""
    file = open(name, 'rb')
    try:
        found = _AviReader(file).read()
        if found.fourcc not in MJPEG:
            raise ValueError
        return AviVideo(file, found.frames, found.fourcc, found.fps)
    except (ValueError, struct.error):
        file.close()
        return None


def open_video(name):
    """Returns None if the file is missing or has another format."""
    if os.path.isfile(name):
        return avi(name) or (OnePicture(name) if haveImageReader(name) else None)
    return numbered_pictures(name)
