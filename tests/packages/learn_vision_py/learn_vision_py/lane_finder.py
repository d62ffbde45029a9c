"""Finds both lines of a lane."""
import cv2
from cv_bridge import CvBridge
import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image


class LaneFinder(Node):

    def __init__(self):
        super().__init__('lane_finder')
        self.bridge = CvBridge()
        self.create_subscription(Image, 'camera/image_raw', self.look, 10)

    def look(self, message):
        gray = self.bridge.imgmsg_to_cv2(message, desired_encoding='mono8')
        edges = cv2.Canny(cv2.GaussianBlur(gray, (5, 5), 0), 50, 150)
        region = np.zeros_like(edges)
        height, width = edges.shape
        corners = np.array([[(0, height), (0, 150), (width, 150), (width, height)]], np.int32)
        cv2.fillPoly(region, corners, 255)
        seen = cv2.bitwise_and(edges, region)
        lines = cv2.HoughLinesP(seen, 1, np.pi / 180, 30, np.array([]), minLineLength=30, maxLineGap=20)
        if lines is None:
            return
        slopes = [(y2 - y1) / (x2 - x1) for x1, y1, x2, y2 in lines.reshape(-1, 4).tolist() if x1 != x2]
        left = [slope for slope in slopes if slope < -0.5]
        right = [slope for slope in slopes if slope > 0.5]
        if left and right:
            self.get_logger().info(f'left {np.mean(left):.1f}, right {np.mean(right):.1f}')
            raise SystemExit


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(LaneFinder())


if __name__ == '__main__':
    main()
