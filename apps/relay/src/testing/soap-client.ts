/** SOAP messages for tests, and their answers. */
import { soapVersions, type SoapVersion } from "../gateways/soap/envelope.ts";
import { readXml, type XmlElement } from "../gateways/soap/read-xml.ts";
import { NAMESPACE } from "../gateways/soap/values.ts";
import { askBare, type BareRequest } from "../platform/testing/bare-http.ts";

export interface SoapOptions {
  version?: SoapVersion;
  /** in the header; null: none */
  key?: string | null;
  headers?: Record<string, string>;
}

export interface SoapAnswer {
  status: number;
  type: string;
  /** in the body */
  name: string;
  /** simple fields by their names, such as `pose.x` */
  fields: Record<string, string>;
  text: string;
}

/** The body of a message: an operation with simple fields, or XML. */
export function operationXml(name: string, fields: Record<string, unknown> | string): string {
  const contents =
    typeof fields === "string"
      ? fields
      : Object.entries(fields)
          .map(([field, value]) => `<${field}>${String(value).replaceAll("<", "&lt;")}</${field}>`)
          .join("");
  return `<${name} xmlns="${NAMESPACE}">${contents}</${name}>`;
}

export function envelopeXml(body: string, version: SoapVersion = "1.1", header = ""): string {
  const { namespace } = soapVersions[version];
  return `<?xml version='1.0' encoding='utf-8'?>\n<s:Envelope xmlns:s="${namespace}">${header}<s:Body>${body}</s:Body></s:Envelope>`;
}

/** Sends a message, or bytes that are none. */
export async function postSoap(
  origin: string,
  message: string | Uint8Array<ArrayBuffer>,
  { version = "1.1", key = null, headers = {} }: SoapOptions = {},
): Promise<SoapAnswer> {
  const answer = await fetch(`${origin}/soap`, {
    method: "POST",
    headers: {
      "Content-Type": `${soapVersions[version].mediaType}; charset=utf-8`,
      ...(key !== null && { Authorization: `Bearer ${key}` }),
      ...headers,
    },
    body: message,
  });
  return readAnswer(answer.status, answer.headers.get("content-type") ?? "", await answer.text());
}

/** Calls an operation. */
export async function callSoap(
  origin: string,
  name: string,
  fields: Record<string, unknown> | string,
  options: SoapOptions = {},
): Promise<SoapAnswer> {
  const message = envelopeXml(operationXml(name, fields), options.version);
  return postSoap(origin, message, options);
}

export function readAnswer(status: number, type: string, text: string): SoapAnswer {
  const body = readXml(text).children.at(-1)?.children[0];
  if (body === undefined) throw new Error(`no body: ${text}`);
  return { status, type, name: body.name, fields: Object.fromEntries(leaves(body, "")), text };
}

/** Sends a message as raw bytes. The outcome has the status, and the code of the fault. */
export async function soapOutcome(
  origin: string,
  { headers, ...request }: Partial<BareRequest>,
): Promise<{ answer: string; says: string }> {
  const received = await askBare(origin, {
    method: "POST",
    path: "/soap",
    headers: { "Content-Type": "text/xml; charset=utf-8", ...headers },
    ...request,
  });
  const { status, text } = received;
  if (/node_modules|\.ts:\d|\/src\//.test(text)) throw new Error(`This shows internals: ${text}`);
  const { name, fields } = readAnswer(status, received.headers.get("content-type") ?? "", text);
  if (name !== "Fault") return { answer: String(status), says: text };
  const code = fields["detail.RobotFault.code"] ?? fields["Detail.RobotFault.code"];
  const says = fields["faultstring"] ?? fields["Reason.Text"] ?? "";
  return { answer: `${status} ${code ?? fields["faultcode"] ?? ""}`, says };
}

function leaves({ children }: XmlElement, path: string): [string, string][] {
  return children.flatMap((child): [string, string][] => {
    const at = path === "" ? child.name : `${path}.${child.name}`;
    return child.children.length === 0 ? [[at, child.text]] : leaves(child, at);
  });
}
