/** Faults for SOAP clients that send invalid messages. */
import { gzipSync } from "node:zlib";
import type { Registration } from "@corridor/protocol";
import { expect, it } from "vitest";
import { testEndpoints } from "../../testing/bad-input.cases.ts";
import { Bystander } from "../../testing/bystander.ts";
import { requesting, type Attempt, type Target } from "../../testing/endpoints.ts";
import { envelopeXml, operationXml, soapOutcome } from "../../testing/soap-client.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import type { BareRequest } from "../../platform/testing/bare-http.ts";

const LIMIT = 16 * 1024;

const command = ({ address }: Registration, fields: string): string =>
  envelopeXml(operationXml("Command", `<robot>${address}</robot>${fields}`));
const move = (distance: string): string => `<action>move</action><distance>${distance}</distance>`;

const sending =
  (request: (target: Target) => Partial<BareRequest>): Attempt =>
  async (target) =>
    soapOutcome(target.relay.origin, request(target));
const moving = (distance: string): Attempt =>
  sending(({ robot }) => ({ body: command(robot, move(distance)) }));

testEndpoints({
  "a call of a SOAP client": {
    attempts: {
      "too large": sending(({ robot }) => ({
        body: command(robot, move("40")).padEnd(LIMIT + 1),
      })),
      deep: sending(() => ({ body: envelopeXml("<a>".repeat(256) + "</a>".repeat(256)) })),
      "prototype keys": sending(({ robot }) => ({
        body: command(robot, `${move("40")}<__proto__>1</__proto__>`),
      })),
      NaN: moving("NaN"),
      Infinity: moving("INF"),
      "2^53 + 1": moving("9007199254740993"),
      "1e308": moving("1e308"),
      "wrong UTF-8": sending(({ robot }) => ({
        body: Buffer.from(command(robot, `<action>für</action>`), "latin1"),
      })),
      "wrong order": sending(() => ({ body: envelopeXml("") })),
      // The request is refused before a gateway receives it.
      "half-closed": requesting(
        ({ robot }) => ({
          method: "POST",
          path: "/soap",
          headers: { "Content-Type": "text/xml" },
          body: command(robot, move("40")),
          isCutOff: true,
        }),
        "",
      ),
      "a key of another robot": sending(({ robot, other }) => ({
        body: command(robot, move("40")),
        headers: { Authorization: `Bearer ${other.driverKey}` },
      })),
    },
    answers: {
      "too large": "500 too-large | 16 KiB",
      deep: "500 bad-request | found a deeper element, expected at most 16 levels",
      "prototype keys": "500 bad-request | __proto__: found an unknown element, expected one of",
      NaN: "500 bad-request | distance: found 'NaN', expected a distance in cm",
      Infinity: "500 bad-request | distance: found 'INF', expected a distance in cm",
      "2^53 + 1": "500 bad-request | distance: found 9007199254740992",
      "1e308": "500 bad-request | distance: found 1e+308",
      "wrong UTF-8": "500 bad-request | found bytes that are not UTF-8, expected XML in UTF-8",
      "wrong order": "500 bad-request | Envelope.Body: found no element, expected one operation",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "500 not-authorised | after the #",
    },
  },
});

const ENTITIES = `<!DOCTYPE laugh [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>`;
const EXTERNAL = `<!DOCTYPE x [<!ENTITY f SYSTEM "file:///etc/passwd">]>`;

/** A message made of a valid one, and the sentence of its fault. */
const messages: {
  name: string;
  /** changes the valid message */
  change: (message: string) => string | Uint8Array;
  says: string;
  headers?: Record<string, string>;
}[] = [
  { name: "nothing", change: () => "", says: "found text that is not XML" },
  { name: "JSON", change: () => '{"action":"stop"}', says: "text data outside of root node" },
  {
    name: "a message that is cut off",
    change: (message) => message.slice(0, -20),
    says: "expected well-formed XML",
  },
  {
    name: "two roots",
    change: (message) => `${message}<more/>`,
    says: "documents may contain only one root",
  },
  {
    name: "a document type",
    change: (message) => message.replace("\n", "<!DOCTYPE a>"),
    says: "line 1: found a document type (DOCTYPE), expected none",
  },
  {
    name: "an entity bomb",
    change: (message) => message.replace("\n", ENTITIES).replace(">40<", ">&b;<"),
    says: "found a document type",
  },
  {
    name: "an external entity",
    change: (message) => message.replace("\n", EXTERNAL).replace(">40<", ">&f;<"),
    says: "found a document type",
  },
  {
    name: "an undefined entity",
    change: (message) => message.replace(">40<", ">&nbsp;<"),
    says: "line 2 > Envelope > Body > Command > distance: found text that is not XML (undefined entity.)",
  },
  {
    name: "a processing instruction",
    change: (message) => message.replace("\n", "<?php echo 1 ?>"),
    says: "found a processing instruction, expected none",
  },
  {
    name: "a control character",
    change: (message) => message.replace(">40<", ">\u0001<"),
    says: "disallowed character",
  },
  {
    name: "XML 1.1",
    change: (message) => message.replace("'1.0'", "'1.1'"),
    says: "found XML 1.1, expected XML 1.0",
  },
  {
    name: "another encoding",
    change: (message) => message.replace("utf-8", "iso-8859-1"),
    says: "found the encoding iso-8859-1, expected UTF-8",
  },
  {
    name: "UTF-16",
    change: (message) => Buffer.from(`\uFEFF${message}`, "utf16le"),
    says: "found bytes that are not UTF-8",
  },
  {
    name: "a prefix without a namespace",
    change: (message) => message.replaceAll("distance>", "x:distance>"),
    says: "unbound namespace prefix",
  },
  {
    name: "another root",
    change: (message) => message.replaceAll("s:Envelope", "s:Letter"),
    says: "Letter: found an unknown element, expected the element Envelope",
  },
  {
    name: "no body",
    change: (message) => message.replace(/<s:Body>.*<\/s:Body>/, ""),
    says: "Envelope.Body: found nothing, expected the element Body",
  },
  {
    name: "an element after the body",
    change: (message) => message.replace("</s:Body>", "</s:Body><more/>"),
    says: "Envelope.more: found an unknown element, expected nothing after Body",
  },
  {
    name: "two operations",
    change: (message) => message.replace("</s:Body>", "<more/></s:Body>"),
    says: "Envelope.Body: found a second element, expected one operation",
  },
  {
    name: "text in the body",
    change: (message) => message.replace("<s:Body>", "<s:Body>drive"),
    says: "Envelope.Body: found text between elements",
  },
  {
    name: "an unknown operation",
    change: (message) => message.replaceAll("Command", "toString"),
    says: "Envelope.Body.toString: found an unknown operation, expected one of Sense, Command",
  },
  {
    name: "another namespace",
    change: (message) => message.replace("robot:1", "robot:2"),
    says: "found the namespace urn:corridor:robot:2, expected the namespace urn:corridor:robot:1",
  },
  {
    name: "no namespace",
    change: (message) => message.replace(/ xmlns="[^"]*"/, ""),
    says: "Envelope.Body.Command: found no namespace",
  },
  {
    name: "an inner element without the namespace",
    change: (message) => message.replace("<distance>", '<distance xmlns="">'),
    says: "distance: found no namespace, expected the namespace urn:corridor:robot:1",
  },
  {
    name: "no robot",
    change: (message) => message.replace(/<robot>.*<\/robot>/, ""),
    says: "robot: found nothing, expected the address of a robot",
  },
  {
    name: "an unknown element",
    change: (message) => message.replaceAll("distance", "dist"),
    says: "dist: found an unknown element, expected one of robot, action, distance",
  },
  {
    name: "a repeated element",
    change: (message) => message.replace("<action>", "<action>stop</action><action>"),
    says: "action: found a second element of this name, expected it once",
  },
  {
    name: "text between elements",
    change: (message) => message.replace("<action>", "now<action>"),
    says: "Command: found text between elements, expected elements only",
  },
  {
    name: "an element in a text",
    change: (message) => message.replace(">40<", "><cm>40</cm><"),
    says: "distance.cm: found an element, expected the text of distance only",
  },
  {
    name: "an attribute",
    change: (message) => message.replace("<distance>", '<distance unit="m">'),
    says: "distance: found the attribute unit, expected no attributes",
  },
  {
    name: "a nil element",
    change: (message) =>
      message.replace(
        /<distance>40/,
        '<distance xmlns:i="http://www.w3.org/2001/XMLSchema-instance" i:nil="true">',
      ),
    says: "distance: found the attribute nil, expected no element where there is no value",
  },
  {
    name: "a field of another action",
    change: (message) => message.replace("move", "stop"),
    says: "distance: found 40, expected no field of this name",
  },
  {
    name: "a condition with an unknown sensor",
    change: (message) =>
      message.replace(
        /<action>.*<\/distance>/,
        "<action>forward</action><until><sensor>nose</sensor><is>></is><than>1</than></until>",
      ),
    says: "until[0].sensor: found 'nose', expected one of front, right, back, left",
  },
  {
    name: "an unknown element in a condition",
    change: (message) =>
      message.replace(/<action>.*<\/distance>/, "<until/><until><end>1</end></until>"),
    says: "until[1].end: found an unknown element",
  },
  {
    name: "a wait that is too long",
    change: (message) => message.replace("</distance>", "</distance><wait>26</wait>"),
    says: "wait: found 26, expected seconds to wait, from 0 to 25",
  },
  {
    name: "a name of 10 KB",
    change: (message) => message.replaceAll("distance", "x".repeat(10_000 / 2)),
    says: `${"x".repeat(160)}…: found an unknown element`,
  },
  {
    name: "another type of content",
    change: (message) => message,
    headers: { "Content-Type": "application/json" },
    says: "Content-Type: found application/json, expected text/xml or application/soap+xml",
  },
  {
    name: "another charset",
    change: (message) => message,
    headers: { "Content-Type": "text/xml; charset=utf-16" },
    says: "Content-Type: found text/xml; charset=utf-16",
  },
  {
    name: "a compressed message",
    change: (message) => gzipSync(message),
    headers: { "Content-Encoding": "gzip" },
    says: "Content-Encoding: found gzip, expected no encoding",
  },
];

it("refuses messages that do not match the WSDL, with one sentence each", async () => {
  const relay = await startTestRelay();
  const bystander = await Bystander.at(relay);
  const robot = await relay.register();
  for (const { name, change, says, headers = {} } of messages) {
    const body = change(command(robot, move("40")));
    const outcome = await soapOutcome(relay.origin, { body, headers });
    expect({ name, ...outcome }).toEqual({
      name,
      answer: "500 bad-request",
      says: expect.stringContaining(says),
    });
    expect(outcome.says).toMatch(/^Invalid (?:message|command)\. \S.*: found .+, expected .+\.$/s);
  }
  await bystander.drives();
  // None of them was a command.
  const log = await relay.ask(robot, "/commands");
  expect(await log.json()).toEqual({ commands: [] });
});

it("reads comments, CDATA sections, references of characters and prefixes", async () => {
  const relay = await startTestRelay();
  const robot = await relay.register();
  const body = command(robot, "<!-- now --><action><![CDATA[le]]>ft<!-- x -->&#32;9&#x30;</action>")
    .replaceAll(/<(\/?)(Command|robot|action)\b/g, "<$1c:$2")
    .replace("xmlns=", "xmlns:c=");
  expect(await soapOutcome(relay.origin, { body: `\uFEFF${body}` })).toMatchObject({
    answer: "200",
    says: expect.stringContaining("<action>left 90</action>"),
  });
});
