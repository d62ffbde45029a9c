// The output of `ros2 bag info`. Pure.

import type { Bag, BagChannel } from '../bag/bag_file.ts';

const indent = ' '.repeat(19);

/** `-v` is the same here: requests and replies are not told apart. */
export function bagInfo(bag: Bag): string {
  const isEvent = ({ topic, type }: BagChannel): boolean => /\/srv\/.*_Event$/.test(type) && topic.endsWith('/_service_event');
  const services = bag.channels.filter(isEvent);
  const topics = bag.channels.filter((channel) => !isEvent(channel));
  const events = services.reduce((sum, { count }) => sum + count, 0);
  return [
    '',
    `Files:             ${bag.name}`,
    `Bag size:          ${fileSize(bag.size)}`,
    'Storage id:        mcap',
    `ROS Distro:        ${bag.distro === '' ? 'unknown' : bag.distro}`,
    `Duration:          ${seconds(bag.end - bag.start)}s`,
    `Start:             ${moment(bag.start)}`,
    `End:               ${moment(bag.end)}`,
    `Messages:          ${bag.messages - events}`,
    `Topic information: ${
      topics.map(({ topic, type, count, encoding }) => `Topic: ${topic} | Type: ${type} | Count: ${count} | Serialization Format: ${encoding}`).join(
        `\n${indent}`,
      )
    }`,
    `Service:           ${services.length}`,
    `Service information: ${
      services.map(({ topic, type, count, encoding }) =>
        `Service: ${topic.slice(0, -'/_service_event'.length)} | Type: ${
          type.slice(0, -'_Event'.length)
        } | Event Count: ${count} | Serialization Format: ${encoding}`
      )
        .join(`\n${indent}  `)
    }`,
    '',
  ].join('\n');
}

function fileSize(bytes: number): string {
  const units = ['B', 'KiB', 'MiB', 'GiB', 'TiB'];
  let [size, unit] = [bytes, 0];
  while (size >= 1024 && unit < 4) {
    size /= 1024;
    unit += 1;
  }
  return `${size.toFixed(unit === 0 ? 0 : 1)} ${units[unit]}`;
}

export function seconds(ns: bigint): string {
  return `${ns / 1_000_000_000n}.${String(ns % 1_000_000_000n).padStart(9, '0')}`;
}

const months = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];

/** In local time. */
function moment(ns: bigint): string {
  const at = new Date(Number(ns / 1_000_000n));
  const two = (n: number): string => String(n).padStart(2, '0');
  const day = `${months[at.getMonth()]} ${String(at.getDate()).padStart(2)} ${at.getFullYear()}`;
  const nano = String(ns % 1_000_000_000n).padStart(9, '0');
  return `${day} ${two(at.getHours())}:${two(at.getMinutes())}:${two(at.getSeconds())}.${nano} (${seconds(ns)})`;
}
