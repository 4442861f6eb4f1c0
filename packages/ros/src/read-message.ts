/**
 * Reads messages of clients by their definitions: an unknown field is an error, a missing field has
 * its default, and an integer is accepted for a float.
 */
import { definitionOf, type Field } from "./interfaces.ts";
import { RosError } from "./ros-error.ts";

/** The values of a message, by field. */
export interface Message {
  [field: string]: unknown;
}

const integers: Readonly<Record<string, readonly [min: number, max: number]>> = {
  byte: [0, 255],
  char: [0, 255],
  int8: [-128, 127],
  uint8: [0, 255],
  int16: [-32_768, 32_767],
  uint16: [0, 65_535],
  int32: [-2_147_483_648, 2_147_483_647],
  uint32: [0, 4_294_967_295],
};

const TIME = "builtin_interfaces/Time";

/** Field names of ROS 1 in a time. */
const timeNames: Readonly<Record<string, string>> = { secs: "sec", nsecs: "nanosec" };

/**
 * @param type short name of a message, or of a part of a service or an action
 * @param path where the message is, for errors
 * @throws RosError with the field
 */
export function readMessage(type: string, value: unknown, path = ""): Message {
  const definition = definitionOf(type);
  if (definition === null) throw new RosError(`The type ${type} is unknown.`);
  if (type === TIME && value === "now") return { sec: 0, nanosec: 0 };
  if (value !== undefined && !isObject(value)) throw invalid(path, value, "an object");
  const given = new Map(
    Object.entries(value ?? {}).map(([name, each]) => [nameIn(type, name), each]),
  );
  const message: Message = {};
  for (const field of definition.fields) {
    const fieldPath = path === "" ? field.name : `${path}.${field.name}`;
    message[field.name] = readField(field, given.get(field.name), fieldPath);
    given.delete(field.name);
  }
  const [unknown] = given.keys();
  if (unknown !== undefined) {
    const fieldPath = path === "" ? unknown : `${path}.${unknown}`;
    throw new RosError(`${fieldPath.slice(0, 80)}: ${type} has no field of this name.`);
  }
  return message;
}

/**
 * Arguments of a service or an action: an object, or a list of its fields in order.
 * @throws RosError with the field
 */
export function readArguments(type: string, args: unknown): Message {
  if (!Array.isArray(args)) return readMessage(type, args ?? undefined);
  const fields = definitionOf(type)?.fields ?? [];
  if (args.length > fields.length) {
    throw new RosError(`${type} has ${fields.length} fields, and the list has ${args.length}.`);
  }
  const named = args.map((each: unknown, index) => [fields[index]?.name ?? "", each]);
  return readMessage(type, Object.fromEntries(named));
}

function readField({ type, length }: Field, value: unknown, path: string): unknown {
  if (length === null) return readSingle(type, value, path);
  if (value === undefined) {
    return Array.from({ length }, () => readSingle(type, undefined, path));
  }
  if (!Array.isArray(value)) throw invalid(path, value, "a list");
  if (length > 0 && value.length !== length) {
    throw invalid(path, value, `a list of ${length}`);
  }
  return value.map((each: unknown, index) => readSingle(type, each, `${path}[${index}]`));
}

function readSingle(type: string, value: unknown, path: string): unknown {
  const range = integers[type];
  if (range !== undefined) {
    const [min, max] = range;
    if (value === undefined) return 0;
    if (!Number.isInteger(value) || Number(value) < min || Number(value) > max) {
      throw invalid(path, value, `a whole number from ${min} to ${max}`);
    }
    return value;
  }
  switch (type) {
    case "float32":
    case "float64":
      if (value === undefined) return 0;
      if (typeof value !== "number" || !Number.isFinite(value)) {
        throw invalid(path, value, "a number");
      }
      return value;
    case "bool":
      if (value === undefined) return false;
      if (typeof value !== "boolean") throw invalid(path, value, "true or false");
      return value;
    case "string":
      if (value === undefined) return "";
      if (typeof value !== "string") throw invalid(path, value, "a text");
      return value;
    default:
      return readMessage(type, value, path);
  }
}

function nameIn(type: string, name: string): string {
  return type === TIME && Object.hasOwn(timeNames, name) ? (timeNames[name] ?? name) : name;
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function invalid(path: string, value: unknown, expected: string): RosError {
  const where = path === "" ? "the message" : path;
  return new RosError(`${where}: found ${describe(value)}, expected ${expected}.`);
}

function describe(value: unknown): string {
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (isObject(value)) return "an object";
  return (JSON.stringify(value) ?? "nothing").slice(0, 40).replaceAll('"', "'");
}
