// Compares ways to read and write CDR for Python: Python text compiled for each type (ros2wasm/codec.py), or JavaScript,
// whose objects become Python's. One interpreter, one message. Also: only to make the message, which a C extension has to do too.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { loadPyodide } from 'pyodide';
import type { PyBuffer, PyProxy } from 'pyodide/ffi';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';

const measure = `
import sys, timeit
sys.path.insert(0, '/ros/lib/python3.12/site-packages')
from ros2wasm import import_hook
import_hook.install()
from array import array
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, PointStamped
from std_msgs.msg import Header
import ros2wasm_host
from ros2wasm.codec import PAYLOAD_AT
message = PointStamped(header=Header(frame_id='map'), point=Point(x=1.0, y=2.0, z=3.0))
codec = PointStamped._codec
out = memoryview(bytearray(256))
end = codec.write(message, out, PAYLOAD_AT)
data = array('B', bytes(out))
assert codec.read(data, PAYLOAD_AT) == (message, end)
place = ros2wasm_host.address(data)
by_javascript, write_by_javascript = ros2wasm_host.read, ros2wasm_host.write

def read_by_javascript():
    return by_javascript(place).to_py()

found = read_by_javascript()
assert (found['header']['frame_id'], found['point']['z']) == ('map', 3.0)

def make():
    new = PointStamped.__new__
    m = new(PointStamped)
    m._check_fields = False
    h = m._header = new(Header)
    t = h._stamp = new(Time)
    t._sec, t._nanosec = 1, 2
    h._frame_id = 'map'
    p = m._point = new(Point)
    p._x, p._y, p._z = 1.0, 2.0, 3.0
    return m

def write():
    h, p = message._header, message._point
    s = h._stamp
    write_by_javascript(place, s._sec, s._nanosec, h._frame_id, p._x, p._y, p._z)

write()
assert codec.read(data, PAYLOAD_AT) == (message, end)

def per_second(call, count=500):
    return round(count / min(timeit.repeat(call, number=count, repeat=200)))

import json
json.dumps({'in_per_second': per_second(lambda: codec.read(data, PAYLOAD_AT)), 'in_by_javascript_per_second': per_second(read_by_javascript),
            'made_only_per_second': per_second(make), 'out_per_second': per_second(lambda: codec.write(message, out, PAYLOAD_AT)),
            'out_by_javascript_per_second': per_second(write)})
`;

/** `site`: whose archives have rclpy. */
export async function benchCdr(context: BenchContext, site: string): Promise<void> {
  const home = `${dirname(createRequire(import.meta.url).resolve('pyodide'))}/`;
  const python = await loadPyodide({ indexURL: home, env: { AMENT_PREFIX_PATH: '/ros' } });
  python.unpackArchive(new Uint8Array(readFileSync(join(site, 'python/rclpy.zip'))), 'zip', { extractDir: '/ros' });
  const kept: Uint8Array[] = [];
  const address = (bytes: PyProxy): number => {
    const buffer = (bytes as PyProxy & { getBuffer(type: string): PyBuffer; }).getBuffer('u8');
    kept.push(buffer['data'] as Uint8Array);
    return kept.length - 1;
  };
  const view = (at: number): DataView => {
    const bytes = kept[at] ?? new Uint8Array();
    return new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  };
  const decoder = new TextDecoder();
  const encoder = new TextEncoder();
  // Behind the CDR header.
  const base = 4;
  const wide = (at: number): number => base + ((at - base + 7) & -8);
  const read = (at: number): object => {
    const from = view(at);
    const length = from.getUint32(base + 8, true);
    const text = new Uint8Array(from.buffer, from.byteOffset + base + 12, length - 1);
    const point = wide(base + 12 + length);
    return {
      header: { stamp: { sec: from.getInt32(base, true), nanosec: from.getUint32(base + 4, true) }, frame_id: decoder.decode(text) },
      point: { x: from.getFloat64(point, true), y: from.getFloat64(point + 8, true), z: from.getFloat64(point + 16, true) },
    };
  };
  const write = (at: number, sec: number, nanosec: number, frame: string, x: number, y: number, z: number): void => {
    const to = view(at);
    to.setInt32(base, sec, true);
    to.setUint32(base + 4, nanosec, true);
    const { written } = encoder.encodeInto(frame, new Uint8Array(to.buffer, to.byteOffset + base + 12));
    to.setUint32(base + 8, written + 1, true);
    to.setUint8(base + 12 + written, 0);
    const point = wide(base + 13 + written);
    for (const [i, value] of [x, y, z].entries()) to.setFloat64(point + 8 * i, value, true);
  };
  python.registerJsModule('ros2wasm_host', { address, read, write });
  const rates = JSON.parse(python.runPython(measure) as string) as Record<string, number>;
  context.emit({
    bench: 'python',
    what: 'CDR of a PointStamped: by Python, peer: by JavaScript, its object as a dict of Python',
    place: 'Node.js',
    ...rates,
    machine_load: machineLoad(),
  });
  const ours = rates['in_per_second'] ?? 0;
  const others = rates['in_by_javascript_per_second'] ?? Infinity;
  if (ours < others) context.fail(`python: JavaScript reads ${others} messages a second, Python ${ours}: choose anew`);
}
