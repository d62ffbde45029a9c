"""Type hashes are those of ROS 2 Jazzy: the expected values were seen on real systems."""
import unittest

import type_description as td

from .definitions import shipped

TIME = "builtin_interfaces/msg/Time"
HASHES = {
    "builtin_interfaces/msg/Time": "RIHS01_b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197",
    "std_msgs/msg/String": "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
    "std_msgs/msg/Header": "RIHS01_f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01",
    "std_msgs/msg/Empty": "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312",
    "geometry_msgs/msg/Twist": "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a",
    "rcl_interfaces/msg/Log": "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac",
    "rcl_interfaces/msg/ParameterEvent":
        "RIHS01_043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204",
    "example_interfaces/srv/AddTwoInts":
        "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a",
    "example_interfaces/action/Fibonacci_SendGoal":
        "RIHS01_d1a57fb2a4afe8c21e34fb10db206f16ce6729b28531141472df92277c55b557",
    "example_interfaces/action/Fibonacci_GetResult":
        "RIHS01_1b0de0d5d29dc955d92f546706568428632771db13ec84c15ec1c1a59f424a57",
}


class TypeHash(unittest.TestCase):
    """One table holds everything that the hashed types refer to."""

    types: td.TypeTable

    @classmethod
    def setUpClass(cls) -> None:
        cls.types = shipped(
            TIME, "std_msgs/msg/String", "std_msgs/msg/Header", "std_msgs/msg/Empty",
            "geometry_msgs/msg/Twist", "geometry_msgs/msg/Vector3", "rcl_interfaces/msg/Log",
            "rcl_interfaces/msg/ParameterEvent", "rcl_interfaces/msg/Parameter",
            "rcl_interfaces/msg/ParameterValue", "example_interfaces/srv/AddTwoInts",
            "example_interfaces/action/Fibonacci", "unique_identifier_msgs/msg/UUID")

    def test_hashes_are_upstreams(self) -> None:
        for name, expected in HASHES.items():
            with self.subTest(name):
                self.assertEqual(self.types.hash(name), expected)

    def test_what_the_generator_knows_of_service_events_is_what_the_interface_says(self) -> None:
        built_in = self.types["service_msgs/msg/ServiceEventInfo"]
        from_file = shipped("service_msgs/msg/ServiceEventInfo")["service_msgs/msg/ServiceEventInfo"]
        self.assertEqual(built_in, from_file)

    def test_a_type_that_is_not_there_is_named(self) -> None:
        with self.assertRaisesRegex(ValueError, "'builtin_interfaces/msg/Duration', used by"):
            shipped("visualization_msgs/msg/Marker", "std_msgs/msg/Header", "geometry_msgs/msg/Pose",
                    "geometry_msgs/msg/Point", "geometry_msgs/msg/Quaternion", "geometry_msgs/msg/Vector3",
                    "std_msgs/msg/ColorRGBA", "sensor_msgs/msg/CompressedImage",
                    "visualization_msgs/msg/UVCoordinate", "visualization_msgs/msg/MeshFile",
                    ).full("visualization_msgs/msg/Marker")


if __name__ == "__main__":
    unittest.main()
