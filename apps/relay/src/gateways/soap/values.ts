/** Converts between elements and the values that the schemas of the API check. */
import { invalidMessage } from "./invalid-message.ts";
import type { XmlElement } from "./read-xml.ts";
import type { Field, ObjectShape, Shape, SimpleShape } from "./shape.ts";
import { element, escapeXml } from "./write-xml.ts";

/** The namespace of all elements in the body of a message. */
export const NAMESPACE = "urn:corridor:robot:1";

const XSI = "http://www.w3.org/2001/XMLSchema-instance";
const XML = "http://www.w3.org/XML/1998/namespace";

/** `1`, `-2.5`, `+.5` or `1E-7`. `NaN` and `INF` stay texts, which no schema accepts. */
const NUMBER = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?$/;
const INTEGER = /^[+-]?\d+$/;

type Values = Record<string, unknown>;

/**
 * The inner elements as fields, in any order. The values are not checked: one that its shape does not
 * permit stays a text.
 * @param path of the element, for errors; "" for the operation
 * @throws Refusal bad-request
 */
export function readFields(source: XmlElement, shape: ObjectShape, path = ""): Values {
  checkContents(source, path);
  const found = new Map<string, unknown[]>();
  for (const child of source.children) {
    const at = join(path, child.name);
    const field = shape.fields.find(({ name }) => name === child.name);
    if (child.namespace !== NAMESPACE) {
      throw invalidMessage(at, namespaceOf(child), `the namespace ${NAMESPACE}`);
    }
    if (field === undefined) {
      const names = shape.fields.map(({ name }) => name).join(", ");
      throw invalidMessage(at, "an unknown element", `one of ${names}`);
    }
    const values = found.get(field.name) ?? [];
    if (values.length > 0 && !field.isList) {
      throw invalidMessage(at, "a second element of this name", "it once");
    }
    values.push(valueOf(child, field.shape, field.isList ? `${at}[${values.length}]` : at));
    found.set(field.name, values);
  }
  return Object.fromEntries(
    shape.fields.flatMap(({ name, isList }) => {
      const values = found.get(name);
      return values === undefined ? [] : [[name, isList ? values : values[0]]];
    }),
  );
}

/** The text of one field, before the others are read. @returns null if it is missing */
export function readText({ children }: XmlElement, name: string): string | null {
  const field = children.find((each) => each.name === name && each.namespace === NAMESPACE);
  return field === undefined ? null : field.text.trim();
}

export function namespaceOf({ namespace }: XmlElement): string {
  return namespace === "" ? "no namespace" : `the namespace ${namespace}`;
}

function valueOf(source: XmlElement, shape: Shape, path: string): unknown {
  if (shape.kind === "object") return readFields(source, shape, path);
  checkAttributes(source, path);
  const [child] = source.children;
  if (child !== undefined) {
    throw invalidMessage(join(path, child.name), "an element", `the text of ${source.name} only`);
  }
  return parse(source.text.trim(), shape);
}

function parse(text: string, { kind }: SimpleShape): unknown {
  if (kind === "boolean" && /^(?:true|false|1|0)$/.test(text)) return /^(?:true|1)$/.test(text);
  if (kind === "integer" && INTEGER.test(text)) return Number(text);
  if ((kind === "number" || kind === "number or text") && NUMBER.test(text)) return Number(text);
  return text;
}

function join(path: string, name: string): string {
  return path === "" ? name : `${path}.${name}`;
}

/** Elements with inner elements contain nothing else. */
function checkContents(source: XmlElement, path: string): void {
  checkAttributes(source, path);
  if (source.text.trim() === "") return;
  throw invalidMessage(path === "" ? source.name : path, "text between elements", "elements only");
}

/** Generated clients may add attributes of XML Schema, but no element is nillable. */
function checkAttributes({ name, attributes }: XmlElement, path: string): void {
  for (const attribute of attributes) {
    const { namespace, value } = attribute;
    const isNil = namespace === XSI && attribute.name === "nil" && /^\s*(?:true|1)\s*$/.test(value);
    if ((namespace === XSI && !isNil) || namespace === XML) continue;
    const expected = isNil ? "no element where there is no value" : "no attributes";
    throw invalidMessage(path === "" ? name : path, `the attribute ${attribute.name}`, expected);
  }
}

/** The elements of an object, in the order of its shape. Null and missing values have none. */
export function writeFields(value: object, { fields }: ObjectShape): string {
  const values = value as Values;
  return fields.map((field) => writeField(values[field.name], field)).join("");
}

function writeField(value: unknown, { name, shape, isList }: Field): string {
  if (value === undefined || value === null) return "";
  const items = isList ? (value as unknown[]) : [value];
  return items
    .map((item) =>
      element(
        name,
        shape.kind === "object" ? writeFields(item as object, shape) : escapeXml(String(item)),
      ),
    )
    .join("");
}
