import { remoteActionNames } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { readXml, type XmlElement } from "./read-xml.ts";
import { writeWsdl } from "./wsdl.ts";

const ADDRESS = "https://robots.example.org/soap";
const root = readXml(writeWsdl("1.1", ADDRESS));

const attribute = ({ attributes }: XmlElement, name: string): string | null =>
  attributes.find((each) => each.name === name)?.value ?? null;

function all(source: XmlElement, name: string): XmlElement[] {
  const inner = source.children.flatMap((child) => all(child, name));
  return source.name === name ? [source, ...inner] : inner;
}

function named(name: string, value: string): XmlElement {
  const found = all(root, name).find((each) => attribute(each, "name") === value);
  if (found === undefined) throw new Error(`no ${name} ${value}`);
  return found;
}

/** The fields of an element or type, as text: `distance? double -25600 25600`. */
function fieldsOf(owner: XmlElement): string[] {
  const [sequence] = all(owner, "sequence");
  return (sequence?.children ?? []).map((field) => {
    const isOptional = attribute(field, "minOccurs") === "0";
    const mark = attribute(field, "maxOccurs") === null ? (isOptional ? "?" : "") : "*";
    const [restriction] = all(field, "restriction");
    const type = attribute(restriction ?? field, restriction === undefined ? "type" : "base");
    const bounds = (restriction?.children ?? []).map((facet) => ` ${attribute(facet, "value")}`);
    return `${attribute(field, "name")}${mark} ${type?.replace(/^xs:|^tns:/, "")}${bounds.join("")}`;
  });
}

describe("the WSDL", () => {
  it("has the operations, each with a message for its request, its answer and its fault", () => {
    const [portType] = all(root, "portType");
    const operations = (portType?.children ?? []).map((each) => attribute(each, "name"));
    const names = ["Sense", "Command", "GetCommand", "GetCommands", "CancelCommand", "Stop"];
    expect(operations).toEqual(names);
    for (const name of names) {
      for (const element of [name, `${name}Response`]) {
        const [part] = named("message", element).children;
        expect(attribute(part ?? root, "element")).toBe(`tns:${element}`);
        expect(attribute(part ?? root, "name")).toBe("parameters");
      }
    }
    expect(all(root, "port")).toHaveLength(1);
    const wrapperStyles = all(root, "enableWrapperStyle").map(({ text }) => text);
    expect(wrapperStyles).toEqual(["false", "false"]);
  });

  it("describes a command by the fields of all actions", () => {
    expect(fieldsOf(named("element", "Command"))).toEqual([
      "robot string",
      "action Action",
      "distance? double -25600 25600",
      "ttl? double 200 60000",
      "age? double 0 3600000",
      "replace? boolean",
      "degrees? double -3600 3600",
      "left? double -1 1",
      "right? double -1 1",
      "milliseconds? double 1 60000",
      "until* UntilCondition",
      "lease? double 100 2000",
      "key? string",
      "wait? double 0 25",
    ]);
    const values = all(named("simpleType", "Action"), "enumeration").map((each) =>
      attribute(each, "value"),
    );
    expect(new Set(values)).toEqual(new Set(remoteActionNames));
  });

  it("describes conditions, records and faults", () => {
    expect(fieldsOf(named("complexType", "UntilCondition"))).toEqual([
      "sensor? Sensor",
      "is? string",
      "than? string",
      "plus? double -100000 100000",
      "goal? boolean",
    ]);
    const record = [
      "seq long 1 9007199254740991",
      "key? string",
      "action string",
      "command RecordedCommand",
      "state CommandState",
      "reason? string",
      "acceptedAt dateTime",
      "pose? Pose",
      "distance? double 0",
      "duplicate boolean",
    ];
    expect(fieldsOf(named("complexType", "CommandRecord"))).toEqual(record);
    expect(fieldsOf(named("element", "StopResponse"))).toEqual(record);
    expect(fieldsOf(named("element", "GetCommandsResponse"))).toEqual(["commands* CommandRecord"]);
    expect(fieldsOf(named("element", "RobotFault"))).toEqual([
      "code string",
      "detail string",
      "retryAfter? long 0 9007199254740991",
      "errors* FieldProblem",
    ]);
  });

  it("names no type twice, and refers only to types that it has", () => {
    const types = ["complexType", "simpleType", "element", "message"].map((kind) =>
      all(root, kind).flatMap((each) => attribute(each, "name") ?? []),
    );
    const [complex = [], simple = []] = types;
    const own = [...complex, ...simple];
    expect(new Set(own).size).toBe(own.length);
    const references = [...writeWsdl("1.1", ADDRESS).matchAll(/ type="tns:(\w+)"/g)];
    const unknown = references.filter(([, name = ""]) => ![...own, "Robot"].includes(name));
    expect(unknown).toEqual([]);
  });

  it("contains the URL of the service, and the binding of its version", () => {
    const special = writeWsdl("1.2", 'https://a.example/?"<&');
    expect(special).toContain('location="https://a.example/?&quot;&lt;&amp;"');
    expect(special).toContain('xmlns:soap="http://schemas.xmlsoap.org/wsdl/soap12/"');
    expect(all(root, "address").map((each) => attribute(each, "location"))).toEqual([ADDRESS]);
  });
});
