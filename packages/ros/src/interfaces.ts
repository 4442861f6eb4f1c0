/** Parsed definitions of messages, services and actions, by name. */
import { actionTexts, messageTexts, serviceTexts } from "./interface-texts.ts";

export interface Field {
  name: string;
  /** a primitive, such as `float64`, or the short name of a message */
  type: string;
  /** null: no array; 0: any length; otherwise a fixed length */
  length: number | null;
}

export interface Definition {
  fields: readonly Field[];
  constants: readonly { name: string; value: string }[];
}

const fieldPattern = /^(\S+?)(?:\[(\d*)\])? (\w+)(?:=(\S+))?$/;

function parse(text: string): Definition {
  const fields: Field[] = [];
  const constants: { name: string; value: string }[] = [];
  for (const line of text.split("\n")) {
    const [, type = "", length, name = "", value] = fieldPattern.exec(line) ?? [];
    if (name === "") continue;
    if (value === undefined) {
      fields.push({ name, type, length: length === undefined ? null : Number(length) });
    } else constants.push({ name, value });
  }
  return { fields, constants };
}

const serviceParts = ["Request", "Response"];
const actionParts = ["Goal", "Result", "Feedback"];

const definitions = new Map<string, Definition>();
for (const [name, text] of Object.entries(messageTexts)) definitions.set(name, parse(text));
for (const [name, text] of Object.entries(serviceTexts)) addParts(name, text, serviceParts);
for (const [name, text] of Object.entries(actionTexts)) addParts(name, text, actionParts);

function addParts(name: string, text: string, parts: readonly string[]): void {
  for (const [index, part] of text.split("---").entries()) {
    definitions.set(`${name}_${parts[index] ?? ""}`, parse(part));
  }
}

/** @param type short name of a message, or of a part of a service or an action */
export function definitionOf(type: string): Definition | null {
  return definitions.get(type) ?? null;
}

/** The text of a message with all messages that it contains, as rosapi returns it. */
export function fullText(type: string): string {
  const texts: Record<string, string> = messageTexts;
  return [...withNested(type)]
    .map((each, index) => {
      const text = texts[each] ?? "";
      return index === 0 ? text : `${"=".repeat(80)}\nMSG: ${fullName(each)}\n${text}`;
    })
    .join("\n");
}

/** The type and all that it contains, each once. */
export function withNested(type: string, found = new Set<string>()): Set<string> {
  const definition = definitionOf(type);
  if (definition === null || found.has(type)) return found;
  found.add(type);
  for (const field of definition.fields) withNested(field.type, found);
  return found;
}

/** `geometry_msgs/msg/Twist` and `geometry_msgs/Twist` are the same type: the second form. */
export function shortName(type: string): string {
  return type.replace(/^\//, "").replace(/\/(?:msg|srv|action)\//, "/");
}

/**
 * The form of ROS 2, such as `geometry_msgs/msg/Twist`.
 * @param type short name of a message, a service or an action, or of a request or a response
 */
export function fullName(type: string): string {
  const [whole = ""] = type.split("_Re");
  const others = Object.hasOwn(actionTexts, type) ? "action" : "msg";
  return type.replace("/", `/${Object.hasOwn(serviceTexts, whole) ? "srv" : others}/`);
}

/** Names of topics, services and actions work with and without the leading slash. */
export function absoluteName(name: string): string {
  return name.startsWith("/") ? name : `/${name}`;
}
