// The messages and topics of the scene "world" of page_fake.tsx: what a 3D view shows.

import type { TopicView } from '../../../runtime/site/contract/session.ts';

const MESSAGES: Readonly<Record<string, string>> = {
  'builtin_interfaces/Time': 'int32 sec\nuint32 nanosec',
  'builtin_interfaces/Duration': 'int32 sec\nuint32 nanosec',
  'std_msgs/Header': 'builtin_interfaces/Time stamp\nstring frame_id',
  'std_msgs/String': 'string data',
  'std_msgs/ColorRGBA': 'float32 r\nfloat32 g\nfloat32 b\nfloat32 a',
  'geometry_msgs/Vector3': 'float64 x\nfloat64 y\nfloat64 z',
  'geometry_msgs/Point': 'float64 x\nfloat64 y\nfloat64 z',
  'geometry_msgs/Quaternion': 'float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1',
  'geometry_msgs/Transform': 'Vector3 translation\nQuaternion rotation',
  'geometry_msgs/TransformStamped': 'std_msgs/Header header\nstring child_frame_id\nTransform transform',
  'geometry_msgs/Pose': 'Point position\nQuaternion orientation',
  'geometry_msgs/PoseStamped': 'std_msgs/Header header\nPose pose',
  'geometry_msgs/PoseArray': 'std_msgs/Header header\nPose[] poses',
  'geometry_msgs/PoseWithCovariance': 'Pose pose\nfloat64[36] covariance',
  'geometry_msgs/Twist': 'Vector3 linear\nVector3 angular',
  'geometry_msgs/TwistWithCovariance': 'Twist twist\nfloat64[36] covariance',
  'nav_msgs/Path': 'std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses',
  'nav_msgs/Odometry': 'std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist',
  'nav_msgs/MapMetaData': 'builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\ngeometry_msgs/Pose origin',
  'nav_msgs/OccupancyGrid': 'std_msgs/Header header\nMapMetaData info\nint8[] data',
  'sensor_msgs/LaserScan':
    'std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities',
  'sensor_msgs/PointField': 'string name\nuint32 offset\nuint8 datatype\nuint32 count',
  'sensor_msgs/PointCloud2':
    'std_msgs/Header header\nuint32 height\nuint32 width\nPointField[] fields\nbool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense',
  'sensor_msgs/CompressedImage': 'std_msgs/Header header\nstring format\nuint8[] data',
  'sensor_msgs/JointState': 'std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort',
  'sensor_msgs/Image': 'std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data',
  'geometry_msgs/PoseWithCovarianceStamped': 'std_msgs/Header header\nPoseWithCovariance pose',
  'geometry_msgs/PointStamped': 'std_msgs/Header header\nPoint point',
  'geometry_msgs/Point32': 'float32 x\nfloat32 y\nfloat32 z',
  'geometry_msgs/Polygon': 'Point32[] points',
  'geometry_msgs/PolygonStamped': 'std_msgs/Header header\nPolygon polygon',
  'map_msgs/OccupancyGridUpdate': 'std_msgs/Header header\nint32 x\nint32 y\nuint32 width\nuint32 height\nint8[] data',
  'visualization_msgs/UVCoordinate': 'float32 u\nfloat32 v',
  'visualization_msgs/MeshFile': 'string filename\nuint8[] data',
  'visualization_msgs/Marker':
    'std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\ngeometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\nbuiltin_interfaces/Duration lifetime\nbool frame_locked\ngeometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\nstring texture_resource\nsensor_msgs/CompressedImage texture\nUVCoordinate[] uv_coordinates\nstring text\nstring mesh_resource\nMeshFile mesh_file\nbool mesh_use_embedded_materials',
  'visualization_msgs/MarkerArray': 'Marker[] markers',
  'tf2_msgs/TFMessage': 'geometry_msgs/TransformStamped[] transforms',
};

export const WORLD_INTERFACES: readonly (readonly [string, string])[] = Object.entries(MESSAGES).map(
  ([name, text]) => [name.replace('/', '/msg/'), `${text}\n`] as const,
);

const LATCHED: TopicView['qos'] = [
  { reliability: 'reliable', durability: 'transient_local', history: 'keep_last', depth: 1 },
];

export const WORLD_TOPICS: readonly (Pick<TopicView, 'name' | 'type'> & Partial<TopicView>)[] = [
  { name: '/tf', type: 'tf2_msgs/msg/TFMessage' },
  { name: '/tf_static', type: 'tf2_msgs/msg/TFMessage', qos: LATCHED },
  { name: '/robot_description', type: 'std_msgs/msg/String', qos: LATCHED },
  { name: '/map', type: 'nav_msgs/msg/OccupancyGrid', qos: LATCHED },
  { name: '/scan', type: 'sensor_msgs/msg/LaserScan' },
  { name: '/points', type: 'sensor_msgs/msg/PointCloud2' },
  { name: '/plan', type: 'nav_msgs/msg/Path' },
  { name: '/odom', type: 'nav_msgs/msg/Odometry' },
  { name: '/particles', type: 'geometry_msgs/msg/PoseArray' },
  { name: '/markers', type: 'visualization_msgs/msg/MarkerArray' },
  { name: '/camera', type: 'sensor_msgs/msg/Image' },
  { name: '/camera/compressed', type: 'sensor_msgs/msg/CompressedImage' },
  { name: '/map_updates', type: 'map_msgs/msg/OccupancyGridUpdate' },
  { name: '/words', type: 'std_msgs/msg/String' },
  { name: '/joint_states', type: 'sensor_msgs/msg/JointState', publishers: 0 },
];

/** Below share/meshes: tests answer for them. */
export const WORLD_FILES: readonly string[] = [
  'wedge.stl',
  'wedge.bin.stl',
  'wedge.dae',
  'wedge.obj',
  'wedge.mtl',
  'wedge.gltf',
  'wedge.bin',
  'green.png',
  'skin.dae',
  'cut.stl',
  'loop.dae',
  'far.obj',
  'many.stl',
  'wrong.gltf',
  'words.dae',
  'gone.stl',
  'away.dae',
  'view.rviz',
].map((name) => `share/meshes/${name}`);
