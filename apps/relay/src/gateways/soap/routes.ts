/**
 * The SOAP service, one for all robots: generated clients stay valid after a robot is deleted. Each
 * request is complete, so that any relay behind a balancer answers it.
 */
import { MAX_FRAME_BYTES, protocolClients, type RefusedError } from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import { asRefused, badRequest, Refusal } from "../../platform/errors/problems.ts";
import { methodNotAllowed, refusalOf } from "../../platform/http/fallbacks.ts";
import { onClose } from "../../platform/http/on-close.ts";
import { mediaTypeOf, textReader } from "../../platform/http/reading.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import type { RobotRegistry } from "../../robots/registry.ts";
import { RelayPort } from "../../robots/relay-port.ts";
import { authoriseGateway, requestConnection } from "../requests/gateway-requests.ts";
import { readFor } from "../requests/script-requests.ts";
import {
  EnvelopeError,
  readBody,
  soapVersions,
  versionOf,
  writeAnswer,
  writeFault,
  type SoapVersion,
} from "./envelope.ts";
import { invalidMessage } from "./invalid-message.ts";
import { faultShape, operations, type Operation } from "./operations.ts";
import { readXml, type XmlElement } from "./read-xml.ts";
import { readAddress } from "./robot-address.ts";
import { NAMESPACE, namespaceOf, readText } from "./values.ts";
import { writeWsdl } from "./wsdl.ts";

export const SOAP_PATH = "/soap";

const receive = textReader(MAX_FRAME_BYTES);

/** @param onRefused called for each refusal inside an answer */
export function soapRoutes(
  registry: RobotRegistry,
  guard: RequestGuard,
  onRefused: (error: RefusedError) => void,
): Router {
  const router = Router();
  router
    .route(SOAP_PATH)
    .get((request, response) => {
      const text = writeWsdl(wsdlVersion(request), guard.originOf(request) + SOAP_PATH);
      response.set("Cache-Control", "no-cache").type("text/xml").send(text);
    })
    .post(async (request, response) => {
      let version = versionOfType(request);
      try {
        const arrivedAt = registry.clock.now();
        const root = readXml(await readMessage(request, response));
        version = versionOf(root) ?? version;
        const ageMs = (): number => registry.clock.now() - arrivedAt;
        const answer = await answerOf(registry, readBody(root), { request, response, ageMs });
        if (answer === null) return;
        const { name, value, operation } = answer;
        send(response, version, 200, writeAnswer(version, name, value, operation.response));
      } catch (error) {
        const refused = asSoapError(error);
        onRefused(refused instanceof EnvelopeError ? asRefused(refused.refusal) : refused);
        const { status, text } = writeFault(version, refused, faultShape);
        send(response, version, status, text);
      }
    })
    .all(methodNotAllowed("GET, POST"));
  return router;
}

/** `?wsdl` or `?wsdl=1.2` @throws Refusal bad-request */
function wsdlVersion({ query }: Request): SoapVersion {
  const [name, value] = Object.entries(query)[0] ?? [];
  if (name?.toLowerCase() === "wsdl") {
    if (value === "" || value === "1.1") return "1.1";
    if (value === "1.2") return "1.2";
  }
  throw new Refusal(
    "bad-request",
    "This is the URL of a SOAP service. Read its description with ?wsdl, or with ?wsdl=1.2 for SOAP 1.2. Send messages with POST.",
  );
}

/** The version of answers to messages that cannot be read. */
function versionOfType({ headers }: Request): SoapVersion {
  const { name } = mediaTypeOf(headers["content-type"] ?? "");
  return name === soapVersions["1.2"].mediaType ? "1.2" : "1.1";
}

/** @throws Refusal bad-request; an error of Express */
async function readMessage(request: Request, response: Response): Promise<string> {
  const { "content-type": type = "", "content-encoding": encoding } = request.headers;
  const { name, isUtf8 } = mediaTypeOf(type);
  const mediaTypes = Object.values(soapVersions).map(({ mediaType }) => mediaType);
  if (!isUtf8 || !(mediaTypes as string[]).includes(name)) {
    const expected = `${mediaTypes.join(" or ")}, with charset=utf-8`;
    throw invalidMessage("Content-Type", type === "" ? "nothing" : type, expected);
  }
  if (encoding !== undefined && encoding !== "identity") {
    throw invalidMessage("Content-Encoding", encoding, "no encoding");
  }
  const text = await receive(request, response);
  if (text !== null) return text;
  const problem = { path: "", found: "bytes that are not UTF-8", expected: "XML in UTF-8" };
  throw badRequest("Invalid message.", [problem]);
}

interface Exchange {
  request: Request;
  response: Response;
  /** ms since the request arrived */
  ageMs: () => number;
}

/** @returns null if the client has disconnected */
async function answerOf(
  registry: RobotRegistry,
  source: XmlElement,
  { request, response, ageMs }: Exchange,
): Promise<{ name: string; value: object; operation: Operation } | null> {
  const operation = operationOf(source);
  const { verb } = operation;
  const { id, key } = readAddress(readText(source, "robot"));
  const claim = { id, key, use: undefined, verb, client: protocolClients.soap };
  const grant = await authoriseGateway(registry, request, response, claim);
  const run = await readFor(grant, () => operation.read(source));
  if (response.closed) return null;
  const port = new RelayPort(grant, requestConnection);
  onClose(response, () => port.close());
  const value = await run({ grant, port, response, ageMs });
  return { name: `${source.name}Response`, value, operation };
}

/** @throws Refusal bad-request */
function operationOf(source: XmlElement): Operation {
  const { name, namespace } = source;
  const path = `Envelope.Body.${name}`;
  if (namespace !== NAMESPACE) {
    throw invalidMessage(path, namespaceOf(source), `the namespace ${NAMESPACE}`);
  }
  const operation = Object.hasOwn(operations, name) ? operations[name] : undefined;
  if (operation !== undefined) return operation;
  throw invalidMessage(
    path,
    "an unknown operation",
    `one of ${Object.keys(operations).join(", ")}`,
  );
}

function asSoapError(error: unknown): RefusedError | EnvelopeError {
  return error instanceof EnvelopeError ? error : asRefused(error, refusalOf(error));
}

function send(response: Response, version: SoapVersion, status: number, text: string): void {
  if (response.closed) return;
  response
    .status(status)
    .set("Cache-Control", "no-store")
    .type(soapVersions[version].mediaType)
    .send(text);
}
