"""Points of cameras with a lens, corners between pixels, calibration: what OpenCV.js has not, or in another form."""
import cv2
import numpy
from cv2._call import Function, error

#: Steps of the search for the place that distortion moves to a given one, as OpenCV takes them.
UNDISTORT_STEPS = 5
#: Points of a picture's edge whose places bound it, along a side.
GRID = 9


def undistortPoints(src, cameraMatrix, distCoeffs, dst=None, R=None, P=None):
    points = numpy.asarray(src)
    kind = 'float64' if points.dtype == 'float64' else 'float32'
    matrix = numpy.asarray(cameraMatrix, 'float64')
    k = numpy.zeros(14)
    if distCoeffs is not None:
        given = numpy.asarray(distCoeffs, 'float64').ravel()
        k[:len(given)] = given
    flat = points.reshape(-1, 2).astype('float64')
    x0 = (flat[:, 0] - matrix[0, 2]) / matrix[0, 0]
    y0 = (flat[:, 1] - matrix[1, 2]) / matrix[1, 1]
    x, y = x0.copy(), y0.copy()
    if k.any():
        for _ in range(UNDISTORT_STEPS):
            r2 = x * x + y * y
            inverse = (1 + ((k[7] * r2 + k[6]) * r2 + k[5]) * r2) / (1 + ((k[4] * r2 + k[1]) * r2 + k[0]) * r2)
            across = 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x) + k[8] * r2 + k[9] * r2 * r2
            down = k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y + k[10] * r2 + k[11] * r2 * r2
            # Where the distortion folds the picture there is not one place.
            whole = inverse >= 0
            x = numpy.where(whole, (x0 - across) * inverse, x0)
            y = numpy.where(whole, (y0 - down) * inverse, y0)
    turn = numpy.eye(3) if R is None else numpy.asarray(R, 'float64').reshape(3, 3)
    if P is not None:
        turn = numpy.asarray(P, 'float64')[:3, :3] @ turn
    seen = turn @ numpy.stack([x, y, numpy.ones_like(x)])
    return (seen[:2] / seen[2]).T.reshape(-1, 1, 2).astype(kind)


def _rectangles(cameraMatrix, distCoeffs, size, matrix):
    """The largest upright rectangle within the undistorted picture, and the least one around it.

    Both are left, top, width and height.
    """
    rows, columns = numpy.mgrid[0:GRID, 0:GRID]
    grid = numpy.stack([columns * size[0] / (GRID - 1), rows * size[1] / (GRID - 1)], axis=2).astype('float32')
    places = undistortPoints(grid, cameraMatrix, distCoeffs, P=matrix).reshape(GRID, GRID, 2)
    x, y = places[:, :, 0], places[:, :, 1]
    left, right, top, bottom = x[:, 0].max(), x[:, -1].min(), y[0].max(), y[-1].min()
    return (left, top, right - left, bottom - top), (x.min(), y.min(), x.max() - x.min(), y.max() - y.min())


def getOptimalNewCameraMatrix(cameraMatrix, distCoeffs, imageSize, alpha, newImgSize=(0, 0),
                              centerPrincipalPoint=False):
    if centerPrincipalPoint:
        raise error('OpenCV(4.13.0) error: (-213) this cv2 has no centred principal point', -213,
                    'getOptimalNewCameraMatrix')
    width, height = imageSize if tuple(newImgSize) == (0, 0) else newImgSize
    inner, outer = _rectangles(cameraMatrix, distCoeffs, imageSize, None)
    fx0, fx1 = ((width - 1) / box[2] for box in (inner, outer))
    fy0, fy1 = ((height - 1) / box[3] for box in (inner, outer))
    matrix = numpy.array(cameraMatrix, 'float64')
    matrix[0, 0] = fx0 * (1 - alpha) + fx1 * alpha
    matrix[1, 1] = fy0 * (1 - alpha) + fy1 * alpha
    matrix[0, 2] = -fx0 * inner[0] * (1 - alpha) - fx1 * outer[0] * alpha
    matrix[1, 2] = -fy0 * inner[1] * (1 - alpha) - fy1 * outer[1] * alpha
    seen = _rectangles(cameraMatrix, distCoeffs, imageSize, matrix)[0]
    left, top, wide, high = (int(round(float(one))) for one in seen)
    right, bottom = min(left + wide, width), min(top + high, height)
    left, top = max(left, 0), max(top, 0)
    region = (left, top, right - left, bottom - top) if right > left and bottom > top else (0, 0, 0, 0)
    return matrix, region


#: Most steps for a corner.
CORNER_STEPS = 100
FLOAT = 5


def cornerSubPix(image, corners, winSize, zeroZone, criteria):
    """Moves each corner to where the gradients around it are at right angles to the way from it.

    `corners` is changed.
    """
    kind, most, least = criteria
    steps = min(max(int(most), 1), CORNER_STEPS) if kind & 1 else CORNER_STEPS
    near = max(least, 0) ** 2 if kind & 2 else 0
    wide, high = winSize
    across = (numpy.arange(-wide, wide + 1) / wide).astype('float32')
    down = (numpy.arange(-high, high + 1) / high).astype('float32')
    weights = numpy.exp(-down * down)[:, None] * numpy.exp(-across * across)[None, :]
    if zeroZone[0] >= 0 and zeroZone[1] >= 0 and zeroZone[0] < wide and zeroZone[1] < high:
        weights[high - zeroZone[1]:high + zeroZone[1] + 1, wide - zeroZone[0]:wide + zeroZone[0] + 1] = 0
    x, y = numpy.meshgrid(numpy.arange(-wide, wide + 1), numpy.arange(-high, high + 1))
    rows, columns = image.shape[:2]
    places = corners.reshape(-1, 2)
    for place in places:
        first = at = place.astype('float64')
        for _ in range(steps):
            window = (2 * wide + 3, 2 * high + 3)
            patch = cv2.getRectSubPix(image, window, (float(at[0]), float(at[1])), patchType=FLOAT).astype('float64')
            right, below = patch[1:-1, 2:] - patch[1:-1, :-2], patch[2:, 1:-1] - patch[:-2, 1:-1]
            xx, xy, yy = right * right * weights, right * below * weights, below * below * weights
            a, b, c = xx.sum(), xy.sum(), yy.sum()
            determinant = a * c - b * b
            if abs(determinant) <= numpy.finfo('float64').eps ** 2:
                break
            u, v = (xx * x + xy * y).sum(), (xy * x + yy * y).sum()
            moved = at + numpy.array([c * u - b * v, a * v - b * u]) / determinant
            gone = ((moved - at) ** 2).sum()
            at = moved
            if not (0 <= at[0] < columns and 0 <= at[1] < rows) or gone <= near:
                break
        place[:] = first if abs(at[0] - first[0]) > wide or abs(at[1] - first[1]) > high else at
    return corners


#: OpenCV.js has the form with all results only.
_calibrate = Function('calibrateCameraExtended', (
    'objectPoints:mats, imagePoints:mats, imageSize:size, &cameraMatrix, &distCoeffs, >rvecs:mats, >tvecs:mats, '
    '>stdDeviationsIntrinsics, >stdDeviationsExtrinsics, >perViewErrors, flags:int=0, '
    'criteria:term=(3,30,2.220446049250313e-16) -> float'))


def calibrateCamera(objectPoints, imagePoints, imageSize, cameraMatrix, distCoeffs, rvecs=None, tvecs=None, flags=0,
                    criteria=(3, 30, 2.220446049250313e-16)):
    found = _calibrate(objectPoints, imagePoints, imageSize, cameraMatrix, distCoeffs, flags=flags, criteria=criteria)
    return found[:5]
