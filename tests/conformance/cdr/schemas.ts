// The fields of every message, request, response and derived action message, by full name, in the
// form that @foxglove/rosmsg2-serialization takes. Made from the definition files, not from our
// generator's output.
import type { MessageDefinition, MessageDefinitionField } from '@foxglove/message-definition';

import { isPrimitive, parseInterface, typeParts } from '../interfaces/definition_parser.ts';
import type { Field, Section } from '../interfaces/definition_parser.ts';
import type { InterfaceFile } from '../interfaces/interface_files.ts';

export type Schemas = ReadonlyMap<string, readonly MessageDefinitionField[]>;

// These have the same bytes as an integer type that every reader knows.
const ALIASES: ReadonlyMap<string, string> = new Map([['byte', 'uint8'], ['char', 'uint8']]);

function field(file: InterfaceFile, { type, name }: Pick<Field, 'type' | 'name'>): MessageDefinitionField {
  const parts = typeParts(type);
  const [pkg, short] = parts.base.includes('/') ? parts.base.split('/') : [file.package, parts.base];
  const simple = isPrimitive(parts.base);
  return {
    name,
    type: simple ? (ALIASES.get(parts.base) ?? parts.base) : `${pkg}/msg/${short}`,
    isComplex: !simple,
    isArray: parts.container !== 'none',
    ...(parts.container === 'array' ? { arrayLength: parts.size } : {}),
    ...(parts.container === 'bounded' ? { arrayUpperBound: parts.size } : {}),
    ...(parts.stringBound === undefined ? {} : { upperBound: parts.stringBound }),
  };
}

function nested(name: string, type: string): MessageDefinitionField {
  return { name, type, isComplex: true, isArray: false };
}

function fields(file: InterfaceFile, section: Section | undefined): MessageDefinitionField[] {
  if (section === undefined) throw new Error(`${file.type} lacks a section`);
  return section.fields.map((one) => field(file, one));
}

export function schemasOf(files: readonly InterfaceFile[]): Schemas {
  const schemas = new Map<string, readonly MessageDefinitionField[]>();
  for (const file of files) {
    const sections = parseInterface(file.kind, file.text);
    switch (file.kind) {
      case 'msg':
        schemas.set(file.type, fields(file, sections.get('')));
        break;
      case 'srv':
        schemas.set(`${file.type}_Request`, fields(file, sections.get('request')));
        schemas.set(`${file.type}_Response`, fields(file, sections.get('response')));
        break;
      case 'action': {
        const id = nested('goal_id', 'unique_identifier_msgs/msg/UUID');
        const plain = (type: string, name: string) => field(file, { type, name });
        schemas.set(`${file.type}_Goal`, fields(file, sections.get('goal')));
        schemas.set(`${file.type}_Result`, fields(file, sections.get('result')));
        schemas.set(`${file.type}_Feedback`, fields(file, sections.get('feedback')));
        schemas.set(`${file.type}_SendGoal_Request`, [id, nested('goal', `${file.type}_Goal`)]);
        schemas.set(`${file.type}_SendGoal_Response`, [
          plain('bool', 'accepted'),
          nested('stamp', 'builtin_interfaces/msg/Time'),
        ]);
        schemas.set(`${file.type}_GetResult_Request`, [id]);
        schemas.set(`${file.type}_GetResult_Response`, [
          plain('int8', 'status'),
          nested('result', `${file.type}_Result`),
        ]);
        schemas.set(`${file.type}_FeedbackMessage`, [id, nested('feedback', `${file.type}_Feedback`)]);
        break;
      }
    }
  }
  return schemas;
}

/** The definitions for one type: itself without a name, then all it refers to. */
export function definitionsFor(schemas: Schemas, type: string): MessageDefinition[] {
  const found = new Map<string, readonly MessageDefinitionField[]>();
  const queue = [type];
  for (let name = queue.pop(); name !== undefined; name = queue.pop()) {
    const list = schemas.get(name);
    if (list === undefined) throw new Error(`no schema of ${name}`);
    found.set(name, list);
    for (const one of list) if (one.isComplex === true && !found.has(one.type)) queue.push(one.type);
  }
  const root = [...(found.get(type) ?? [])];
  return [
    { definitions: root },
    ...[...found].map(([name, list]) => ({ name, definitions: [...list] })),
  ];
}
