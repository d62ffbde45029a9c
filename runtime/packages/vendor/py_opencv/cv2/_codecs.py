"""Files of pictures: PNG and JPEG by libraries of JavaScript, PNM and BMP here."""
import json
import os
import re

import numpy
import ros2wasm_host
import cv2
from cv2._call import READERS, _address, _array, _head, error

IMREAD_UNCHANGED, IMREAD_GRAYSCALE = -1, 0
IMREAD_ANYDEPTH = 2
IMREAD_COLOR = 1
IMREAD_ANYCOLOR = 4
IMREAD_RGB = 256
IMWRITE_JPEG_QUALITY = 1
WRITERS = ('.png', '.jpg', '.jpeg', '.jpe', '.bmp', '.dib', '.pgm', '.ppm', '.pbm', '.pnm')


def _gray_of_png(picture):
    """As libpng makes it: cut, not rounded."""
    blue, green, red = (picture[:, :, channel].astype('uint32') for channel in range(3))
    return ((red * 9798 + green * 19235 + blue * 3735) >> 15).astype(picture.dtype)


def _as_asked(picture, flags, data):
    """The picture in the form that the flags of imread() ask for. `data` is the file."""
    if picture is None or flags == IMREAD_UNCHANGED:
        return picture
    if picture.dtype == 'uint16' and not flags & IMREAD_ANYDEPTH:
        picture = (picture >> 8).astype('uint8')
    channels = picture.shape[2] if picture.ndim > 2 else 1
    if flags & IMREAD_ANYCOLOR and channels == 1 and not flags & IMREAD_COLOR:
        return picture
    if not flags & (IMREAD_COLOR | IMREAD_ANYCOLOR | IMREAD_RGB):
        if channels > 1 and data[:4] == b'\x89PNG':
            return _gray_of_png(picture)
        if channels == 1:
            return picture
        return cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY if channels == 3 else cv2.COLOR_BGRA2GRAY)
    if channels == 1:
        picture = cv2.cvtColor(picture, cv2.COLOR_GRAY2BGR)
    elif channels == 4:
        picture = cv2.cvtColor(picture, cv2.COLOR_BGRA2BGR)
    return cv2.cvtColor(picture, cv2.COLOR_BGR2RGB) if flags & IMREAD_RGB else picture


def _pnm(data):
    """P1 to P6, as maps have them."""
    tokens = re.match(rb'P([1-6])((?:\s|#[^\n]*\n)+)', data)
    kind = int(tokens.group(1))
    at = tokens.end()
    numbers = []
    while len(numbers) < (2 if kind in (1, 4) else 3):
        found = re.compile(rb'(?:\s|#[^\n]*\n)*(\d+)').match(data, at)
        numbers.append(int(found.group(1)))
        at = found.end()
    width, height = numbers[:2]
    most = numbers[2] if len(numbers) > 2 else 1
    channels = 3 if kind in (3, 6) else 1
    count = width * height * channels
    if kind == 4:
        rows = numpy.frombuffer(data, 'uint8', (width + 7) // 8 * height, at + 1).reshape(height, -1)
        values = 1 - numpy.unpackbits(rows, axis=1)[:, :width]
    elif kind in (5, 6):
        values = numpy.frombuffer(data, 'uint8' if most < 256 else '>u2', count, at + 1)
    else:
        text = re.sub(rb'#[^\n]*', b'', data[at:])
        plain = [int(one) for one in (re.findall(rb'[01]', text) if kind == 1 else text.split())][:count]
        values = numpy.array(plain)
        values = 1 - values if kind == 1 else values
    values = values.reshape((height, width) if channels == 1 else (height, width, 3))
    values = values.astype('uint16' if most > 255 else 'uint8')
    if most == 1:
        values *= 255
    return values if channels == 1 else numpy.ascontiguousarray(values[:, :, ::-1])


def _bmp(data):
    """With 8, 24 or 32 bits and without compression."""
    def number(place, size=4, signed=False):
        return int.from_bytes(data[place:place + size], 'little', signed=signed)
    begin, header, bits = number(10), number(14), number(28, 2)
    width, height = number(18, signed=True), number(22, signed=True)
    if bits not in (8, 24, 32) or number(30) not in (0, 3):
        return None
    stride = (width * bits // 8 + 3) & ~3
    rows = numpy.frombuffer(data, 'uint8', stride * abs(height), begin)
    rows = rows.reshape(abs(height), stride)[:, :width * bits // 8]
    picture = rows if height < 0 else rows[::-1]
    if bits == 8:
        colors = numpy.frombuffer(data, 'uint8', (number(46) or 256) * 4, 14 + header).reshape(-1, 4)[:, :3]
        picture = colors[picture]
        gray = (colors[:, 0] == colors[:, 1]).all() and (colors[:, 1] == colors[:, 2]).all()
        return numpy.ascontiguousarray(picture[:, :, 0] if gray else picture)
    picture = picture.reshape(abs(height), width, bits // 8)
    return numpy.ascontiguousarray(picture[:, :, :3])


def _decoded(data):
    """None: it is not a picture that can be read."""
    try:
        if re.match(rb'P[1-6]\s', data):
            return _pnm(data)
        if data[:2] == b'BM':
            return _bmp(data)
    except (AttributeError, ValueError, IndexError, OverflowError):
        return None
    whole = numpy.frombuffer(data, 'uint8')
    answer = json.loads(ros2wasm_host.opencv.decode(_address(whole), whole.size))
    return READERS['array'](answer) if 'm' in answer else None


def imdecode(buf, flags=IMREAD_COLOR):
    data = numpy.ascontiguousarray(buf, 'uint8').tobytes() if isinstance(buf, numpy.ndarray) else bytes(buf)
    if not data:
        raise error(
            "OpenCV(4.13.0) error: (-215:Assertion failed) !buf.empty() in function 'imdecode_'", -215, 'imdecode_')
    return _as_asked(_decoded(data), flags, data)


def imread(filename, flags=IMREAD_COLOR):
    try:
        with open(filename, 'rb') as file:
            data = file.read()
    except OSError:
        print(
            f"[ WARN] global loadsave.cpp imread_('{filename}'): can't open/read file: check file path/integrity",
            flush=True)
        return None
    return _as_asked(_decoded(data), flags, data) if data else None


def _encoded(ending, picture, params):
    options = dict(zip(params[::2], params[1::2]))
    channels = picture.shape[2] if picture.ndim > 2 else 1
    height, width = picture.shape[:2]
    if ending in ('.pgm', '.ppm', '.pbm', '.pnm'):
        if picture.dtype not in ('uint8', 'uint16'):
            picture = numpy.clip(numpy.rint(picture), 0, 255).astype('uint8')
        most = 255 if picture.dtype == 'uint8' else 65535
        pixels = picture if channels == 1 else picture[:, :, 2::-1]
        head = f'P{5 if channels == 1 else 6}\n{width} {height}\n{most}\n'.encode()
        return head + pixels.astype('uint8' if most == 255 else '>u2').tobytes()
    if picture.dtype == 'uint16' and ending != '.png':
        picture = (picture >> 8).astype('uint8')
    if picture.dtype not in ('uint8', 'uint16'):
        picture = numpy.clip(numpy.rint(picture), 0, 255).astype('uint8')
    if ending in ('.bmp', '.dib'):
        if channels == 1:
            picture = cv2.cvtColor(picture, cv2.COLOR_GRAY2BGR)
        rows = numpy.zeros((height, (width * 3 + 3) & ~3), 'uint8')
        rows[:, :width * 3] = picture[::-1, :, :3].reshape(height, -1)
        sizes = [
            (rows.size + 54, 4), (0, 4), (54, 4), (40, 4), (width, 4), (height, 4), (1, 2), (24, 2), (0, 4),
            (rows.size, 4)]
        return b'BM' + b''.join(value.to_bytes(size, 'little') for value, size in sizes) + bytes(16) + rows.tobytes()
    picture = numpy.ascontiguousarray(picture)
    quality = int(options.get(IMWRITE_JPEG_QUALITY, 95))
    answer = json.loads(ros2wasm_host.opencv.encode(ending, _address(picture), *_head(picture), quality))
    return READERS['array'](answer).tobytes()


def imencode(ext, img, params=()):
    ending = ext.lower()
    if ending not in WRITERS:
        raise error(
            'OpenCV(4.13.0) error: (-2:Unspecified error) could not find encoder for the specified extension '
            "in function 'imencode'", -2, 'imencode')
    picture = _array(img, 'imencode', 'img')
    if picture.size == 0:
        raise error(
            "OpenCV(4.13.0) error: (-215:Assertion failed) !image.empty() in function 'imencode'", -215, 'imencode')
    return True, numpy.frombuffer(_encoded(ending, picture, params), 'uint8')


def imwrite(filename, img, params=()):
    ending = os.path.splitext(str(filename))[1].lower()
    if ending not in WRITERS:
        raise error(
            'OpenCV(4.13.0) error: (-2:Unspecified error) could not find a writer for the specified extension '
            "in function 'imwrite_'", -2, 'imwrite_')
    if not isinstance(img, numpy.ndarray) or img.size == 0:
        raise error(
            "OpenCV(4.13.0) error: (-215:Assertion failed) !_img.empty() in function 'imwrite'", -215, 'imwrite')
    data = _encoded(ending, _array(img, 'imwrite', 'img'), params)
    try:
        with open(filename, 'wb') as file:
            file.write(data)
    except OSError:
        return False
    return True


def haveImageReader(filename):
    try:
        with open(filename, 'rb') as file:
            return _decoded(file.read()) is not None
    except OSError:
        return False


def haveImageWriter(filename):
    return os.path.splitext(str(filename))[1].lower() in WRITERS
