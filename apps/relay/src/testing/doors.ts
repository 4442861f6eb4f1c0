/** Bad input of every kind, as it is brought to each door of a relay, and what is answered there. */
import { problemSchema, type Registration } from "@corridor/protocol";
import { askBare, type BareAnswer, type BareRequest } from "./bare-http.ts";
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

export interface Place {
  relay: TestRelay;
  robot: Registration;
  /** somebody else's */
  other: Registration;
}

/** A status and the kind of its problem, or a close code; and the words that come with it. */
export interface Told {
  answer: string;
  says: string;
}

export type Knock = (place: Place) => Promise<Told>;

type Request = BareRequest | Promise<BareRequest>;

/**
 * The JSON text of a right message, made bad in each way that is no matter of the door.
 * @param right with 40 where its number is
 * @param limit of the door, in bytes
 */
function badTexts(right: string, limit: number): [BadInput, string | Uint8Array][] {
  const depth = Math.min(8_000, limit / 2);
  const number = (text: string): string => right.replace("40", text);
  // Where there is no name, as a field; and in the letters of another time.
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

/** One request below /api/v1, with the driver's key unless it has another. */
export function asking(request: (place: Place) => Request): Knock {
  return async (place) => {
    const { path, headers, ...rest } = await request(place);
    const answer = await askBare(place.relay.origin, {
      ...rest,
      path: `/api/v1${path}`,
      headers: { Authorization: `Bearer ${place.robot.driverKey}`, ...headers },
    });
    return toldBy(answer);
  };
}

/** A request to read something of the robot. */
export function reading(path: string, headers: Record<string, string> = {}): Knock {
  return asking(({ robot }) => ({ path: `/robots/${robot.id}${path}`, headers }));
}

/** A door that takes JSON in the body of a POST. */
export function bodies(
  right: string,
  limit: number,
  request: (place: Place) => Request,
): Partial<Record<BadInput, Knock>> {
  const posting = (more: Partial<BareRequest>): Knock =>
    asking(async (place) => ({ method: "POST", ...(await request(place)), ...more }));
  return {
    ...Object.fromEntries(badTexts(right, limit).map(([bad, body]) => [bad, posting({ body })])),
    "half-closed": posting({ body: right, isCutOff: true }),
  };
}

/** What an answer tells; a refusal must be a problem document with a sentence, and show nothing of the inside. */
export function toldBy({ status, headers, text }: BareAnswer): Told {
  if (/node_modules|\.ts:\d|\/src\//.test(text)) throw new Error(`This shows internals: ${text}`);
  if (status >= 200 && status < 400) return { answer: String(status), says: text };
  const type = headers.get("content-type") ?? "none";
  if (!type.startsWith("application/problem+json")) throw new Error(`${status} came with ${type}`);
  const problem = problemSchema.parse(JSON.parse(text));
  if (problem.status !== status) throw new Error(`${status} came with ${problem.status}`);
  return { answer: `${status} ${kindOf(problem.type)}`, says: text };
}

// --- by WebSocket ---

/** A script's line opened by HTTPS, as the request that sends its messages. */
export async function openedLine({ relay }: Place, robot: Registration): Promise<BareRequest> {
  const hello = { type: "hello", version: 1, role: "drive", key: robot.driverKey };
  const opened = await relay.ask(robot, "/line", { method: "POST", body: hello });
  const { line } = (await opened.json()) as { line: string };
  return {
    method: "POST",
    path: `/robots/${robot.id}/line/messages`,
    headers: { Authorization: `Bearer ${line}` },
  };
}

/** A WebSocket that begins with this. */
export function greeting(first: (place: Place) => object): Knock {
  return async (place) => {
    const socket = await TestSocket.open(place.relay, place.robot.id);
    socket.send(first(place));
    return toldAtEnd(socket);
  };
}

/** A WebSocket of the robot's page or of a script, both welcome before they send what is bad. */
export function messages(by: "page" | "script", right: object): Partial<Record<BadInput, Knock>> {
  const texts = badTexts(JSON.stringify(right), 16 * 1024);
  const entries = texts.map(([bad, bytes]): [BadInput, Knock] => [
    bad,
    bringing(by, (socket) => socket.sendText(Buffer.from(bytes))),
  ]);
  return Object.fromEntries(entries);
}

export function bringing(by: "page" | "script", bring: (socket: TestSocket) => void): Knock {
  return async ({ relay, robot }) => {
    const socket =
      by === "page"
        ? (await TestSocket.page(relay, robot)).socket
        : await TestSocket.driver(relay, robot);
    bring(socket);
    return (await toldInProblem(socket)) ?? toldAtEnd(socket);
  };
}

/** null when the socket was closed instead */
async function toldInProblem(socket: TestSocket): Promise<Told | null> {
  const message = await socket.next("problem").catch(() => null);
  if (message === null) return null;
  const problem = problemSchema.parse(message["problem"]);
  return {
    answer: `${problem.status} ${kindOf(problem.type)}`,
    says: JSON.stringify(problem),
  };
}

async function toldAtEnd(socket: TestSocket): Promise<Told> {
  const { code, reason } = await socket.closed;
  return { answer: String(code), says: reason };
}

function kindOf(type: string): string {
  return type.slice("/problems/".length);
}
