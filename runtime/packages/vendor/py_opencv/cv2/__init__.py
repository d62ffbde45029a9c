"""OpenCV 4.13, as npm's OpenCV.js is built of it, with the parameters and results of OpenCV's own Python module.

Windows are panels of the page, and the camera is the visitor's. Some functions are missing: a workspace that uses one
of them gets Pyodide's opencv-python instead.
"""
import numpy as _numpy
from cv2._call import CONSTANTS as _CONSTANTS
from cv2._call import FUNCTIONS as _FUNCTIONS
from cv2._call import DMatch, KeyPoint, error  # noqa: F401
from cv2._call import ask as _ask
from cv2._call import ask_object as _ask_object
from cv2._call import make as _make
from cv2._call import wrap as _wrap
from cv2 import aruco  # noqa: F401
from cv2._capture import VideoCapture, VideoWriter, VideoWriter_fourcc  # noqa: F401
from cv2._codecs import (  # noqa: F401
    IMREAD_ANYCOLOR, IMREAD_ANYDEPTH, IMREAD_COLOR, IMREAD_GRAYSCALE, IMREAD_UNCHANGED, IMWRITE_JPEG_QUALITY,
    haveImageReader, haveImageWriter, imdecode, imencode, imread, imwrite)
from cv2._codecs import IMREAD_RGB as IMREAD_COLOR_RGB  # noqa: F401
from cv2._lenses import calibrateCamera, cornerSubPix, getOptimalNewCameraMatrix, undistortPoints  # noqa: F401
from cv2._more import (  # noqa: F401
    KalmanFilter, accumulate, accumulateSquare, accumulateWeighted, extractChannel, findNonZero, hasNonZero, idft,
    insertChannel, mixChannels, sort)
from cv2._windows import (  # noqa: F401
    createTrackbar, destroyAllWindows, destroyWindow, getTrackbarPos, getWindowProperty, imshow, moveWindow,
    namedWindow, pollKey, resizeWindow, setMouseCallback, setTrackbarPos, setWindowProperty, setWindowTitle, waitKey,
    waitKeyEx)

__version__ = '4.13.0'

globals().update({
    name: value for name, value in _CONSTANTS.items() if not name.lower().startswith(('aruco_', 'dict_'))})
globals().update({
    name: function for name, function in _FUNCTIONS.items() if name not in ('ellipse1', 'rectangle1', 'norm1')})

#: Those of imgcodecs, highgui and videoio, which OpenCV.js is built without.
IMREAD_COLOR_BGR = IMREAD_COLOR
IMWRITE_PNG_COMPRESSION = 16
WINDOW_NORMAL, WINDOW_AUTOSIZE, WINDOW_FREERATIO, WINDOW_KEEPRATIO, WINDOW_FULLSCREEN = 0, 1, 256, 0, 1
WINDOW_GUI_EXPANDED, WINDOW_GUI_NORMAL = 0, 16
EVENT_MOUSEMOVE, EVENT_LBUTTONDOWN, EVENT_RBUTTONDOWN, EVENT_MBUTTONDOWN = 0, 1, 2, 3
EVENT_LBUTTONUP, EVENT_RBUTTONUP, EVENT_MBUTTONUP, EVENT_LBUTTONDBLCLK = 4, 5, 6, 7
EVENT_FLAG_LBUTTON, EVENT_FLAG_RBUTTON, EVENT_FLAG_MBUTTON = 1, 2, 4
EVENT_FLAG_CTRLKEY, EVENT_FLAG_SHIFTKEY, EVENT_FLAG_ALTKEY = 8, 16, 32
WND_PROP_FULLSCREEN, WND_PROP_AUTOSIZE, WND_PROP_ASPECT_RATIO, WND_PROP_VISIBLE = 0, 1, 2, 4
CAP_PROP_POS_MSEC, CAP_PROP_POS_FRAMES, CAP_PROP_FRAME_WIDTH, CAP_PROP_FRAME_HEIGHT, CAP_PROP_FPS = 0, 1, 3, 4, 5
CAP_PROP_FOURCC, CAP_PROP_FRAME_COUNT, CAP_PROP_BRIGHTNESS, CAP_PROP_BUFFERSIZE, CAP_PROP_AUTOFOCUS = 6, 7, 10, 38, 39
CAP_ANY, CAP_V4L, CAP_V4L2, CAP_GSTREAMER, CAP_FFMPEG, CAP_DSHOW, CAP_MSMF = 0, 200, 200, 1800, 1900, 700, 1400
CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F, CV_16F = range(8)


def rectangle(img, *values, **named):
    first = values[0] if values else named.get('pt1', named.get('rec'))
    whole = 'rec' in named or (first is not None and len(first) == 4)
    return _FUNCTIONS['rectangle1' if whole else 'rectangle'](img, *values, **named)


def ellipse(img, *values, **named):
    boxed = 'box' in named or (bool(values) and len(values[0]) == 3)
    return _FUNCTIONS['ellipse1' if boxed else 'ellipse'](img, *values, **named)


def norm(src1, *values, **named):
    second = values[0] if values else named.get('src2')
    return _FUNCTIONS['norm1' if isinstance(second, _numpy.ndarray) else 'norm'](src1, *values, **named)


def boxPoints(box, points=None):
    result = _FUNCTIONS['rotatedRectangleIntersection'].parameters[0].written(box, 'boxPoints', [])
    return _numpy.array([(one['x'], one['y']) for one in _ask('boxPoints', result)], 'float32')


def phase(x, y, angle=None, angleInDegrees=False):
    return _FUNCTIONS['cartToPolar'](x, y, angleInDegrees=angleInDegrees)[1]


#: Lines above and below the base line of a font, in units of its scale 1.
_LINES = {1: (4, 5), 5: (7, 6)}
_USUAL_LINES = (12, 9)
_advances = {}


def _advance(font, letter):
    """By how much a letter moves the next one at scale 1: it is measured, as OpenCV.js does not tell."""
    scale = 4
    if (font, letter) not in _advances:
        right = []
        for text in (letter + '|', '|'):
            picture = _numpy.zeros((60 * scale, 100 * scale), 'uint8')
            _FUNCTIONS['putText'](picture, text, (20 * scale, 40 * scale), font, float(scale), 255)
            right.append(int(_numpy.flatnonzero(picture.any(axis=0))[-1]))
        _advances[font, letter] = round((right[0] - right[1]) / scale)
    return _advances[font, letter]


def getTextSize(text, fontFace, fontScale, thickness):
    above, below = _LINES.get(fontFace & 15, _USUAL_LINES)
    letters = [one if ' ' <= one < '\x7f' else '?' for one in text]
    width = sum(_advance(fontFace, one) * fontScale for one in letters)
    height = (above + below) * fontScale + (thickness + 1) // 2
    return (round(width + thickness), round(height)), round(below * fontScale + thickness * 0.5)


def getNumThreads():
    return 1


def setNumThreads(nthreads):
    """There is one."""


def useOptimized():
    return True


def setUseOptimized(onoff):
    """As it is built."""


def getTickCount():
    import time
    return time.perf_counter_ns()


def getTickFrequency():
    return 1e9


def _creator(name):
    def create(*values, **named):
        return _make(name, *values, **named)
    create.__name__ = name + '_create'
    return create


for _name in ('ORB', 'AKAZE', 'BRISK', 'KAZE', 'FastFeatureDetector', 'GFTTDetector'):
    globals()[_name + '_create'] = _creator(_name)
BFMatcher = BFMatcher_create = _creator('BFMatcher')
QRCodeDetector = _creator('QRCodeDetector')
createCLAHE = _creator('CLAHE')
createBackgroundSubtractorMOG2 = _creator('BackgroundSubtractorMOG2')


def SimpleBlobDetector_Params():
    return _wrap('SimpleBlobDetector_Params', _ask_object(_make('SimpleBlobDetector'), 'getParams'))


def SimpleBlobDetector_create(parameters=None):
    detector = _make('SimpleBlobDetector')
    if parameters is not None:
        detector.setParams(parameters)
    return detector


SimpleBlobDetector = SimpleBlobDetector_create


def _missing(name):
    return (f"the channel's cv2 has no '{name}'; Pyodide's opencv-python may have it: "
            'write `python: packages: [opencv-python]` in workspace.yaml')


def __getattr__(name):
    if name.startswith('__'):
        raise AttributeError(f"module 'cv2' has no attribute '{name}'")
    raise AttributeError(f"module 'cv2' has no attribute '{name}': {_missing(name)}")
