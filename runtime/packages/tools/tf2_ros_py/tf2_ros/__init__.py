"""
Transforms of a graph: who listens keeps them in a buffer, who knows them broadcasts them.

The messages and the classes of rclpy are here because programs import them from here, as they can in ROS 2.
"""
from geometry_msgs.msg import (
    PointStamped, PoseStamped, PoseWithCovarianceStamped, TransformStamped, Vector3Stamped,
)
from rclpy.clock import Clock, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from rclpy.task import Future
from rclpy.time import Time
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Header
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph
from tf2_py import (
    BufferCore, ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException,
    TimeoutException, TransformException,
)
from tf2_ros.buffer import Buffer
from tf2_ros.buffer_client import BufferClient
from tf2_ros.buffer_interface import (
    BufferInterface, ConvertRegistration, NotImplementedException, Stamped, TransformRegistration, TypeException,
    convert,
)
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tf2_ros.transform_broadcaster import TransformBroadcaster
from tf2_ros.transform_listener import TransformListener

__all__ = [
    'Buffer', 'BufferClient', 'BufferCore', 'BufferInterface', 'Clock', 'ConnectivityException',
    'ConvertRegistration', 'DurabilityPolicy', 'Duration', 'ExtrapolationException', 'FrameGraph', 'Future', 'Header',
    'HistoryPolicy', 'InvalidArgumentException', 'JumpThreshold', 'LookupException', 'LookupTransform', 'Node',
    'NotImplementedException', 'PointCloud2', 'PointStamped', 'PoseStamped', 'PoseWithCovarianceStamped',
    'QoSProfile', 'Stamped', 'StaticTransformBroadcaster', 'TFMessage', 'Time', 'TimeJump', 'TimeoutException',
    'TransformBroadcaster', 'TransformException', 'TransformListener', 'TransformRegistration', 'TransformStamped',
    'TypeException', 'Vector3Stamped', 'convert',
]
