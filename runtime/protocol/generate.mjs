// Writes generated/constants.{hpp,ts} and ../packages/client/rclpy/ros2wasm/constants.py from constants.json.
// `--check` writes nothing and exits 1 when a generated file is not current.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';

const here = new URL('./', import.meta.url);
const source = JSON.parse(readFileSync(new URL('constants.json', here), 'utf8'));
const note = 'Made from runtime/protocol/constants.json by generate.mjs; change that file instead.';

const sizes = { u32: 4, i32: 4, ptr: 4, i64: 8, gid: 16 };
const cppTypes = { u32: 'uint32_t', i32: 'int32_t', ptr: 'uint32_t', i64: 'int64_t', gid: 'uint8_t' };

const pascal = (name) => name.split('_').map((w) => w[0].toUpperCase() + w.slice(1)).join('');
const camel = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
const snake = (name) => name.replace(/(?<=[a-z])[A-Z]/g, '_$&').toLowerCase();
const upper = (name) => name.toUpperCase();

/** Fields with their offsets; throws when the declared size is wrong. */
function layout(struct) {
  let offset = 0;
  const fields = struct.fields.map(([name, type, doc]) => {
    const size = sizes[type];
    if (size === undefined) throw new Error(`${struct.name}.${name}: unknown type ${type}`);
    if (offset % Math.min(size, 8) !== 0) throw new Error(`${struct.name}.${name} is not aligned`);
    const field = { name, type, doc, offset, size };
    offset += size;
    return field;
  });
  if (offset !== struct.size) throw new Error(`${struct.name} has ${offset} bytes, not ${struct.size}`);
  return fields;
}

function cpp() {
  const out = [`// ${note}`, '#pragma once', '', '#include <cstddef>', '#include <cstdint>', '', 'namespace ros2wasm::protocol', '{', ''];
  for (const { name, value, doc } of source.values) {
    out.push(`/// ${doc}`, `inline constexpr int32_t k${pascal(name)} = ${value};`);
  }
  for (const { name, doc, members } of source.enums) {
    out.push('', `/// ${doc}`, `enum class ${name} : int32_t`, '{');
    for (const [member, value] of Object.entries(members)) out.push(`  k${pascal(member)} = ${value},`);
    out.push('};');
  }
  for (const { name, doc, members } of source.layouts) {
    out.push('', `/// ${doc}`, `namespace ${snake(name)}`, '{');
    for (const [member, value] of Object.entries(members)) out.push(`inline constexpr int32_t k${pascal(member)} = ${value};`);
    out.push(`}  // namespace ${snake(name)}`);
  }
  for (const struct of source.structs) {
    const fields = layout(struct);
    out.push('', `/// ${struct.doc}`, `struct ${struct.name}`, '{');
    for (const { name, type, doc } of fields) {
      out.push(`  ${cppTypes[type]} ${name}${type === 'gid' ? '[16]' : ''};  ///< ${doc}`);
    }
    out.push('};', `static_assert(sizeof(${struct.name}) == ${struct.size});`);
    for (const { name, offset } of fields) {
      out.push(`static_assert(offsetof(${struct.name}, ${name}) == ${offset});`);
    }
  }
  out.push('', '}  // namespace ros2wasm::protocol', '');
  return out.join('\n');
}

function ts() {
  const out = [`// ${note}`, ''];
  for (const { name, value, doc } of source.values) {
    out.push(`/** ${doc} */`, `export const ${camel(name)} = ${value};`);
  }
  for (const { name, doc, members } of source.enums) {
    out.push('', `/** ${doc} */`, `export const ${name} = {`);
    for (const [member, value] of Object.entries(members)) out.push(`  ${camel(member)}: ${value},`);
    out.push('} as const;', `export type ${name} = (typeof ${name})[keyof typeof ${name}];`);
  }
  for (const { name, doc, members } of source.layouts) {
    out.push('', `/** ${doc} */`, `export const ${name} = {`);
    for (const [member, value] of Object.entries(members)) out.push(`  ${camel(member)}: ${value},`);
    out.push('} as const;');
  }
  for (const struct of source.structs) {
    out.push('', `/** Byte offsets. ${struct.doc} */`, `export const ${struct.name}Layout = {`, `  size: ${struct.size},`);
    for (const { name, offset } of layout(struct)) out.push(`  ${camel(name)}: ${offset},`);
    out.push('} as const;');
  }
  out.push('');
  return out.join('\n');
}

function py() {
  const out = [`"""${note}"""`, '', 'from enum import IntEnum', ''];
  for (const { name, value, doc } of source.values) out.push(`#: ${doc}`, `${upper(name)} = ${value}`);
  for (const { name, doc, members } of source.enums) {
    out.push('', '', `class ${name}(IntEnum):`, `    """${doc}"""`, '');
    for (const [member, value] of Object.entries(members)) out.push(`    ${upper(member)} = ${value}`);
  }
  const formats = { u32: 'I', i32: 'i', ptr: 'I', i64: 'q', gid: '16s' };
  out.push('');
  for (const struct of source.structs) {
    const fields = layout(struct);
    out.push('', `#: struct format. ${struct.doc}`, `${upper(snake(struct.name))}_FORMAT = "<${fields.map((f) => formats[f.type]).join('')}"`);
  }
  out.push('');
  return out.join('\n');
}

const check = process.argv.includes('--check');
let stale = 0;
mkdirSync(new URL('generated/', here), { recursive: true });
for (
  const [file, text] of [
    ['protocol/generated/constants.hpp', cpp()],
    ['protocol/generated/constants.ts', ts()],
    ['packages/client/rclpy/ros2wasm/constants.py', py()],
  ]
) {
  const url = new URL(`../${file}`, here);
  if (!check) {
    writeFileSync(url, text);
    continue;
  }
  let old = '';
  try {
    old = readFileSync(url, 'utf8');
  } catch {
    // A missing file is a stale file.
  }
  if (old !== text) {
    console.error(`runtime/${file} is not current: node runtime/protocol/generate.mjs`);
    stale = 1;
  }
}
process.exitCode = stale;
