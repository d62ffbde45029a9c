// The scene of the bench `sim`: a robot with two driven wheels and a lidar of 360 rays among 40 fixed and 3 free boxes, as SDF
// for the simulator and as MJCF for its peer. Both have the same shapes, masses and places, and a step of 1 ms.

const FIXED = 40;
const FREE = 3;

interface Placed {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

/** On circles of 3, 4, 5 and 6 m around the robot. */
const fixedBoxes: readonly Placed[] = Array.from({ length: FIXED }, (_, i) => {
  const angle = (2 * Math.PI * i) / 10 + 0.3 * Math.floor(i / 10);
  const radius = 3 + Math.floor(i / 10);
  return { x: radius * Math.cos(angle), y: radius * Math.sin(angle), yaw: 0.7 * i };
});
const freeBoxes: readonly Placed[] = Array.from({ length: FREE }, (_, i) => ({ x: -1.5 + 0.5 * i, y: -1.5, yaw: 0.2 * i }));

export interface Sensors {
  readonly scansHz: number;
  /** No camera when it is not there. */
  readonly camera?: { readonly width: number; readonly height: number; readonly hz: number; };
}

const pose = (x: number, y: number, z: number, yaw = 0): string => `<pose>${String(x)} ${String(y)} ${String(z)} 0 0 ${String(yaw)}</pose>`;
const shape = (geometry: string, more = ''): string =>
  `<collision name="c"><geometry>${geometry}</geometry>${more}</collision><visual name="v"><geometry>${geometry}</geometry></visual>`;
const box = (size: string): string => `<box><size>${size}</size></box>`;
const inertia = (mass: number, x: number, y: number, z: number): string =>
  `<inertial><mass>${String(mass)}</mass><inertia><ixx>${String(x)}</ixx><iyy>${String(y)}</iyy><izz>${String(z)}</izz></inertia></inertial>`;

function cameraOf(sensors: Sensors): string {
  const { camera } = sensors;
  if (camera === undefined) return '';
  return `<sensor name="camera" type="camera"><pose>0.12 0 0.1 0 0 0</pose><update_rate>${String(camera.hz)}</update_rate><camera>
    <image><width>${String(camera.width)}</width><height>${String(camera.height)}</height></image></camera>
    <plugin name="camera" filename="libgazebo_ros_camera.so"/></sensor>`;
}

const robot = (sensors: Sensors): string =>
  `<model name="robot">
  <link name="base"><pose>0 0 0.05 0 0 0</pose>${inertia(3, 0.02, 0.02, 0.03)}
    <collision name="body"><pose>0 0 0.06 0 0 0</pose><geometry>${box('0.3 0.2 0.1')}</geometry></collision>
    <visual name="body"><pose>0 0 0.06 0 0 0</pose><geometry>${box('0.3 0.2 0.1')}</geometry></visual>
    <collision name="caster"><pose>-0.12 0 0 0 0 0</pose><geometry><sphere><radius>0.05</radius></sphere></geometry>
      <surface><friction><ode><mu>0.001</mu><mu2>0.001</mu2></ode></friction></surface></collision>
    <sensor name="lidar" type="ray"><pose>0 0 0.2 0 0 0</pose><update_rate>${String(sensors.scansHz)}</update_rate>
      <ray><scan><horizontal><samples>360</samples><min_angle>-3.1416</min_angle><max_angle>3.1241</max_angle></horizontal></scan>
        <range><min>0.1</min><max>10</max></range></ray>
      <plugin name="lidar" filename="libgazebo_ros_ray_sensor.so"><ros><remapping>~/out:=scan</remapping></ros>
        <output_type>sensor_msgs/LaserScan</output_type></plugin></sensor>
    ${cameraOf(sensors)}</link>
  ${
    [['left', 0.15], ['right', -0.15]].map(([side, y]) =>
      `<link name="${String(side)}"><pose>0.05 ${String(y)} 0.05 -1.5707963 0 0</pose>
    ${inertia(0.2, 0.00014, 0.00014, 0.00025)}${shape('<cylinder><radius>0.05</radius><length>0.03</length></cylinder>')}</link>
  <joint name="${String(side)}_joint" type="revolute"><parent>base</parent><child>${String(side)}</child><axis><xyz>0 0 1</xyz></axis></joint>`
    ).join('')
  }
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so"><left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>
    <wheel_separation>0.3</wheel_separation><wheel_diameter>0.1</wheel_diameter>
    <publish_odom>true</publish_odom><publish_odom_tf>true</publish_odom_tf></plugin>
  <plugin name="joints" filename="libgazebo_ros_joint_state_publisher.so">
    <joint_name>left_joint</joint_name><joint_name>right_joint</joint_name></plugin>
</model>`;

/** `realTime`: as fast as the clock, or as fast as possible. */
export const sdfWorld = (sensors: Sensors, realTime: boolean): string =>
  `<sdf version="1.6"><world name="bench">
<physics type="ode"><max_step_size>0.001</max_step_size><real_time_update_rate>${realTime ? '1000' : '0'}</real_time_update_rate></physics>
<model name="ground"><static>true</static><link name="l">${shape('<plane><normal>0 0 1</normal><size>30 30</size></plane>')}</link></model>
<light name="sun" type="directional"><diffuse>0.8 0.8 0.8 1</diffuse><direction>-0.5 0.1 -0.9</direction></light>
${
    fixedBoxes.map(({ x, y, yaw }, i) =>
      `<model name="fixed${String(i)}"><static>true</static>${pose(x, y, 0.25, yaw)}
  <link name="l">${shape(box('0.4 0.4 0.5'))}</link></model>`
    ).join('\n')
  }
${
    freeBoxes.map(({ x, y, yaw }, i) =>
      `<model name="free${String(i)}">${pose(x, y, 0.1, yaw)}
  <link name="l">${inertia(1, 0.0067, 0.0067, 0.0067)}${shape(box('0.2 0.2 0.2'))}</link></model>`
    ).join('\n')
  }
${robot(sensors)}
</world></sdf>
`;

const geom = (rest: string): string => `<geom friction="1 .005 .0001" ${rest}/>`;
const place = (x: number, y: number, z: number, yaw = 0): string => `pos="${String(x)} ${String(y)} ${String(z)}" euler="0 0 ${String(yaw)}"`;

/** The wheels are spheres and have a motor that holds a velocity with a limited torque, as the simulator makes them. */
export const mjcfWorld = (): string =>
  `<mujoco><compiler angle="radian" inertiafromgeom="false"/>
<option timestep="0.001" gravity="0 0 -9.8" cone="elliptic"/>
<worldbody>${geom('type="plane" size="0 0 1"')}
${fixedBoxes.map(({ x, y, yaw }) => geom(`type="box" size=".2 .2 .25" ${place(x, y, 0.25, yaw)}`)).join('\n')}
${
    freeBoxes.map(({ x, y, yaw }) =>
      `<body ${place(x, y, 0.1, yaw)}><freejoint/><inertial pos="0 0 0" mass="1" diaginertia=".0067 .0067 .0067"/>
  ${geom('type="box" size=".1 .1 .1"')}</body>`
    ).join('\n')
  }
<body name="robot" ${place(0, 0, 0.05)}><freejoint/><inertial pos="0 0 0" mass="3" diaginertia=".02 .02 .03"/>
  ${geom('type="box" size=".15 .1 .05" pos="0 0 .06" contype="2" conaffinity="2"')}
  <geom type="sphere" size=".05" pos="-.12 0 0" friction=".001 .005 .0001" priority="1"/>
  ${
    [0.15, -0.15].map((y) =>
      `<body pos=".05 ${String(y)} 0"><joint name="w${y > 0 ? 'l' : 'r'}" axis="0 1 0" armature="1e-4"/>
    <inertial pos="0 0 0" mass=".2" diaginertia=".00014 .00025 .00014"/>${geom('type="sphere" size=".05"')}</body>`
    ).join('')
  }
</body></worldbody>
<actuator><velocity joint="wl" kv="1" ctrllimited="false" forcelimited="true" forcerange="-5 5"/>
<velocity joint="wr" kv="1" ctrllimited="false" forcelimited="true" forcerange="-5 5"/></actuator></mujoco>
`;
