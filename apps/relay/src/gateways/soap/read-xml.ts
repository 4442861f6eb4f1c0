/**
 * Reads a message as a tree of elements. It contains no document type, so no entities of its own,
 * and no processing instructions. Its size and depth are bounded.
 */
import { SaxesParser } from "saxes";
import { invalidMessage } from "./invalid-message.ts";

/** Deepest element, the envelope included. */
const MAX_DEPTH = 16;

export interface XmlAttribute {
  /** without its prefix */
  name: string;
  /** "" if it has no prefix */
  namespace: string;
  value: string;
}

export interface XmlElement {
  /** without its prefix */
  name: string;
  namespace: string;
  /** without declarations of namespaces */
  attributes: readonly XmlAttribute[];
  children: readonly XmlElement[];
  /** all text that stands directly in it */
  text: string;
}

/** An element whose contents are not complete. */
interface OpenElement extends XmlElement {
  children: XmlElement[];
}

const XMLNS = "http://www.w3.org/2000/xmlns/";

/**
 * @returns the root element
 * @throws Refusal bad-request
 */
export function readXml(text: string): XmlElement {
  // XML 1.1 permits other characters.
  const parser = new SaxesParser({ xmlns: true, defaultXMLVersion: "1.0", forceXMLVersion: true });
  const open: OpenElement[] = [];
  let root: XmlElement | null = null;
  const refuse = (found: string, expected: string): never => {
    const place = [`line ${parser.line}`, ...open.map(({ name }) => name)];
    throw invalidMessage(place.join(" > "), found, expected);
  };
  const addText = (part: string): void => {
    const current = open.at(-1);
    if (current !== undefined) current.text += part;
  };
  parser.on("error", ({ message }) => {
    const [, reason = message] = /^\d+:\d+: ([^]*)$/.exec(message) ?? [];
    refuse(`text that is not XML (${reason})`, "well-formed XML");
  });
  parser.on("xmldecl", ({ version, encoding }) => {
    if (version !== "1.0") refuse(`XML ${version}`, "XML 1.0");
    if (encoding !== undefined && encoding.toLowerCase() !== "utf-8") {
      refuse(`the encoding ${encoding}`, "UTF-8");
    }
  });
  parser.on("doctype", () => refuse("a document type (DOCTYPE)", "none"));
  parser.on("processinginstruction", () => refuse("a processing instruction", "none"));
  parser.on("opentag", ({ local, uri, attributes }) => {
    if (open.length === MAX_DEPTH) refuse("a deeper element", `at most ${MAX_DEPTH} levels`);
    const element: OpenElement = {
      name: local,
      namespace: uri,
      attributes: Object.values(attributes)
        .filter((each) => each.uri !== XMLNS)
        .map((each) => ({ name: each.local, namespace: each.uri, value: each.value })),
      children: [],
      text: "",
    };
    open.at(-1)?.children.push(element);
    root ??= element;
    open.push(element);
  });
  parser.on("closetag", () => void open.pop());
  parser.on("text", addText);
  parser.on("cdata", addText);
  parser.write(text).close();
  // The parser requires a root.
  return root ?? refuse("no element", "an envelope");
}
