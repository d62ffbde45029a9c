"""Finds the orange ball, and foresees where it will be."""
import cv2
from cv_bridge import CvBridge, CvBridgeError
from geometry_msgs.msg import Point
import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image


class ColourTracker(Node):

    def __init__(self):
        super().__init__('colour_tracker')
        self.bridge = CvBridge()
        self.places = self.create_publisher(Point, 'ball', 10)
        self.create_subscription(Image, 'camera/image_raw', self.look, 10)
        self.filter = cv2.KalmanFilter(4, 2)
        self.filter.transitionMatrix = np.array([[1, 0, 1, 0], [0, 1, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1]], np.float32)
        self.filter.measurementMatrix = np.eye(2, 4, dtype=np.float32)
        self.filter.processNoiseCov = np.eye(4, dtype=np.float32) * 0.01
        self.seen = 0

    def look(self, message):
        try:
            picture = self.bridge.imgmsg_to_cv2(message, 'bgr8')
        except CvBridgeError as error:
            self.get_logger().error(str(error))
            return
        hsv = cv2.cvtColor(cv2.GaussianBlur(picture, (5, 5), 0), cv2.COLOR_BGR2HSV)
        mask = cv2.inRange(hsv, np.array([8, 150, 100]), np.array([25, 255, 255]))
        mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        if not contours:
            return
        (x, y), radius = cv2.minEnclosingCircle(max(contours, key=cv2.contourArea))
        self.filter.predict()
        self.filter.correct(np.array([[x], [y]], np.float32))
        self.seen += 1
        self.places.publish(Point(x=float(x), y=float(y), z=float(radius)))
        cv2.circle(picture, (int(x), int(y)), int(radius), (0, 0, 255), 2)
        cv2.imshow('ball', picture)
        cv2.waitKey(1)
        if self.seen == 10:
            ahead = self.filter.statePost[2, 0]
            self.get_logger().info(f'ball at y={y:.0f} with radius {radius:.0f}, moves {ahead:.0f} pixel a picture')


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(ColourTracker())


if __name__ == '__main__':
    main()
