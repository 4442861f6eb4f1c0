/**
 * Shapes of XML elements, derived from the schemas of the API. The WSDL describes them, and values
 * are read and written by them.
 */
import { z } from "zod";
import { describeByExpectation } from "../../platform/openapi/describe-by-expectation.ts";

/** An element without inner elements. */
export interface SimpleShape {
  kind: "text" | "time" | "number" | "integer" | "boolean" | "number or text";
  /** all values of a text; null: any */
  values: readonly string[] | null;
  /** limits of a number, as XML Schema names them */
  bounds: Readonly<Record<string, number>>;
}

/** An element with inner elements. */
export interface ObjectShape {
  kind: "object";
  /** of its type in the WSDL; null: none, because only one element has this type */
  name: string | null;
  fields: readonly Field[];
}

export type Shape = SimpleShape | ObjectShape;

export interface Field {
  name: string;
  shape: Shape;
  isOptional: boolean;
  /** whether each item of a list is an element of this name */
  isList: boolean;
  /** for people; "" if there is none */
  description: string;
}

/** Names of the types that several elements share. */
export type TypeNames = z.core.$ZodRegistry<{ id: string }>;

type Json = z.core.JSONSchema.BaseSchema;

/**
 * The fields of an object. A union has the fields of all its alternatives, most of them optional,
 * because few generators of clients understand alternatives of XML Schema.
 */
export function shapeOf(schema: z.ZodType, names: TypeNames): ObjectShape {
  const json = z.toJSONSchema(schema, {
    metadata: names,
    override: (context) => {
      const { description } = z.globalRegistry.get(context.zodSchema) ?? {};
      if (description !== undefined) context.jsonSchema.description = description;
      describeByExpectation({ ...context, io: "output" });
    },
  });
  const shape = new Shapes(json.$defs ?? {}).shapeOf(json);
  if (shape.kind !== "object") throw new Error("a message is an object");
  return shape;
}

/** One object with the fields of several. */
export function joined(...shapes: readonly ObjectShape[]): ObjectShape {
  return { kind: "object", name: null, fields: shapes.flatMap(({ fields }) => fields) };
}

class Shapes {
  readonly #types: Readonly<Record<string, Json>>;

  constructor(types: Readonly<Record<string, Json>>) {
    this.#types = types;
  }

  shapeOf(json: Json): Shape {
    if (json.$ref !== undefined) {
      const name = json.$ref.replace("#/$defs/", "");
      const shape = this.shapeOf(this.#types[name] ?? {});
      return shape.kind === "object" ? { ...shape, name } : shape;
    }
    const options = optionsOf(json);
    if (options !== null) return merged(options.map((each) => this.shapeOf(each)));
    if (json.type !== "object") return simpleShape(json);
    const required = new Set(json.required);
    const fields = Object.entries(json.properties ?? {}).map(([name, value]) =>
      this.#fieldOf(name, value as Json, required.has(name)),
    );
    return { kind: "object", name: null, fields };
  }

  #fieldOf(name: string, json: Json, isRequired: boolean): Field {
    const isList = json.type === "array";
    return {
      name,
      shape: this.shapeOf(isList ? (json.items as Json) : json),
      isOptional: !isRequired || isNullable(json),
      isList,
      description: json.description ?? "",
    };
  }
}

function isNullable({ anyOf }: Json): boolean {
  return anyOf?.some((each) => (each as Json).type === "null") ?? false;
}

/** The alternatives of a union without null, or null for any other schema. */
function optionsOf({ anyOf, oneOf }: Json): Json[] | null {
  const options = (anyOf ?? oneOf) as Json[] | undefined;
  return options?.filter(({ type }) => type !== "null") ?? null;
}

const kinds: Readonly<Record<string, SimpleShape["kind"]>> = {
  string: "text",
  number: "number",
  integer: "integer",
  boolean: "boolean",
};
const boundNames = {
  minimum: "minInclusive",
  maximum: "maxInclusive",
  exclusiveMaximum: "maxExclusive",
} as const;

function simpleShape(json: Json): SimpleShape {
  const kind = json.format === "date-time" ? "time" : kinds[String(json.type)];
  if (kind === undefined) throw new Error(`no element contains a value of ${String(json.type)}`);
  const values = json.const === undefined ? json.enum : [json.const];
  const bounds = Object.entries(boundNames).flatMap(([bound, name]): [string, number][] => {
    const value: unknown = json[bound];
    return typeof value === "number" ? [[name, value]] : [];
  });
  return {
    kind,
    values: kind === "text" && values !== undefined ? values.map(String) : null,
    bounds: Object.fromEntries(bounds),
  };
}

/** One shape for all alternatives of a union. */
function merged(shapes: readonly Shape[]): Shape {
  return shapes.reduce((one, other) => {
    if (one.kind === "object" && other.kind === "object") return mergedObjects(one, other);
    if (one.kind === "object" || other.kind === "object") throw new Error("a union of two kinds");
    return mergedSimple(one, other);
  });
}

function mergedObjects(one: ObjectShape, other: ObjectShape): ObjectShape {
  const isInBoth = (name: string): boolean =>
    [one, other].every(({ fields }) => fields.some((field) => field.name === name));
  const fields = new Map<string, Field>();
  for (const field of [...one.fields, ...other.fields]) {
    const { name, shape } = field;
    const first = fields.get(name);
    if (first === undefined) {
      fields.set(name, { ...field, isOptional: field.isOptional || !isInBoth(name) });
      continue;
    }
    const both = merged([first.shape, shape]);
    const isMixed = both.kind === "number or text" && shape.kind !== "object";
    const words = isMixed ? `, or ${shape.values?.join(", ") ?? "a text"}` : "";
    fields.set(name, {
      ...first,
      shape: both,
      isOptional: first.isOptional || field.isOptional,
      description: first.description + words,
    });
  }
  return { kind: "object", name: one.name, fields: [...fields.values()] };
}

function mergedSimple(one: SimpleShape, other: SimpleShape): SimpleShape {
  const isEqual = one.kind === other.kind;
  const isEnumeration = isEqual && one.values !== null && other.values !== null;
  const values = [...new Set([...(one.values ?? []), ...(other.values ?? [])])];
  const hasBounds = isEqual && JSON.stringify(one.bounds) === JSON.stringify(other.bounds);
  return {
    kind: isEqual ? one.kind : "number or text",
    values: isEnumeration ? values : null,
    bounds: hasBounds ? one.bounds : {},
  };
}
