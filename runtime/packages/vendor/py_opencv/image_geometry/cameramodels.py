import copy
import math

import cv2
import numpy


def mkmat(rows, cols, L):
    """A matrix of these numbers, row by row."""
    return numpy.matrix(numpy.reshape(numpy.asarray(L, dtype='float64'), (rows, cols)))


class PinholeCameraModel:
    """A camera without a lens, and the distortion that a real one adds. Pixels are those of the rectified picture."""

    def __init__(self):
        self.K = self.D = self.R = self.P = None
        self.full_K = self.full_P = None
        self.width = self.height = None
        self.binning_x = self.binning_y = None
        self.raw_roi = None
        self.tf_frame = None
        self.stamp = None

    def fromCameraInfo(self, msg):
        """Takes the calibration of a sensor_msgs/msg/CameraInfo, with its binning and region of interest."""
        self.full_K, self.full_P = mkmat(3, 3, msg.k), mkmat(3, 4, msg.p)
        self.K, self.P = self.full_K.copy(), self.full_P.copy()
        self.D = mkmat(len(msg.d), 1, msg.d) if len(msg.d) else None
        self.R = mkmat(3, 3, msg.r)
        self.width, self.height = msg.width, msg.height
        self.resolution = (msg.width, msg.height)
        self.binning_x, self.binning_y = max(1, msg.binning_x), max(1, msg.binning_y)
        self.raw_roi = copy.copy(msg.roi)
        if not any((self.raw_roi.x_offset, self.raw_roi.y_offset, self.raw_roi.width, self.raw_roi.height)):
            self.raw_roi.width, self.raw_roi.height = self.width, self.height
        self.tf_frame = msg.header.frame_id
        self.stamp = msg.header.stamp
        for matrix in (self.K, self.P):
            for axis, (binning, offset) in enumerate(((self.binning_x, self.raw_roi.x_offset),
                                                      (self.binning_y, self.raw_roi.y_offset))):
                matrix[axis, axis] /= binning
                matrix[axis, 2] = (matrix[axis, 2] - offset) / binning

    def rectifyImage(self, raw, rectified):
        """Writes the picture without distortion into `rectified`."""
        size = (self.width, self.height)
        self.mapx, self.mapy = cv2.initUndistortRectifyMap(self.K, self.D, self.R, self.P[:, :3], size, cv2.CV_32FC1)
        cv2.remap(raw, self.mapx, self.mapy, cv2.INTER_CUBIC, rectified)

    def rectifyPoint(self, uv_raw):
        """The pixel of the rectified picture that shows what this pixel of the raw one shows."""
        raw = numpy.reshape(numpy.asarray(uv_raw, dtype='float64'), (1, 1, 2))
        return cv2.undistortPoints(raw, self.K, self.D, R=self.R, P=self.P)[0, 0]

    def project3dToPixel(self, point):
        """The pixel of a point (x, y, z) in the optical frame, in metres; nan for one in the camera's plane."""
        u, v, w = (float(one) for one in self.P @ numpy.array([*point[:3], 1.0]).reshape(4, 1))
        return (u / w, v / w) if w != 0 else (float('nan'), float('nan'))

    def projectPixelTo3dRay(self, uv):
        """The unit vector from the camera through a pixel."""
        x, y = (uv[0] - self.cx()) / self.fx(), (uv[1] - self.cy()) / self.fy()
        length = math.sqrt(x * x + y * y + 1)
        return (x / length, y / length, 1.0 / length)

    def getDeltaU(self, deltaX, Z):
        """Pixels to the right for metres to the right, at that depth."""
        return float('inf') if Z == 0 else self.P[0, 0] * deltaX / Z

    def getDeltaV(self, deltaY, Z):
        """Pixels down for metres down, at that depth."""
        return float('inf') if Z == 0 else self.P[1, 1] * deltaY / Z

    def getDeltaX(self, deltaU, Z):
        """Metres to the right for pixels to the right, at that depth."""
        return Z * deltaU / self.P[0, 0]

    def getDeltaY(self, deltaV, Z):
        """Metres down for pixels down, at that depth."""
        return Z * deltaV / self.P[1, 1]

    def fullResolution(self):
        """Width and height."""
        return self.resolution

    def intrinsicMatrix(self):
        return self.K

    def distortionCoeffs(self):
        return self.D

    def rotationMatrix(self):
        return self.R

    def projectionMatrix(self):
        return self.P

    def fullIntrinsicMatrix(self):
        return self.full_K

    def fullProjectionMatrix(self):
        return self.full_P

    def cx(self):
        return self.P[0, 2]

    def cy(self):
        return self.P[1, 2]

    def fx(self):
        return self.P[0, 0]

    def fy(self):
        return self.P[1, 1]

    def Tx(self):
        return self.P[0, 3]

    def Ty(self):
        return self.P[1, 3]

    def fovX(self):
        """The angle that the picture is wide, in radians."""
        return 2 * math.atan(self.width / (2 * self.fx()))

    def fovY(self):
        """The angle that the picture is high, in radians."""
        return 2 * math.atan(self.height / (2 * self.fy()))

    def tfFrame(self):
        """The frame of the CameraInfo."""
        return self.tf_frame


class StereoCameraModel:
    """Two cameras side by side, rectified; points are in the frame of the left one."""

    def __init__(self):
        self.left = PinholeCameraModel()
        self.right = PinholeCameraModel()

    def fromCameraInfo(self, left_msg, right_msg):
        self.left.fromCameraInfo(left_msg)
        self.right.fromCameraInfo(right_msg)
        P = self.right.P
        self.Q = numpy.zeros((4, 4), dtype='float64')
        self.Q[0, 0] = self.Q[1, 1] = 1.0
        self.Q[0, 3], self.Q[1, 3], self.Q[2, 3] = -P[0, 2], -P[1, 2], P[0, 0]
        self.Q[3, 2] = -P[0, 0] / P[0, 3]

    def tfFrame(self):
        return self.left.tfFrame()

    def project3dToPixel(self, point):
        """The pixels of a point in both pictures."""
        return (self.left.project3dToPixel(point), self.right.project3dToPixel(point))

    def projectPixelTo3d(self, left_uv, disparity):
        """The point of a pixel; at infinity, it is (0, 0, 0)."""
        x, y, z, w = (float(one) for one in self.Q @ numpy.array([left_uv[0], left_uv[1], disparity, 1.0]))
        return (x / w, y / w, z / w) if w != 0 else (0.0, 0.0, 0.0)

    def getZ(self, disparity):
        """The depth in metres of a disparity in pixels."""
        return float('inf') if disparity == 0 else -self.right.P[0, 3] / disparity

    def getDisparity(self, Z):
        """The disparity in pixels at a depth in metres."""
        return float('inf') if Z == 0 else -self.right.P[0, 3] / Z
