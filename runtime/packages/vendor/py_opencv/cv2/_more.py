"""Functions that OpenCV.js does not have, and that need no more than numpy."""
import numpy
from cv2._call import error


class KalmanFilter:
    """The filter of OpenCV, with its names."""

    def __init__(self, dynamParams=0, measureParams=0, controlParams=0, type=5):
        kind = {5: 'float32', 6: 'float64'}[type]

        def zeros(*shape):
            return numpy.zeros(shape, kind)

        self.statePre = zeros(dynamParams, 1)
        self.statePost = zeros(dynamParams, 1)
        self.transitionMatrix = numpy.eye(dynamParams, dtype=kind)
        self.controlMatrix = zeros(dynamParams, controlParams) if controlParams > 0 else None
        self.measurementMatrix = zeros(measureParams, dynamParams)
        self.processNoiseCov = numpy.eye(dynamParams, dtype=kind)
        self.measurementNoiseCov = numpy.eye(measureParams, dtype=kind)
        self.errorCovPre = zeros(dynamParams, dynamParams)
        self.errorCovPost = zeros(dynamParams, dynamParams)
        self.gain = zeros(dynamParams, measureParams)

    def predict(self, control=None):
        self.statePre = self.transitionMatrix @ self.statePost
        if control is not None:
            self.statePre = self.statePre + self.controlMatrix @ control
        self.errorCovPre = self.transitionMatrix @ self.errorCovPost @ self.transitionMatrix.T + self.processNoiseCov
        self.statePost = self.statePre.copy()
        self.errorCovPost = self.errorCovPre.copy()
        return self.statePre

    def correct(self, measurement):
        seen = self.measurementMatrix @ self.errorCovPre
        spread = seen @ self.measurementMatrix.T + self.measurementNoiseCov
        self.gain = numpy.linalg.solve(spread, seen).T
        self.statePost = self.statePre + self.gain @ (
            numpy.asarray(measurement).reshape(-1, 1) - self.measurementMatrix @ self.statePre)
        self.errorCovPost = self.errorCovPre - self.gain @ seen
        return self.statePost


def findNonZero(src, idx=None):
    rows, columns = numpy.nonzero(src)
    return numpy.stack([columns, rows], axis=1).astype('int32').reshape(-1, 1, 2) if len(rows) else None


def hasNonZero(src):
    return bool(numpy.any(src))


def extractChannel(src, coi, dst=None):
    return numpy.ascontiguousarray(src[:, :, coi] if src.ndim > 2 else src)


def insertChannel(src, dst, coi):
    dst[:, :, coi] = src
    return dst


def _masked(target, values, mask):
    if mask is None:
        target[...] = values
    else:
        target[mask != 0] = values[mask != 0]
    return target


def accumulate(src, dst, mask=None):
    return _masked(dst, dst + src, mask)


def accumulateSquare(src, dst, mask=None):
    return _masked(dst, dst + numpy.square(src, dtype=dst.dtype), mask)


def accumulateWeighted(src, dst, alpha, mask=None):
    return _masked(dst, dst * (1 - alpha) + numpy.asarray(src, dst.dtype) * alpha, mask)


def mixChannels(src, dst, fromTo):
    pairs = [int(one) for one in fromTo]
    if len(pairs) % 2:
        raise error('OpenCV(4.13.0) error: (-215:Assertion failed) fromTo.size()%2 == 0', -215, 'mixChannels')

    def channel(arrays, number):
        for one in arrays:
            count = one.shape[2] if one.ndim > 2 else 1
            if number < count:
                return one if one.ndim < 3 else one[:, :, number]
            number -= count
        raise error('OpenCV(4.13.0) error: (-215:Assertion failed) j < nsrcs', -215, 'mixChannels')

    for source, target in zip(pairs[::2], pairs[1::2]):
        channel(dst, target)[...] = 0 if source < 0 else channel(src, source)
    return tuple(dst)


def sort(src, flags, dst=None):
    result = numpy.sort(src, axis=0 if flags & 1 else 1)
    return numpy.ascontiguousarray(numpy.flip(result, 0 if flags & 1 else 1)) if flags & 16 else result


def idft(src, dst=None, flags=0, nonzeroRows=0):
    import cv2
    return cv2.dft(src, flags=flags | 1, nonzeroRows=nonzeroRows)
