/** Envelopes of SOAP 1.1 and 1.2: reads the operation in the body, and writes answers and faults. */
import type { RefusedError } from "@corridor/protocol";
import type { Refusal } from "../../platform/errors/problems.ts";
import { invalidMessage } from "./invalid-message.ts";
import type { XmlAttribute, XmlElement } from "./read-xml.ts";
import type { ObjectShape } from "./shape.ts";
import { NAMESPACE, namespaceOf, writeFields } from "./values.ts";
import { element, escapeXml } from "./write-xml.ts";

export type SoapVersion = "1.1" | "1.2";

export const soapVersions = {
  "1.1": {
    namespace: "http://schemas.xmlsoap.org/soap/envelope/",
    mediaType: "text/xml",
    /** for whom a header is */
    role: "actor",
    roles: ["", "http://schemas.xmlsoap.org/soap/actor/next"],
    codes: { sender: "Client", receiver: "Server" },
  },
  "1.2": {
    namespace: "http://www.w3.org/2003/05/soap-envelope",
    mediaType: "application/soap+xml",
    role: "role",
    roles: [
      "",
      "http://www.w3.org/2003/05/soap-envelope/role/next",
      "http://www.w3.org/2003/05/soap-envelope/role/ultimateReceiver",
    ],
    codes: { sender: "Sender", receiver: "Receiver" },
  },
} as const;

/** The envelope is refused with a code of SOAP. `message` is the sentence. */
export class EnvelopeError extends Error {
  override readonly name = "EnvelopeError";
  readonly code: "MustUnderstand" | "VersionMismatch";
  readonly refusal: Refusal;

  constructor(code: EnvelopeError["code"], refusal: Refusal) {
    super(refusal.message);
    this.code = code;
    this.refusal = refusal;
  }
}

/** The version of an envelope; null if it is none. */
export function versionOf({ name, namespace }: XmlElement): SoapVersion | null {
  if (name !== "Envelope") return null;
  if (namespace === soapVersions["1.1"].namespace) return "1.1";
  return namespace === soapVersions["1.2"].namespace ? "1.2" : null;
}

/**
 * The only element of the body.
 * @throws Refusal bad-request; EnvelopeError
 */
export function readBody(root: XmlElement): XmlElement {
  const version = versionOf(root);
  if (version === null) throw notAnEnvelope(root);
  const { namespace } = soapVersions[version];
  const parts = [...root.children];
  const isPart = (part: XmlElement | undefined, name: string): boolean =>
    part?.name === name && part.namespace === namespace;
  if (isPart(parts[0], "Header")) checkHeaders(parts.shift()?.children ?? [], version);
  const body = parts.shift();
  if (body === undefined || !isPart(body, "Body")) {
    const found = body === undefined ? "nothing" : `the element ${body.name}, ${namespaceOf(body)}`;
    throw invalidMessage("Envelope.Body", found, `the element Body of SOAP ${version}`);
  }
  const [extra] = parts;
  if (extra !== undefined) {
    throw invalidMessage(`Envelope.${extra.name}`, "an unknown element", "nothing after Body");
  }
  checkText(root, "Envelope");
  checkText(body, "Envelope.Body");
  const [operation, second] = body.children;
  if (operation === undefined) {
    throw invalidMessage("Envelope.Body", "no element", "one operation, such as Sense");
  }
  if (second !== undefined) {
    throw invalidMessage("Envelope.Body", "a second element", "one operation");
  }
  return operation;
}

function notAnEnvelope(root: XmlElement): Error {
  const namespaces = Object.values(soapVersions).map(({ namespace }) => namespace);
  const expected = `the namespace ${namespaces.join(" or ")}`;
  if (root.name === "Envelope") {
    const refusal = invalidMessage("Envelope", namespaceOf(root), expected);
    return new EnvelopeError("VersionMismatch", refusal);
  }
  return invalidMessage(root.name, "an unknown element", `the element Envelope in ${expected}`);
}

function checkText({ text }: XmlElement, path: string): void {
  if (text.trim() !== "") throw invalidMessage(path, "text between elements", "elements only");
}

/** A header that the sender requires to be understood is refused: the relay understands none. */
function checkHeaders(headers: readonly XmlElement[], version: SoapVersion): void {
  const { namespace, role, roles } = soapVersions[version];
  for (const header of headers) {
    const path = `Envelope.Header.${header.name}`;
    const own = (name: string): XmlAttribute | undefined =>
      header.attributes.find((each) => each.name === name && each.namespace === namespace);
    const must = own("mustUnderstand")?.value.trim() ?? "false";
    if (!/^(?:true|false|1|0)$/.test(must)) {
      throw invalidMessage(path, "another mustUnderstand", "the value 1 or 0");
    }
    const isForRelay = (roles as readonly string[]).includes(own(role)?.value.trim() ?? "");
    if (/^(?:false|0)$/.test(must) || !isForRelay) continue;
    const expected = "no header with mustUnderstand, because this service understands none";
    throw new EnvelopeError("MustUnderstand", invalidMessage(path, namespaceOf(header), expected));
  }
}

/** An envelope with the answer of an operation. */
export function writeAnswer(
  version: SoapVersion,
  name: string,
  value: object,
  shape: ObjectShape,
): string {
  return envelope(version, element(`${name} xmlns="${NAMESPACE}"`, writeFields(value, shape)));
}

/** A fault, and the HTTP status that its version requires. */
export interface Fault {
  status: number;
  text: string;
}

/** @param shape of `RobotFault` */
export function writeFault(
  version: SoapVersion,
  error: RefusedError | EnvelopeError,
  shape: ObjectShape,
): Fault {
  const { codes } = soapVersions[version];
  const isEnvelope = error instanceof EnvelopeError;
  const isSender = !isEnvelope && error.problem.status < 500;
  const code = isEnvelope ? error.code : isSender ? codes.sender : codes.receiver;
  const detail = isEnvelope
    ? ""
    : element(`RobotFault xmlns="${NAMESPACE}"`, faultOf(error, shape));
  return {
    status: version === "1.2" && isSender ? 400 : 500,
    text: envelope(version, faultElement(version, code, error.message, detail)),
  };
}

function faultOf({ problem, retryAfter }: RefusedError, shape: ObjectShape): string {
  const { type, detail, errors } = problem;
  return writeFields({ code: type.replace("/problems/", ""), detail, retryAfter, errors }, shape);
}

function faultElement(version: SoapVersion, code: string, reason: string, detail: string): string {
  const text = escapeXml(reason);
  if (version === "1.1") {
    const parts = [
      element("faultcode", `soap:${code}`),
      element("faultstring", text),
      detail === "" ? "" : element("detail", detail),
    ];
    return element("soap:Fault", parts.join(""));
  }
  const parts = [
    element("soap:Code", element("soap:Value", `soap:${code}`)),
    element("soap:Reason", element('soap:Text xml:lang="en"', text)),
    detail === "" ? "" : element("soap:Detail", detail),
  ];
  return element("soap:Fault", parts.join(""));
}

function envelope(version: SoapVersion, body: string): string {
  const name = `soap:Envelope xmlns:soap="${soapVersions[version].namespace}"`;
  return `<?xml version="1.0" encoding="UTF-8"?>\n${element(name, element("soap:Body", body))}`;
}
