"""The calibration of a camera, which in OpenCV.js has one form with all results."""
from cv2._call import Function

_extended = Function('calibrateCameraExtended', (
    'objectPoints:mats, imagePoints:mats, imageSize:size, &cameraMatrix, &distCoeffs, >rvecs:mats, >tvecs:mats, '
    '>stdDeviationsIntrinsics, >stdDeviationsExtrinsics, >perViewErrors, flags:int=0, '
    'criteria:term=(3,30,2.220446049250313e-16) -> float'))


def calibrate(*values, **named):
    return _extended(*values, **named)
