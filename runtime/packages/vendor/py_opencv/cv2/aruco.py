"""Markers of ArUco: the detector of newer OpenCV, and the functions of OpenCV 4.6, with which Jazzy's Ubuntu comes."""
import numpy
import cv2
from cv2._call import CONSTANTS, Function, Object, ask, make, wrap

globals().update({name: value for name, value in CONSTANTS.items() if name.startswith('DICT_')})
globals().update({name.removeprefix('aruco_'): value for name, value in CONSTANTS.items() if name.startswith('aruco_')})


def getPredefinedDictionary(dict):
    return wrap('aruco_Dictionary', ask('getPredefinedDictionary', int(dict)))


Dictionary_get = getPredefinedDictionary


def DetectorParameters():
    return make('aruco_DetectorParameters')


DetectorParameters_create = DetectorParameters


def RefineParameters(minRepDistance=10.0, errorCorrectionRate=3.0, checkAllOrders=True):
    values = float(minRepDistance), float(errorCorrectionRate), bool(checkAllOrders)
    return wrap('aruco_RefineParameters', ask('new aruco_RefineParameters', *values))


def ArucoDetector(dictionary=None, detectorParams=None, refineParams=None):
    return make(
        'aruco_ArucoDetector', dictionary or getPredefinedDictionary(0), detectorParams or DetectorParameters(),
        refineParams or RefineParameters())


def detectMarkers(image, dictionary, corners=None, ids=None, parameters=None, rejectedImgPoints=None):
    return ArucoDetector(dictionary, parameters).detectMarkers(image)


def generateImageMarker(dictionary, id, sidePixels, img=None, borderBits=1):
    return dictionary.generateImageMarker(int(id), int(sidePixels), borderBits=int(borderBits))


drawMarker = generateImageMarker


drawDetectedMarkers = Function('drawDetectedMarkers', '&image, corners:mats, ids=None, borderColor:scalar=(0,255,0)')


def estimatePoseSingleMarkers(
        corners, markerLength, cameraMatrix, distCoeffs, rvecs=None, tvecs=None, objPoints=None,
        estimateParameters=None):
    """Rotation and place of each marker, as seen by the camera; the marker's centre is its origin."""
    half = markerLength / 2
    corners_of_marker = [[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]]
    model = numpy.array(corners_of_marker, 'float32').reshape(4, 1, 3)
    turns, places = [], []
    for marker in corners:
        _, turn, place = cv2.solvePnP(model, numpy.reshape(marker, (4, 1, 2)), cameraMatrix, distCoeffs)
        turns.append(turn.reshape(1, 3))
        places.append(place.reshape(1, 3))
    if not turns:
        return None, None, model
    return numpy.array(turns), numpy.array(places), model


def drawAxis(image, cameraMatrix, distCoeffs, rvec, tvec, length):
    return cv2.drawFrameAxes(image, cameraMatrix, distCoeffs, rvec, tvec, length)


#: A detector's own types, for those who ask what something is.
Dictionary = Object
