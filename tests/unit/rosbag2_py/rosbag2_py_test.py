"""Bags of Python nodes: written and read, in every order; of what was cut, changed or lies, what is whole, or an error.
"""
from __future__ import annotations

import contextlib
import gc
import importlib
import io
import os
import random
import tempfile
import unittest
import unittest.mock
from pathlib import Path
from typing import Any

from tests.unit.rclpy.installation import install, install_host

# Guarantee, hostile input: a bag that a node reads and that was cut, changed or made to lie gives what is whole of it
# or an exception, within bounded memory

S = 1_000_000_000
BEGIN = 1_700_000_000 * S


class BagTest(unittest.TestCase):
    rosbag2: Any
    host: Any
    given: list[tuple[str, bytes]]

    @classmethod
    def setUpClass(cls) -> None:
        install(cls, 'rosbag2_py')
        install_host(cls)
        cls.rosbag2 = importlib.import_module('rosbag2_py')
        cls.host = importlib.import_module('ros2wasm_host')
        os.environ['ROS_DISTRO'] = 'jazzy'

    def setUp(self) -> None:
        self.given = []
        setattr(self.host, 'file_give', lambda path, data: self.given.append((path, bytes(data))))
        importlib.import_module('ros2wasm.host').js.forget()
        folder = self.enterContext(tempfile.TemporaryDirectory())
        self.enterContext(contextlib.chdir(folder))
        #: What is logged.
        self.said = io.StringIO()
        self.enterContext(contextlib.redirect_stderr(self.said))
        self.enterContext(contextlib.redirect_stdout(self.said))

    def text(self, data: str) -> bytes:
        message = importlib.import_module('std_msgs.msg').String(data=data)
        done: bytes = importlib.import_module('rclpy.serialization').serialize_message(message)
        return done

    def topic(self, name: str, type_name: str = 'std_msgs/msg/String', **more: Any) -> Any:
        return self.rosbag2.TopicMetadata(0, name, type_name, 'cdr', **more)

    def options(self, uri: str, **more: Any) -> Any:
        return self.rosbag2.StorageOptions(uri=uri, **more)

    def open(self, uri: str, **more: Any) -> Any:
        writer = self.rosbag2.SequentialWriter()
        writer.open(self.options(uri, **more), self.rosbag2.ConverterOptions('', ''))
        return writer

    def write(self, uri: str, seconds: int, **more: Any) -> None:
        """Messages on /a and /b each second, those of /b before those of /a."""
        writer = self.open(uri, **more)
        for name in ('/a', '/b'):
            writer.create_topic(self.topic(name))
        for i in range(seconds):
            for name in ('/b', '/a'):
                writer.write(name, self.text(f'{name[1]}{i}'), BEGIN + i * S)
        writer.close()

    def reader(self, uri: str) -> Any:
        reader = self.rosbag2.SequentialReader()
        reader.open_uri(uri)
        return reader

    def rest(self, reader: Any) -> list[str]:
        found = []
        while reader.has_next():
            found.append(reader.read_next()[1][8:-1].decode())
        return found


class ReadAndWriteTest(BagTest):
    def test_orders_filters_and_seek(self) -> None:
        self.write('run', 3)
        reader = self.reader('run')
        self.assertEqual(self.rest(reader), ['b0', 'a0', 'b1', 'a1', 'b2', 'a2'])
        with self.assertRaisesRegex(RuntimeError, '^Bag is at end. No next message.$'):
            reader.read_next()
        reader.seek(BEGIN + S)
        self.assertEqual(reader.read_next(), ('/b', self.text('b1'), BEGIN + S))
        reader.set_filter(self.rosbag2.StorageFilter(topics=['/a']))
        self.assertEqual(self.rest(reader), ['a1', 'a2'])
        reader.seek(0)
        reader.set_filter(self.rosbag2.StorageFilter(regex='/[b-z]', exclude_topics=['/c']))
        self.assertEqual(reader.read_next()[0], '/b')
        reader.reset_filter()
        self.assertEqual(self.rest(reader), ['a0', 'b1', 'a1', 'b2', 'a2'])
        orders, order = self.rosbag2.ReadOrderSortBy, self.rosbag2.ReadOrder
        reader.seek(BEGIN + 9 * S)
        self.assertTrue(reader.set_read_order(order(orders.ReceivedTimestamp, True)))
        self.assertEqual(self.rest(reader), ['a2', 'b2', 'a1', 'b1', 'a0', 'b0'])
        self.assertFalse(reader.set_read_order(order(orders.PublishedTimestamp, False)))

    def test_what_a_bag_says(self) -> None:
        qos = self.rosbag2._storage.QoS(7).transient_local()
        writer = self.open('run', custom_data={'who': 'a "test"'})
        writer.create_topic(self.topic('/a', offered_qos_profiles=[qos], type_description_hash='RIHS01_1'))
        writer.create_topic(self.topic('/pose', 'geometry_msgs/msg/PoseStamped'))
        writer.create_topic(self.topic('/gone'))
        writer.remove_topic(self.topic('/gone'))
        writer.write('/a', self.text('x'), BEGIN + S, BEGIN)
        writer.write('/a', self.text('y'), BEGIN + 3 * S)
        writer.close()
        for metadata in (self.reader('run').get_metadata(), self.rosbag2.Info().read_metadata('run/run_0.mcap', '')):
            self.assertEqual(metadata.message_count, 2)
            self.assertEqual(metadata.duration.nanoseconds, 2 * S)
            self.assertEqual(metadata.starting_time.nanoseconds, BEGIN + S)
            self.assertEqual((metadata.ros_distro, metadata.custom_data), ('jazzy', {'who': 'a "test"'}))
            a, pose = metadata.topics_with_message_count
            self.assertEqual((a.message_count, pose.message_count), (2, 0))
            self.assertEqual(a.topic_metadata.type_description_hash, 'RIHS01_1')
            profile = self.rosbag2.convert_rclcpp_qos_to_rclpy_qos(a.topic_metadata.offered_qos_profiles[0])
            self.assertEqual((profile.depth, profile.durability.name), (7, 'TRANSIENT_LOCAL'))
        again = self.rosbag2.MetadataIo()
        self.assertEqual(
            again.serialize_metadata(again.deserialize_metadata(again.serialize_metadata(metadata))),
            again.serialize_metadata(metadata))
        shown = str(self.reader('run').get_metadata()).splitlines()
        self.assertEqual(shown[1], 'Files:             run_0.mcap')
        self.assertIn('Duration:          2.000000000s', shown)
        self.assertIn('Topic information: Topic: /a | Type: std_msgs/msg/String | Count: 2 | Serialization Format: cdr',
                      shown)
        definitions = {one.topic_type: one for one in self.reader('run').get_all_message_definitions()}
        self.assertEqual(definitions['std_msgs/msg/String'].encoding, 'ros2msg')
        pose = definitions['geometry_msgs/msg/PoseStamped'].encoded_message_definition
        self.assertIn('\nMSG: geometry_msgs/Quaternion\n', pose)
        self.assertIn('\nMSG: builtin_interfaces/Time\n', pose)
        self.assertEqual([Path(path).name for path, _ in self.given], ['run_0.mcap', 'metadata.yaml'])
        self.assertEqual(self.given[0][1], Path('run/run_0.mcap').read_bytes())

    def test_several_files(self) -> None:
        self.write('run', 7, max_bagfile_duration=2)
        self.assertEqual(sorted(os.listdir('run')), ['metadata.yaml', 'run_0.mcap', 'run_1.mcap', 'run_2.mcap'])
        reader = self.reader('run')
        self.assertEqual(self.rest(reader)[::2], [f'b{i}' for i in range(7)])
        reader.seek(BEGIN + S)
        self.assertEqual(self.rest(reader)[0], 'b1')
        reader.seek(BEGIN + 5 * S)
        self.assertEqual(self.rest(reader), ['b5', 'a5', 'b6', 'a6'])
        self.write('sized', 100, max_bagfile_size=2000)
        self.assertEqual(len(self.rest(self.reader('sized'))), 200)
        self.assertGreater(len(os.listdir('sized')), 3)

    def test_forms(self) -> None:
        self.write('loose', 2, storage_preset_profile='fastwrite')
        self.assertEqual(self.rest(self.reader('loose')), ['b0', 'a0', 'b1', 'a1'])
        self.write('between', 5, start_time_ns=BEGIN + S, end_time_ns=BEGIN + 2 * S)
        self.assertEqual(self.rest(self.reader('between')), ['b1', 'a1', 'b2', 'a2'])
        writer = self.open('snapshot', snapshot_mode=True, max_cache_size=50)
        writer.create_topic(self.topic('/a'))
        for i in range(9):
            writer.write('/a', self.text(str(i)), BEGIN + i)
        self.assertTrue(writer.take_snapshot())
        writer.close()
        kept = self.rest(self.reader('snapshot'))
        self.assertEqual(kept[-1], '8')
        self.assertLess(len(kept), 9)

    def test_a_writer_that_goes_closes_its_bag(self) -> None:
        writer = self.open('run')
        writer.create_topic(self.topic('/a'))
        writer.write('/a', self.text('x'), BEGIN)
        self.assertFalse(os.path.exists('run/metadata.yaml'))
        del writer
        gc.collect()
        self.assertEqual(self.rest(self.reader('run')), ['x'])

    def test_refusals(self) -> None:
        self.write('run', 1)
        refused: tuple[tuple[str, dict[str, Any], str], ...] = (
            ('run', {}, "^Bag directory already exists \\(run\\), can't overwrite existing bag$"),
            ('sql', {'storage_id': 'sqlite3'}, '`ros2 bag convert`'),
            ('strange', {'storage_id': 'strange'}, '^No storage could be initialized. Abort$'),
            ('small', {'max_bagfile_size': 10}, '^Invalid bag splitting size given'),
            ('snap', {'snapshot_mode': True}, '^Max cache size must be greater than 0'),
            ('packed', {'storage_preset_profile': 'zstd_fast'}, 'needs a compression'),
        )
        for uri, more, why in refused:
            with self.subTest(uri), self.assertRaisesRegex(RuntimeError, why):
                self.open(uri, **more)
        writer = self.rosbag2.SequentialWriter()
        with self.assertRaisesRegex(RuntimeError, '^Bag is not open. Call open\\(\\) before writing.$'):
            writer.write('/a', b'', 0)
        with self.assertRaisesRegex(RuntimeError, '^Could not find converter for format json$'):
            writer.open(self.options('x'), self.rosbag2.ConverterOptions('cdr', 'json'))
        writer.open(self.options('other'), self.rosbag2.ConverterOptions('cdr', 'cdr'))
        with self.assertRaisesRegex(RuntimeError, "^Failed to write on topic '/a'. Call create_topic\\(\\) before"):
            writer.write('/a', b'', 0)
        with self.assertRaises(TypeError):
            writer.write('/a', 'text', 0)
        writer.close()
        Path('no.mcap').write_bytes(b'anything')
        for uri, why in (('none', '^No storage could be initialized from the inputs.$'), ('old.db3', 'sqlite3'),
                         ('no.mcap', '^No storage could be initialized from the inputs.$')):
            with self.subTest(uri), self.assertRaisesRegex(RuntimeError, why):
                self.reader(uri)
        self.assertIn("Could not open 'no.mcap' with 'mcap'. Error: invalid magic bytes", self.said.getvalue())
        os.mkdir('bad')
        for text in ('rosbag2_bagfile_information: {version: x}', 'a: 1', '- ' * 50_000, '[' * 50_000, 'x: "'):
            Path('bad/metadata.yaml').write_text(text, encoding='utf-8')
            with self.subTest(text[:20]), self.assertRaisesRegex(RuntimeError, '^Exception on parsing info file: '):
                self.reader('bad')

    def test_profiles_of_older_bags(self) -> None:
        older = ('- history: 3\n  depth: 0\n  reliability: 1\n  durability: 2\n  deadline:\n    sec: 2147483647\n'
                 '    nsec: 4294967295\n  lifespan:\n    sec: 0\n    nsec: 0\n  liveliness: 1\n'
                 '  liveliness_lease_duration:\n    sec: 0\n    nsec: 0\n  avoid_ros_namespace_conventions: false')
        [qos] = self.rosbag2.to_rclcpp_qos_vector(older, 4)
        profile = self.rosbag2.convert_rclcpp_qos_to_rclpy_qos(qos)
        self.assertEqual((profile.reliability.name, profile.history.name), ('RELIABLE', 'UNKNOWN'))
        self.assertEqual(profile.deadline.nanoseconds, (1 << 63) - 1)
        with self.assertRaises(RuntimeError):
            self.rosbag2.to_rclcpp_qos_vector('- history: 1', 9)


class HostileTest(BagTest):
    def whole(self, **more: Any) -> bytes:
        writer_module = importlib.import_module('rosbag2_py._mcap_writer')
        with unittest.mock.patch.object(writer_module, 'CHUNK_SIZE', 200):
            self.write('run', 20, **more)
        return Path('run/run_0.mcap').read_bytes()

    def read(self, data: bytes) -> list[str]:
        Path('x.mcap').write_bytes(data)
        return self.rest(self.reader('x.mcap'))

    def test_cut_anywhere_it_gives_what_is_whole(self) -> None:
        whole, most = self.whole(), 0
        for length in range(0, len(whole), 23):
            try:
                count = len(self.read(whole[:length]))
            except RuntimeError:
                self.assertEqual(most, 0, length)
                continue
            self.assertGreaterEqual(count, most)
            most = count
        self.assertEqual(most, 40)

    def test_changed_anywhere_it_gives_messages_or_an_error(self) -> None:
        chance = random.Random(7)
        whole = self.whole()
        for _ in range(400):
            changed = bytearray(whole)
            for _ in range(chance.randint(1, 4)):
                changed[chance.randrange(len(changed))] = chance.choice((0xFF, chance.randrange(256)))
            try:
                self.assertLessEqual(len(self.read(bytes(changed))), 40)
            except RuntimeError:
                pass

    def test_a_chunk_that_lies_is_an_error(self) -> None:
        mcap = importlib.import_module('rosbag2_py._mcap_records')
        inside = mcap.record(mcap.MESSAGE, mcap.MESSAGE_HEAD.pack(1, 0, 5, 5) + self.text('x'))

        def damage(size: int, crc: int, compression: str, packed_size: int) -> str:
            head = (5).to_bytes(8, 'little') * 2 + size.to_bytes(8, 'little') + crc.to_bytes(4, 'little') \
                + mcap.text(compression) + packed_size.to_bytes(8, 'little')
            Path('x.mcap').write_bytes(
                mcap.MAGIC + mcap.record(mcap.HEADER, mcap.text('') + mcap.text(''))
                + mcap.schema_bytes(mcap.Schema(1, 'std_msgs/msg/String', '', b''))
                + mcap.channel_bytes(mcap.Channel(1, 1, '/a', 'cdr', {})) + mcap.record(mcap.CHUNK, head + inside))
            found: str = importlib.import_module('rosbag2_py._mcap_reader').McapReader('x.mcap').damage
            return found
        size = len(inside)
        self.assertEqual(damage(size, 0, '', size), 'it ends early')
        self.assertEqual(self.rest(self.reader('x.mcap')), ['x'])
        self.assertEqual(damage(size, 1, '', size), 'a chunk is not as it was written')
        self.assertEqual(damage(size + 1, 0, '', size), 'a chunk has other bytes than it says')
        self.assertEqual(damage(size, 0, '', size + 1), 'a chunk is shorter than it says')
        self.assertEqual(damage(1 << 60, 0, '', size), f'a chunk of {1 << 60} bytes is too large')
        self.assertEqual(damage(100 << 20, 0, 'lz4', size), 'LZ4 data are too short for what they say')
        self.assertIn('compressed with zstd', damage(size, 0, 'zstd', size))
        self.assertEqual(damage(size, 0, 'z' * 40, size), 'a record is shorter than it says')

    def test_lz4(self) -> None:
        mcap = importlib.import_module('rosbag2_py._mcap_records')
        fox = 'the quick brown fox jumps over the lazy dog'
        words = f'{fox}, {fox}. {"a" * 80}'.encode()
        # Made by lz4 1.9.4: lz4 -BD --content-size
        frame = bytes.fromhex(
            '04224d186440a740000000f01074686520717569636b2062726f776e20666f78206a756d7073206f766572201f00'
            '916c617a7920646f672c0e000f2d00143f2e2061010037506161616161000000006dab4372')
        self.assertEqual(mcap.unpack_lz4(frame, len(words)), words)
        for size in (len(words) - 1, len(words) + 1):
            self.assertRaises(mcap.Damaged, mcap.unpack_lz4, frame, size)
        for length in range(1, len(frame) - 4):
            self.assertRaises(mcap.Damaged, mcap.unpack_lz4, frame[:length], len(words))
        chance = random.Random(3)
        for _ in range(3000):
            changed = bytearray(frame)
            changed[chance.randrange(len(frame))] = chance.randrange(256)
            try:
                self.assertEqual(len(mcap.unpack_lz4(bytes(changed), len(words))), len(words))
            except mcap.Damaged:
                pass


if __name__ == '__main__':
    unittest.main()
