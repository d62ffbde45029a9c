"""The functions of OpenCV that npm's build of OpenCV.js has, in the order of their parameters in C++.

A line: NAME, then the parameters; an indented line goes on with the one before. `>` marks a result, `&` an argument
that is also a result. After `:` comes the type (an array without it), after `=` the value when it is not given. After
`->` comes the type of what the function returns. The order of Python's
parameters follows: see _call.py.
"""

FUNCTIONS = """
CamShift: probImage, window:rect, criteria:term -> tracked
Canny: image, >edges, threshold1:float, threshold2:float, apertureSize:int=3, L2gradient:bool=False
GaussianBlur: src, >dst, ksize:size, sigmaX:float, sigmaY:float=0, borderType:int=4
HoughCircles: image, >circles, method:int, dp:float, minDist:float, param1:float=100, param2:float=100,
    minRadius:int=0, maxRadius:int=0
HoughLines: image, >lines, rho:float, theta:float, threshold:int, srn:float=0, stn:float=0, min_theta:float=0,
    max_theta:float=3.141592653589793
HoughLinesP: image, >lines, rho:float, theta:float, threshold:int, minLineLength:float=0, maxLineGap:float=0
HuMoments: m:plain, >hu
LUT: src, lut, >dst
Laplacian: src, >dst, ddepth:int, ksize:int=1, scale:float=1, delta:float=0, borderType:int=4
Rodrigues: src, >dst, >jacobian
Scharr: src, >dst, ddepth:int, dx:int, dy:int, scale:float=1, delta:float=0, borderType:int=4
Sobel: src, >dst, ddepth:int, dx:int, dy:int, ksize:int=3, scale:float=1, delta:float=0, borderType:int=4
absdiff: src1, src2, >dst
adaptiveThreshold: src, >dst, maxValue:float, adaptiveMethod:int, thresholdType:int, blockSize:int, C:float
add: src1, src2, >dst, mask=None, dtype:int=-1
addWeighted: src1, alpha:float, src2, beta:float, gamma:float, >dst, dtype:int=-1
applyColorMap: src, >dst, colormap:int
approxPolyDP: curve, >approxCurve, epsilon:float, closed:bool
arcLength: curve, closed:bool -> float
arrowedLine: &img, pt1:point, pt2:point, color:scalar, thickness:int=1, line_type:int=8, shift:int=0,
    tipLength:float=0.1
bilateralFilter: src, >dst, d:int, sigmaColor:float, sigmaSpace:float, borderType:int=4
bitwise_and: src1, src2, >dst, mask=None
bitwise_not: src, >dst, mask=None
bitwise_or: src1, src2, >dst, mask=None
bitwise_xor: src1, src2, >dst, mask=None
blendLinear: src1, src2, weights1, weights2, >dst
blur: src, >dst, ksize:size, anchor:point=(-1,-1), borderType:int=4
boundingRect: array -> rect
boxFilter: src, >dst, ddepth:int, ksize:size, anchor:point=(-1,-1), normalize:bool=True, borderType:int=4
calcBackProject: images:mats, channels:list, hist, >dst, ranges:list, scale:float
calcHist: images:mats, channels:list, mask, >hist, histSize:list, ranges:list, accumulate:bool=False
calcOpticalFlowFarneback: prev, next, &flow, pyr_scale:float, levels:int, winsize:int, iterations:int, poly_n:int,
    poly_sigma:float, flags:int
calcOpticalFlowPyrLK: prevImg, nextImg, prevPts, &nextPts, >status, >err, winSize:size=(21,21), maxLevel:int=3,
    criteria:term=(3,30,0.01), flags:int=0, minEigThreshold:float=0.0001
cartToPolar: x, y, >magnitude, >angle, angleInDegrees:bool=False
circle: &img, center:point, radius:int, color:scalar, thickness:int=1, lineType:int=8, shift:int=0
compare: src1, src2, >dst, cmpop:int
compareHist: H1, H2, method:int -> float
connectedComponents: image, >labels, connectivity:int=8, ltype:int=4 -> int
connectedComponentsWithStats: image, >labels, >stats, >centroids, connectivity:int=8, ltype:int=4 -> int
contourArea: contour, oriented:bool=False -> float
convertScaleAbs: src, >dst, alpha:float=1, beta:float=0
convexHull: points, >hull, clockwise:bool=False, returnPoints:bool=True
convexityDefects: contour, convexhull, >convexityDefects
copyMakeBorder: src, >dst, top:int, bottom:int, left:int, right:int, borderType:int, value:scalar=()
cornerHarris: src, >dst, blockSize:int, ksize:int, k:float, borderType:int=4
cornerMinEigenVal: src, >dst, blockSize:int, ksize:int=3, borderType:int=4
countNonZero: src -> int
createHanningWindow: >dst, winSize:size, type:int
cvtColor: src, >dst, code:int, dstCn:int=0
demosaicing: src, >dst, code:int, dstCn:int=0
determinant: mtx -> float
dft: src, >dst, flags:int=0, nonzeroRows:int=0
dilate: src, >dst, kernel, anchor:point=(-1,-1), iterations:int=1, borderType:int=0, borderValue:scalar=MORPHOLOGY
distanceTransform: src, >dst, distanceType:int, maskSize:int, dstType:int=5
distanceTransformWithLabels: src, >dst, >labels, distanceType:int, maskSize:int, labelType:int=0
divide: src1, src2, >dst, scale:float=1, dtype:int=-1
drawContours: &image, contours:mats, contourIdx:int, color:scalar, thickness:int=1, lineType:int=8, hierarchy=None,
    maxLevel:int=2147483647, offset:point=(0,0)
drawFrameAxes: &image, cameraMatrix, distCoeffs, rvec, tvec, length:float, thickness:int=3
drawKeypoints: image, keypoints:keypoints, &outImage, color:scalar=(-1,-1,-1,-1), flags:DrawMatchesFlags=0
drawMarker: &img, position:point, color:scalar, markerType:int=0, markerSize:int=20, thickness:int=1, line_type:int=8
drawMatches: img1, keypoints1:keypoints, img2, keypoints2:keypoints, matches1to2:matches, &outImg,
    matchColor:scalar=(-1,-1,-1,-1), singlePointColor:scalar=(-1,-1,-1,-1), matchesMask:list=(),
    flags:DrawMatchesFlags=0
eigen: src, >eigenvalues, >eigenvectors -> bool
ellipse: &img, center:point, axes:size, angle:float, startAngle:float, endAngle:float, color:scalar, thickness:int=1,
    lineType:int=8, shift:int=0
ellipse1: &img, box:rrect, color:scalar, thickness:int=1, lineType:int=8
ellipse2Poly: center:point, axes:size, angle:int, arcStart:int, arcEnd:int, delta:int, >pts:points
equalizeHist: src, >dst
erode: src, >dst, kernel, anchor:point=(-1,-1), iterations:int=1, borderType:int=0, borderValue:scalar=MORPHOLOGY
estimateAffine2D: from_, to, >inliers, method:int=8, ransacReprojThreshold:float=3, maxIters:int=2000,
    confidence:float=0.99, refineIters:int=10 -> array
exp: src, >dst
fillConvexPoly: &img, points, color:scalar, lineType:int=8, shift:int=0
fillPoly: &img, pts:mats, color:scalar, lineType:int=8, shift:int=0, offset:point=(0,0)
filter2D: src, >dst, ddepth:int, kernel, anchor:point=(-1,-1), delta:float=0, borderType:int=4
findContours: image, >contours:mats, >hierarchy, mode:int, method:int, offset:point=(0,0)
findHomography: srcPoints, dstPoints, method:int=0, ransacReprojThreshold:float=3, >mask, maxIters:int=2000,
    confidence:float=0.995 -> array
fitEllipse: points -> rrect
fitEllipseAMS: points -> rrect
fitEllipseDirect: points -> rrect
fitLine: points, >line, distType:int, param:float, reps:float, aeps:float
flip: src, >dst, flipCode:int
floodFill: &image, &mask, seedPoint:point, newVal:scalar, >rect:rect, loDiff:scalar=(), upDiff:scalar=(), flags:int=4
    -> int
gemm: src1, src2, alpha:float, src3, beta:float, >dst, flags:int=0
getAffineTransform: src, dst -> array
getBuildInformation: -> str
getDefaultNewCameraMatrix: cameraMatrix, imgsize:size=(0,0), centerPrincipalPoint:bool=False -> array
getFontScaleFromHeight: fontFace:int, pixelHeight:int, thickness:int=1 -> float
getOptimalDFTSize: vecsize:int -> int
getPerspectiveTransform: src, dst, solveMethod:int=0 -> array
getRectSubPix: image, patchSize:size, center:point2f, >patch, patchType:int=-1
getRotationMatrix2D: center:point2f, angle:float, scale:float -> array
getStructuringElement: shape:int, ksize:size, anchor:point=(-1,-1) -> array
goodFeaturesToTrack: image, >corners, maxCorners:int, qualityLevel:float, minDistance:float, mask=None,
    blockSize:int=3, useHarrisDetector:bool=False, k:float=0.04
grabCut: img, &mask, rect:rect, &bgdModel, &fgdModel, iterCount:int, mode:int=3
hconcat: src:mats, >dst
inRange: src, lowerb, upperb, >dst
initUndistortRectifyMap: cameraMatrix, distCoeffs, R, newCameraMatrix, size:size, m1type:int, >map1, >map2
inpaint: src, inpaintMask, >dst, inpaintRadius:float, flags:int
integral: src, >sum, sdepth:int=-1
invert: src, >dst, flags:int=0 -> float
invertAffineTransform: M, >iM
isContourConvex: contour -> bool
kmeans: data, K:int, &bestLabels, criteria:term, attempts:int, flags:int, >centers -> float
line: &img, pt1:point, pt2:point, color:scalar, thickness:int=1, lineType:int=8, shift:int=0
log: src, >dst
magnitude: x, y, >magnitude
matchShapes: contour1, contour2, method:int, parameter:float -> float
matchTemplate: image, templ, >result, method:int, mask=None
max: src1, src2, >dst
mean: src, mask=None -> scalar
meanShift: probImage, window:rect, criteria:term -> tracked
meanStdDev: src, >mean, >stddev, mask=None
medianBlur: src, >dst, ksize:int
merge: mv:mats, >dst
min: src1, src2, >dst
minAreaRect: points -> rrect
minEnclosingCircle: points -> circle
minEnclosingTriangle: points, >triangle -> float
minMaxLoc: src, mask=None -> minmax
moments: array, binaryImage:bool=False -> plain
morphologyEx: src, >dst, op:int, kernel, anchor:point=(-1,-1), iterations:int=1, borderType:int=0,
    borderValue:scalar=MORPHOLOGY
multiply: src1, src2, >dst, scale:float=1, dtype:int=-1
norm: src1, normType:int=4, mask=None -> float
norm1: src1, src2, normType:int=4, mask=None -> float
normalize: src, &dst, alpha:float=1, beta:float=0, norm_type:int=4, dtype:int=-1, mask=None
perspectiveTransform: src, >dst, m
pointPolygonTest: contour, pt:point2f, measureDist:bool -> float
polarToCart: magnitude, angle, >x, >y, angleInDegrees:bool=False
polylines: &img, pts:mats, isClosed:bool, color:scalar, thickness:int=1, lineType:int=8, shift:int=0
pow: src, power:float, >dst
preCornerDetect: src, >dst, ksize:int, borderType:int=4
projectPoints: objectPoints, rvec, tvec, cameraMatrix, distCoeffs, >imagePoints, >jacobian, aspectRatio:float=0
putText: &img, text:str, org:point, fontFace:int, fontScale:float, color:scalar, thickness:int=1, lineType:int=8,
    bottomLeftOrigin:bool=False
pyrDown: src, >dst, dstsize:size=(0,0), borderType:int=4
pyrUp: src, >dst, dstsize:size=(0,0), borderType:int=4
randn: &dst, mean, stddev
randu: &dst, low, high
rectangle: &img, pt1:point, pt2:point, color:scalar, thickness:int=1, lineType:int=8, shift:int=0
rectangle1: &img, rec:rect, color:scalar, thickness:int=1, lineType:int=8, shift:int=0
reduce: src, >dst, dim:int, rtype:int, dtype:int=-1
remap: src, >dst, map1, map2, interpolation:int, borderMode:int=0, borderValue:scalar=()
repeat: src, ny:int, nx:int, >dst
resize: src, >dst, dsize:size, fx:float=0, fy:float=0, interpolation:int=1
rotate: src, >dst, rotateCode:int
rotatedRectangleIntersection: rect1:rrect, rect2:rrect, >intersectingRegion -> int
sepFilter2D: src, >dst, ddepth:int, kernelX, kernelY, anchor:point=(-1,-1), delta:float=0, borderType:int=4
setRNGSeed: seed:int
solve: src1, src2, >dst, flags:int=0 -> bool
solvePnP: objectPoints, imagePoints, cameraMatrix, distCoeffs, &rvec=None, &tvec=None, useExtrinsicGuess:bool=False,
    flags:int=0 -> bool
solvePnPRansac: objectPoints, imagePoints, cameraMatrix, distCoeffs, &rvec=None, &tvec=None,
    useExtrinsicGuess:bool=False, iterationsCount:int=100, reprojectionError:float=8, confidence:float=0.99, >inliers,
    flags:int=0 -> bool
solvePnPRefineLM: objectPoints, imagePoints, cameraMatrix, distCoeffs, &rvec, &tvec,
    criteria:term=(3,20,1.1920928955078125e-07)
spatialGradient: src, >dx, >dy, ksize:int=3, borderType:int=4
split: m, >mv:mats
sqrBoxFilter: src, >dst, ddepth:int, ksize:size, anchor:point=(-1,-1), normalize:bool=True, borderType:int=4
sqrt: src, >dst
stackBlur: src, >dst, ksize:size
subtract: src1, src2, >dst, mask=None, dtype:int=-1
threshold: src, >dst, thresh:float, maxval:float, type:int -> float
trace: mtx -> scalar
transform: src, >dst, m
transpose: src, >dst
undistort: src, >dst, cameraMatrix, distCoeffs, newCameraMatrix=None
vconcat: src:mats, >dst
warpAffine: src, >dst, M, dsize:size, flags:int=1, borderMode:int=0, borderValue:scalar=()
warpPerspective: src, >dst, M, dsize:size, flags:int=1, borderMode:int=0, borderValue:scalar=()
warpPolar: src, >dst, dsize:size, center:point2f, maxRadius:float, flags:int
watershed: image, &markers
"""

#: `CLASS.METHOD`, as above; the constructor is `CLASS.new`.
METHODS = """
ORB.new: nfeatures:int=500, scaleFactor:float=1.2, nlevels:int=8, edgeThreshold:int=31, firstLevel:int=0, WTA_K:int=2,
    scoreType:ORB_ScoreType=0, patchSize:int=31, fastThreshold:int=20
AKAZE.new:
BRISK.new: thresh:int=30, octaves:int=3, patternScale:float=1
KAZE.new: extended:bool=False, upright:bool=False, threshold:float=0.001, nOctaves:int=4, nOctaveLayers:int=4
FastFeatureDetector.new: threshold:int=10, nonmaxSuppression:bool=True
GFTTDetector.new: maxCorners:int=1000, qualityLevel:float=0.01, minDistance:float=1, blockSize:int=3,
    useHarrisDetector:bool=False, k:float=0.04
SimpleBlobDetector.new:
SimpleBlobDetector.setParams: parameters:object
Feature2D.detect: image, >keypoints:keypoints, mask=None
Feature2D.compute: image, &keypoints:keypoints, >descriptors
Feature2D.detectAndCompute: image, mask, >keypoints:keypoints, >descriptors, useProvidedKeypoints:bool=False
Feature2D.descriptorSize: -> int
Feature2D.descriptorType: -> int
Feature2D.defaultNorm: -> int
BFMatcher.new: normType:int=4, crossCheck:bool=False
DescriptorMatcher.match: queryDescriptors, trainDescriptors, >matches:matches, mask=None
DescriptorMatcher.knnMatch: queryDescriptors, trainDescriptors, >matches:lists_of_matches, k:int, mask=None,
    compactResult:bool=False
DescriptorMatcher.radiusMatch: queryDescriptors, trainDescriptors, >matches:lists_of_matches, maxDistance:float,
    mask=None, compactResult:bool=False
CLAHE.new: clipLimit:float=40, tileGridSize:size=(8,8)
CLAHE.apply: src, >dst
CLAHE.setClipLimit: clipLimit:float
CLAHE.getClipLimit: -> float
CLAHE.setTilesGridSize: tileGridSize:size
BackgroundSubtractorMOG2.new: history:int=500, varThreshold:float=16, detectShadows:bool=True
BackgroundSubtractorMOG2.apply: image, >fgmask, learningRate:float=-1
BackgroundSubtractorMOG2.getBackgroundImage: >backgroundImage
QRCodeDetector.new:
QRCodeDetector.detect: img, >points -> bool
QRCodeDetector.detectAndDecode: img, >points, >straight_code -> str
aruco_ArucoDetector.new: dictionary:object, detectorParams:object, refineParams:object
aruco_ArucoDetector.detectMarkers: image, >corners:mats, >ids, >rejectedImgPoints:mats
aruco_Dictionary.generateImageMarker: id:int, sidePixels:int, >img, borderBits:int=1
"""

#: Methods that a class has from another one.
INHERITED = {
    'ORB': 'Feature2D', 'AKAZE': 'Feature2D', 'BRISK': 'Feature2D', 'KAZE': 'Feature2D',
    'FastFeatureDetector': 'Feature2D', 'GFTTDetector': 'Feature2D', 'SimpleBlobDetector': 'Feature2D',
    'BFMatcher': 'DescriptorMatcher',
}
