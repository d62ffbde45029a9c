// The rays of a sensor_msgs/msg/LaserScan that met something: lines from the sensor, and a point at the end of each.

import { BufferAttribute, BufferGeometry, Color, Group, Points, PointsMaterial } from 'three';
import { readScan } from '../model/laser_scan.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Built } from './newest_display.ts';
import { segments } from './shapes.ts';

const MOST_RAYS = 2000;
const POINT_PIXELS = 4;
const RAY_ALPHA = 0.25;

export function scanRays(color: string): (message: unknown) => Built {
  return (message) => {
    const scan = readScan(message);
    if (scan === null) return { object: null, problem: panelTexts.scene.noScan };
    const ends = scan.positions;
    const count = Math.min(ends.length / 3, MOST_RAYS);
    const pairs = new Float32Array(count * 6);
    for (let i = 0; i < count; i += 1) pairs.set(ends.subarray(i * 3, i * 3 + 3), i * 6 + 3);
    const shade = new Color(color);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(ends), 3));
    const dots = new Points(geometry, new PointsMaterial({ color: shade, size: POINT_PIXELS, sizeAttenuation: false }));
    dots.frustumCulled = false;
    return { object: new Group().add(segments(pairs, { color: shade, alpha: RAY_ALPHA }), dots), problem: '' };
  };
}
