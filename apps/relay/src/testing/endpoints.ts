/** Invalid input of every kind, as each endpoint of a relay receives it, and the outcome. */
import { problemSchema, type Registration } from "@corridor/protocol";
import { askBare, type BareAnswer, type BareRequest } from "../platform/testing/bare-http.ts";
import type { TestRelay } from "./test-relay.ts";
import { TestSocket } from "./test-socket.ts";

export const badInputs = [
  "too large",
  "deep",
  "prototype keys",
  "NaN",
  "Infinity",
  "2^53 + 1",
  "1e308",
  "wrong UTF-8",
  "wrong order",
  "half-closed",
  "a key of another robot",
] as const;
export type BadInput = (typeof badInputs)[number];

export interface Target {
  relay: TestRelay;
  robot: Registration;
  /** the robot of another owner */
  other: Registration;
}

/** A status with the kind of its problem, or a close code, and the accompanying text. */
export interface Outcome {
  answer: string;
  says: string;
}

export type Attempt = (target: Target) => Promise<Outcome>;

type Request = BareRequest | Promise<BareRequest>;

/**
 * Corrupts the JSON text of a valid message in every way that does not depend on the endpoint.
 * @param right contains 40 as its number
 * @param limit of the endpoint, in bytes
 */
export function badTexts(right: string, limit: number): [BadInput, string | Uint8Array][] {
  const depth = Math.min(8_000, limit / 2);
  const number = (text: string): string => right.replace("40", text);
  // Non-UTF-8 text goes into the name, or into an extra field if there is no name.
  const name = right.includes("First") ? right.replace("First", "Für") : right;
  const german = name === right ? right.replace("{", '{"für":1,') : name;
  return [
    ["too large", " ".repeat(limit) + right],
    ["deep", "[".repeat(depth) + "]".repeat(depth)],
    ["prototype keys", right.replace("{", '{"__proto__":{"isOwner":true},')],
    ["NaN", number("NaN")],
    ["Infinity", number("1e999")],
    ["2^53 + 1", number("9007199254740993")],
    ["1e308", number("1e308")],
    ["wrong UTF-8", Buffer.from(german, "latin1")],
  ];
}

// --- by HTTP ---

/** Sends one request below a path, with the driver key unless it has another. */
export function requesting(request: (target: Target) => Request, base = "/api/v1"): Attempt {
  return async (target) => {
    const { path, headers, ...rest } = await request(target);
    const answer = await askBare(target.relay.origin, {
      ...rest,
      path: base + path,
      headers: { Authorization: `Bearer ${target.robot.driverKey}`, ...headers },
    });
    return outcomeOf(answer);
  };
}

/** Sends a request that reads from the robot. */
export function reading(path: string, headers: Record<string, string> = {}): Attempt {
  return requesting(({ robot }) => ({ path: `/robots/${robot.id}${path}`, headers }));
}

/** Attempts for an endpoint that accepts JSON in the body of a POST. */
export function bodies(
  right: string,
  limit: number,
  request: (target: Target) => Request,
  base?: string,
): Partial<Record<BadInput, Attempt>> {
  const posting = (more: Partial<BareRequest>): Attempt =>
    requesting(async (target) => ({ method: "POST", ...(await request(target)), ...more }), base);
  return {
    ...Object.fromEntries(badTexts(right, limit).map(([bad, body]) => [bad, posting({ body })])),
    "half-closed": posting({ body: right, isCutOff: true }),
  };
}

/** Outcome of a response. An error must be a problem document with a sentence and no internals. */
export function outcomeOf({ status, headers, text }: BareAnswer): Outcome {
  if (/node_modules|\.ts:\d|\/src\//.test(text)) throw new Error(`This shows internals: ${text}`);
  if (status >= 200 && status < 400) return { answer: String(status), says: text };
  const type = headers.get("content-type") ?? "none";
  if (!type.startsWith("application/problem+json")) throw new Error(`${status} came with ${type}`);
  const problem = problemSchema.parse(JSON.parse(text));
  if (problem.status !== status) throw new Error(`${status} came with ${problem.status}`);
  return { answer: `${status} ${kindOf(problem.type)}`, says: text };
}

// --- by WebSocket ---

/** Opens a long-poll connection of a script. Returns the request that posts its messages. */
export async function openedConnection(
  { relay }: Target,
  robot: Registration,
): Promise<BareRequest> {
  const hello = { type: "hello", version: 1, role: "drive", key: robot.driverKey };
  const opened = await relay.ask(robot, "/long-poll", { method: "POST", body: hello });
  const { key } = (await opened.json()) as { key: string };
  return {
    method: "POST",
    path: `/robots/${robot.id}/long-poll/messages`,
    headers: { Authorization: `Bearer ${key}` },
  };
}

/** Opens a WebSocket with this first message. */
export function greeting(first: (target: Target) => object): Attempt {
  return async (target) => {
    const socket = await TestSocket.open(target.relay, target.robot.id);
    socket.send(first(target));
    return closeOutcome(socket);
  };
}

/** Attempts for a WebSocket of a page or a script, both authenticated first. */
export function messages(by: "page" | "script", right: object): Partial<Record<BadInput, Attempt>> {
  const texts = badTexts(JSON.stringify(right), 16 * 1024);
  const entries = texts.map(([bad, bytes]): [BadInput, Attempt] => [
    bad,
    sending(by, (socket) => socket.sendText(Buffer.from(bytes))),
  ]);
  return Object.fromEntries(entries);
}

export function sending(by: "page" | "script", act: (socket: TestSocket) => void): Attempt {
  return async ({ relay, robot }) => {
    const socket =
      by === "page"
        ? (await TestSocket.page(relay, robot)).socket
        : await TestSocket.driver(relay, robot);
    act(socket);
    return (await problemOutcome(socket)) ?? closeOutcome(socket);
  };
}

/** null if the socket was closed instead */
async function problemOutcome(socket: TestSocket): Promise<Outcome | null> {
  const message = await socket.next("problem").catch(() => null);
  if (message === null) return null;
  const problem = problemSchema.parse(message["problem"]);
  return {
    answer: `${problem.status} ${kindOf(problem.type)}`,
    says: JSON.stringify(problem),
  };
}

async function closeOutcome(socket: TestSocket): Promise<Outcome> {
  const { code, reason } = await socket.closed;
  return { answer: String(code), says: reason };
}

function kindOf(type: string): string {
  return type.slice("/problems/".length);
}
