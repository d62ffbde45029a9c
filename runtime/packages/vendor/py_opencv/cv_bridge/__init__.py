"""Images of ROS as arrays of numpy, and back: the names and rules of cv_bridge for Python."""
from cv_bridge.core import CvBridge, CvBridgeError

__all__ = ['CvBridge', 'CvBridgeError']
