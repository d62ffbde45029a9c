// The types of a message's fields, stored beside its values: a value alone does not tell that a
// `1` is a float64, and to show type names. Built once per type.

export interface Constant {
  readonly name: string;
  readonly type: string;
  readonly value: string | number | bigint | boolean;
}

export type DefaultValue = string | number | bigint | boolean | readonly (string | number | bigint | boolean)[];

export interface Field {
  readonly name: string;
  /** As in the definition, without array bounds: `float64`, `geometry_msgs/msg/Point`, `time`. */
  readonly type: string;
  readonly isArray: boolean;
  /** The number of items of an array with a fixed length. */
  readonly length?: number;
  /** The most items that an array may have. */
  readonly mostItems?: number;
  /** The most bytes that a text may have. */
  readonly mostBytes?: number;
  readonly defaultValue?: DefaultValue;
  /** The fields inside, when the type is a message. */
  readonly shape: Shape | null;
  /** The constants of the message type of this field. */
  readonly constants?: readonly Constant[];
}

export type Shape = readonly Field[];

/** As @foxglove/rosmsg gives them. */
export interface RawField {
  readonly type: string;
  readonly name: string;
  readonly isComplex?: boolean;
  readonly isArray?: boolean;
  readonly isConstant?: boolean;
  readonly value?: string | number | bigint | boolean | undefined;
  readonly arrayLength?: number | undefined;
  readonly arrayUpperBound?: number;
  readonly upperBound?: number;
  readonly defaultValue?: DefaultValue | undefined;
}

export interface RawDefinition {
  readonly name?: string | undefined;
  readonly definitions: readonly RawField[];
}

/** The shape of the first definition. The others are found by name. */
export function buildShape(definitions: readonly RawDefinition[]): Shape {
  const byName = new Map(definitions.map((definition) => [definition.name ?? '', definition]));
  const build = (definition: RawDefinition | undefined, depth: number): Shape => {
    if (depth > 32) throw new Error('its types are nested more than 32 deep');
    return (definition?.definitions ?? [])
      .filter((field) => field.isConstant !== true)
      .map((field) => {
        const inner = field.isComplex === true ? byName.get(field.type) : undefined;
        return {
          name: field.name,
          type: field.type,
          isArray: field.isArray === true,
          ...(field.arrayLength === undefined ? {} : { length: field.arrayLength }),
          ...(field.arrayUpperBound === undefined ? {} : { mostItems: field.arrayUpperBound }),
          ...(field.upperBound === undefined ? {} : { mostBytes: field.upperBound }),
          ...(field.defaultValue === undefined ? {} : { defaultValue: field.defaultValue }),
          shape: field.isComplex === true ? build(inner, depth + 1) : null,
          ...(inner === undefined ? {} : { constants: constantsOf(inner) }),
        };
      });
  };
  return build(definitions[0], 0);
}

export function constantsOf(definition: RawDefinition | undefined): readonly Constant[] {
  return (definition?.definitions ?? []).flatMap(({ isConstant, name, type, value }) =>
    isConstant === true && value !== undefined ? [{ name, type, value }] : []
  );
}

export function isFloat(field: Field | undefined): boolean {
  return field?.type === 'float32' || field?.type === 'float64';
}
