/** The description of the service in WSDL 1.1: document/literal, wrapped, one port. */
import {
  remoteActionNames,
  commandRecordSchema,
  sensorNames,
  snapshotSchema,
} from "@corridor/protocol";
import type { SoapVersion } from "./envelope.ts";
import { faultShape, operations } from "./operations.ts";
import type { Field, ObjectShape, Shape, SimpleShape } from "./shape.ts";
import { NAMESPACE } from "./values.ts";
import { element, escapeXml } from "./write-xml.ts";

const bindings: Record<SoapVersion, string> = {
  "1.1": "http://schemas.xmlsoap.org/wsdl/soap/",
  "1.2": "http://schemas.xmlsoap.org/wsdl/soap12/",
};
const TRANSPORT = "http://schemas.xmlsoap.org/soap/http";

/** Enumerations by name, which generated clients show. */
const enumerations: readonly (readonly [name: string, values: readonly string[]])[] = [
  ["Action", remoteActionNames],
  ["CommandState", commandRecordSchema.shape.state.options],
  ["Sensor", sensorNames],
  ["RobotState", snapshotSchema.shape.state.options],
  ["Driver", snapshotSchema.shape.driver.options],
];

const builtIn: Record<SimpleShape["kind"], string> = {
  text: "string",
  time: "dateTime",
  number: "double",
  integer: "long",
  boolean: "boolean",
  "number or text": "string",
};

/** Bindings of JAX-WS, and of its versions before Jakarta EE. */
const javaNamespaces = ["https://jakarta.ee/xml/ns/jaxws", "http://java.sun.com/xml/ns/jaxws"];

const namesOfOperations = Object.keys(operations);

/** The complex and simple types, and the elements of messages. */
const schema = schemaText();

/**
 * @param address URL of the service, which generated clients contain
 */
export function writeWsdl(version: SoapVersion, address: string): string {
  const parts = [
    documentation(
      "Drives the robot in a Corridor page. Each request contains the address of the robot, or its address without the key and the header Authorization: Bearer KEY.",
    ),
    ...javaNamespaces.map(withoutWrapperStyle),
    element("wsdl:types", schema),
    ...namesOfOperations.flatMap((name) => [
      message(name, name),
      message(`${name}Response`, `${name}Response`),
    ]),
    // Java generates an exception of this name.
    message("RobotException", "RobotFault", "fault"),
    element('wsdl:portType name="Robot"', namesOfOperations.map(portOperation).join("")),
    element(
      'wsdl:binding name="RobotBinding" type="tns:Robot"',
      `<soap:binding style="document" transport="${TRANSPORT}"/>${namesOfOperations.map(boundOperation).join("")}`,
    ),
    element(
      'wsdl:service name="CorridorRobot"',
      element(
        'wsdl:port name="Robot" binding="tns:RobotBinding"',
        `<soap:address location="${escapeXml(address)}"/>`,
      ),
    ),
  ];
  const attributes = [
    'name="CorridorRobot"',
    `targetNamespace="${NAMESPACE}"`,
    `xmlns:tns="${NAMESPACE}"`,
    'xmlns:wsdl="http://schemas.xmlsoap.org/wsdl/"',
    `xmlns:soap="${bindings[version]}"`,
    'xmlns:xs="http://www.w3.org/2001/XMLSchema"',
  ];
  return `<?xml version="1.0" encoding="UTF-8"?>\n${element(`wsdl:definitions ${attributes.join(" ")}`, parts.join(""))}\n`;
}

/**
 * Java then generates one class for each message. By default each field is an argument, and
 * generators refuse a field that has other types in a request and its answer.
 */
function withoutWrapperStyle(namespace: string): string {
  return element(
    `java:bindings xmlns:java="${namespace}"`,
    element("java:enableWrapperStyle", "false"),
  );
}

function documentation(text: string): string {
  return element("wsdl:documentation", escapeXml(text));
}

function message(name: string, content: string, part = "parameters"): string {
  return element(
    `wsdl:message name="${name}"`,
    `<wsdl:part name="${part}" element="tns:${content}"/>`,
  );
}

function portOperation(name: string): string {
  const parts = [
    documentation(operations[name]?.description ?? ""),
    `<wsdl:input message="tns:${name}"/>`,
    `<wsdl:output message="tns:${name}Response"/>`,
    '<wsdl:fault name="RobotFault" message="tns:RobotException"/>',
  ];
  return element(`wsdl:operation name="${name}"`, parts.join(""));
}

function boundOperation(name: string): string {
  const parts = [
    `<soap:operation soapAction="${NAMESPACE}/${name}" style="document"/>`,
    '<wsdl:input><soap:body use="literal"/></wsdl:input>',
    '<wsdl:output><soap:body use="literal"/></wsdl:output>',
    '<wsdl:fault name="RobotFault"><soap:fault name="RobotFault" use="literal"/></wsdl:fault>',
  ];
  return element(`wsdl:operation name="${name}"`, parts.join(""));
}

function schemaText(): string {
  const types = new Map<string, string>(
    enumerations.map(([name, values]) => [
      name,
      element(`xs:simpleType name="${name}"`, restriction("string", enumerationFacets(values))),
    ]),
  );
  const elements = Object.entries(operations).flatMap(([name, { request, response }]) => [
    globalElement(name, request, types),
    globalElement(`${name}Response`, response, types),
  ]);
  elements.push(globalElement("RobotFault", faultShape, types));
  return element(
    `xs:schema targetNamespace="${NAMESPACE}" elementFormDefault="qualified"`,
    [...types.values(), ...elements].join(""),
  );
}

function globalElement(name: string, shape: ObjectShape, types: Map<string, string>): string {
  return element(`xs:element name="${name}"`, element("xs:complexType", sequence(shape, types)));
}

function sequence({ fields }: ObjectShape, types: Map<string, string>): string {
  return element("xs:sequence", fields.map((field) => fieldElement(field, types)).join(""));
}

function fieldElement(field: Field, types: Map<string, string>): string {
  const { name, shape, isOptional, isList, description } = field;
  const type = typeName(shape, types);
  const attributes = [
    `name="${name}"`,
    ...(type === null ? [] : [`type="${type}"`]),
    ...(isOptional || isList ? ['minOccurs="0"'] : []),
    ...(isList ? ['maxOccurs="unbounded"'] : []),
  ];
  const note =
    description === ""
      ? ""
      : element("xs:annotation", element("xs:documentation", escapeXml(description)));
  const contents = type === null ? note + inlineType(shape as SimpleShape) : note;
  return element(`xs:element ${attributes.join(" ")}`, contents);
}

/** The name of a type, which is added to `types`; null for a type without a name. */
function typeName(shape: Shape, types: Map<string, string>): string | null {
  if (shape.kind === "object") {
    const { name } = shape;
    if (name === null) throw new Error("a type of the WSDL has no name");
    if (!types.has(name)) {
      types.set(name, "");
      types.set(name, element(`xs:complexType name="${name}"`, sequence(shape, types)));
    }
    return `tns:${name}`;
  }
  const { kind, values, bounds } = shape;
  if (values !== null) return enumerationName(values);
  return Object.keys(bounds).length === 0 ? `xs:${builtIn[kind]}` : null;
}

/** Comparators have no names in other languages: an enumeration of them is a text. */
function enumerationName(values: readonly string[]): string {
  const listed = enumerations.find(([, each]) => isSameSet(each, values));
  return listed === undefined ? "xs:string" : `tns:${listed[0]}`;
}

function isSameSet(one: readonly string[], other: readonly string[]): boolean {
  return one.length === other.length && one.every((value) => other.includes(value));
}

function inlineType({ kind, bounds }: SimpleShape): string {
  const facets = Object.entries(bounds).map(([name, value]) => `<xs:${name} value="${value}"/>`);
  return element("xs:simpleType", restriction(builtIn[kind], facets.join("")));
}

function restriction(base: string, facets: string): string {
  return element(`xs:restriction base="xs:${base}"`, facets);
}

function enumerationFacets(values: readonly string[]): string {
  return values.map((value) => `<xs:enumeration value="${escapeXml(value)}"/>`).join("");
}
