// Robot descriptions: what is seen of their links, and texts that are none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readUrdf } from '../../../runtime/site/ui/model/urdf.ts';
import { readXml } from '../../../runtime/site/ui/model/xml.ts';

test('elements, attributes and entities are read; comments, words and declarations are skipped', () => {
  const root = readXml(`<?xml version="1.0"?><!DOCTYPE robot><!-- <a> -->
<x:robot a = "1 &lt; 2 &#65;&#x42; &odd;" b='"'> words <![CDATA[ </x:robot> ]]> <link/><link name="two"></link ></x:robot>\n`);
  assert.equal(root?.name, 'robot');
  assert.deepEqual([...(root?.attributes ?? [])], [['a', '1 < 2 AB &odd;'], ['b', '"']]);
  assert.deepEqual(root?.children.map(({ name, attributes }) => [name, attributes.get('name')]), [['link', undefined], ['link', 'two']]);
});

test('what is not an XML is refused, and nothing takes long', () => {
  const wrong = [
    '',
    'words',
    '<',
    '<a',
    '<a>',
    '<a></b>',
    '</a>',
    '<a/><b/>',
    '<a b=c/>',
    '<a b="<"/>',
    '<!-- no end',
    '<a><!-- --></a',
    '<a ""/>',
    '<!DOCTYPE r [<!ENTITY a "x">]><r b="&a;"/>',
    '<a>'.repeat(100_000),
    '<a '.repeat(100_000),
    `<a${' b="1"'.repeat(10_000)}`,
    `<a>${'<b/>'.repeat(300_000)}</a>`,
    `<a b="${' '.repeat(1_000_000)}`,
    `<a${' '.repeat(1_000_000)}`,
  ];
  for (const text of wrong) assert.equal(readXml(text), null, text.slice(0, 40));
});

test('shapes of links have their places and colours', () => {
  const robot = readUrdf(`<robot name="arm"><material name="red"><color rgba="1 0 0 1"/></material>
    <link name="a"><visual><origin xyz="1 2 3"/><geometry><box size="1 2 3"/></geometry><material name="red"/></visual>
      <visual><geometry><sphere radius="0.5"/></geometry><material name="own"><color rgba="0 1 0 0.5"/></material></visual></link>
    <link name="b"><visual><origin rpy="0 0 1.5707963"/><geometry><cylinder radius="1" length="2"/></geometry></visual>
      <visual><geometry><mesh filename="package://x/y.stl"/></geometry></visual><visual><geometry><box size="1 2"/></geometry></visual>
      <visual><geometry><sphere radius="-1"/></geometry></visual><visual><origin xyz="1e99 0 0"/><geometry><sphere radius="1"/></geometry></visual>
      <visual/></link>
    <link/></robot>`);
  assert.ok(typeof robot !== 'string');
  assert.equal(robot.leftOut, 4);
  assert.deepEqual(robot.links[1]?.visuals[1]?.shape, { kind: 'mesh', file: 'package://x/y.stl', scale: [1, 1, 1] });
  const [a, b, c] = robot.links;
  assert.deepEqual(a?.visuals[0], {
    origin: { translation: [1, 2, 3], rotation: [0, 0, 0, 1] },
    shape: { kind: 'box', size: [1, 2, 3] },
    color: [1, 0, 0, 1],
  });
  assert.deepEqual([a?.visuals[1]?.shape, a?.visuals[1]?.color], [{ kind: 'sphere', radius: 0.5 }, [0, 1, 0, 0.5]]);
  assert.deepEqual(b?.visuals[0]?.shape, { kind: 'cylinder', radius: 1, length: 2 });
  assert.ok(Math.abs((b?.visuals[0]?.origin.rotation[3] ?? 0) - Math.SQRT1_2) < 1e-6);
  assert.deepEqual([c?.name, c?.visuals], ['', []]);
  assert.equal(readUrdf('<html/>'), 'no-robot');
  assert.equal(readUrdf('<robot>'), 'no-xml');
  assert.equal(readUrdf(' '.repeat(20_000_000)), 'too-long');
});
