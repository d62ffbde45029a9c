// Names of bags. Pure.

/** `rosbag2_2026_01_31-14_05_09.mcap`, as `ros2 bag record` names them; ms since 1970. */
export function bagName(ms: number): string {
  const at = new Date(ms);
  const two = (n: number): string => String(n).padStart(2, '0');
  const day = `${at.getFullYear()}_${two(at.getMonth() + 1)}_${two(at.getDate())}`;
  return `rosbag2_${day}-${two(at.getHours())}_${two(at.getMinutes())}_${two(at.getSeconds())}.mcap`;
}

export function withEnding(name: string): string {
  return name.endsWith('.mcap') ? name : `${name}.mcap`;
}
