"""Tells where a marker is, as seen by the camera."""
import cv2
from cv_bridge import CvBridge
import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, Image

SIDE = 0.1  # metres


class MarkerPose(Node):

    def __init__(self):
        super().__init__('marker_pose')
        self.bridge = CvBridge()
        self.matrix = self.distortion = None
        self.dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
        self.create_subscription(CameraInfo, 'camera/camera_info', self.calibrate, 10)
        self.create_subscription(Image, 'camera/image_raw', self.look, 10)

    def calibrate(self, info):
        self.matrix = np.array(info.k).reshape(3, 3)
        self.distortion = np.array(info.d)

    def look(self, message):
        if self.matrix is None:
            return
        picture = self.bridge.imgmsg_to_cv2(message, 'bgr8')
        corners, ids, _ = cv2.aruco.detectMarkers(picture, self.dictionary)
        if ids is None:
            return
        turns, places, _ = cv2.aruco.estimatePoseSingleMarkers(corners, SIDE, self.matrix, self.distortion)
        cv2.aruco.drawDetectedMarkers(picture, corners, ids)
        cv2.drawFrameAxes(picture, self.matrix, self.distortion, turns[0], places[0], SIDE)
        x, y, z = places[0][0]
        self.get_logger().info(f'marker {ids[0][0]} at {x:.2f} {y:.2f} {z:.2f} m')
        rclpy.shutdown()


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(MarkerPose())


if __name__ == '__main__':
    main()
