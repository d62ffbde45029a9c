// From the name of a message type to its parsed definition: the one way that decoder, encoder and drafts go.

import { parse } from '@foxglove/rosmsg';
import { type Definitions, gatherDefinition } from './definitions.ts';
import { buildShape, type Constant, constantsOf, type Shape } from './shape.ts';

export interface ParsedType {
  readonly name: string;
  readonly shape: Shape;
  readonly constants: readonly Constant[];
  /** As the parser gave them; the first is the type's own. */
  readonly definitions: ReturnType<typeof parse>;
}

export interface Types {
  /** By its full name (`std_msgs/msg/String`, `demo/srv/Add_Request`); a text says why it cannot be had. */
  get(type: string): ParsedType | string;
}

export function createTypes(interfaces: Definitions): Types {
  const known = new Map<string, ParsedType>();
  // More definitions may come, with a bag: what failed is tried again then.
  const failed = new Map<string, string>();
  let size = interfaces.size;
  return {
    get(type) {
      if (interfaces.size !== size) failed.clear();
      size = interfaces.size;
      const before = known.get(type) ?? failed.get(type);
      if (before !== undefined) return before;
      const found = parseType(type, interfaces);
      if (typeof found === 'string') failed.set(type, found);
      else known.set(type, found);
      return found;
    },
  };
}

function parseType(type: string, interfaces: Definitions): ParsedType | string {
  const definition = gatherDefinition(type, interfaces);
  if ('missing' in definition) {
    return definition.missing === type
      ? `the site has no definition of ${type}`
      : `the site has no definition of ${definition.missing}, which ${type} uses`;
  }
  try {
    const definitions = parse(definition.text, { ros2: true });
    return { name: type, shape: buildShape(definitions), constants: constantsOf(definitions[0]), definitions };
  } catch (error) {
    return `the definition of ${type} cannot be read: ${messageOf(error)}`;
  }
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
