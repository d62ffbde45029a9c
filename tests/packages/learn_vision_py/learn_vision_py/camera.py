"""A camera that sees a road, an orange ball that rolls to the right, and a marker."""
import cv2
from cv_bridge import CvBridge
import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, Image

WIDTH, HEIGHT = 320, 240


class Camera(Node):

    def __init__(self):
        super().__init__('camera')
        self.bridge = CvBridge()
        self.images = self.create_publisher(Image, 'camera/image_raw', 10)
        self.infos = self.create_publisher(CameraInfo, 'camera/camera_info', 10)
        self.create_timer(0.1, self.shoot)
        self.shots = 0

    def shoot(self):
        picture = np.full((HEIGHT, WIDTH, 3), 90, np.uint8)
        cv2.line(picture, (40, 239), (120, 130), (255, 255, 255), 6)
        cv2.line(picture, (280, 239), (200, 130), (255, 255, 255), 6)
        cv2.circle(picture, (60 + self.shots % 100, 60), 15, (0, 140, 255), -1)
        dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
        picture[20:100, 220:300] = 255
        marker = cv2.aruco.generateImageMarker(dictionary, 5, 60)
        picture[30:90, 230:290] = marker[:, :, np.newaxis]
        self.shots += 1
        message = self.bridge.cv2_to_imgmsg(picture, encoding='bgr8')
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = 'camera'
        self.images.publish(message)
        info = CameraInfo(header=message.header, width=WIDTH, height=HEIGHT, d=[0.0] * 5)
        info.k = [300.0, 0.0, 160.0, 0.0, 300.0, 120.0, 0.0, 0.0, 1.0]
        self.infos.publish(info)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Camera())


if __name__ == '__main__':
    main()
