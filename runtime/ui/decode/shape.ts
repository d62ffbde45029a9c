// What the fields of a message are: kept beside its values, since a value alone does not tell that a
// `1` is a float64, and to show type names. Built once per type.

export interface Field {
  readonly name: string;
  /** As in the definition, without array bounds: `float64`, `geometry_msgs/msg/Point`, `time`. */
  readonly type: string;
  readonly isArray: boolean;
  /** The fields inside, when the type is a message. */
  readonly shape: Shape | null;
}

export type Shape = readonly Field[];

/** As @foxglove/rosmsg gives them. */
export interface RawDefinition {
  readonly name?: string | undefined;
  readonly definitions: readonly {
    readonly type: string;
    readonly name: string;
    readonly isComplex?: boolean;
    readonly isArray?: boolean;
    readonly isConstant?: boolean;
  }[];
}

/** The shape of the first definition. The others are found by name. */
export function buildShape(definitions: readonly RawDefinition[]): Shape {
  const byName = new Map(definitions.map((definition) => [definition.name ?? '', definition]));
  const build = (definition: RawDefinition | undefined, depth: number): Shape => {
    if (depth > 32) throw new Error('its types are nested more than 32 deep');
    return (definition?.definitions ?? [])
      .filter((field) => field.isConstant !== true)
      .map((field) => ({
        name: field.name,
        type: field.type,
        isArray: field.isArray === true,
        shape: field.isComplex === true ? build(byName.get(field.type), depth + 1) : null,
      }));
  };
  return build(definitions[0], 0);
}

export function isFloat(field: Field | undefined): boolean {
  return field?.type === 'float32' || field?.type === 'float64';
}
