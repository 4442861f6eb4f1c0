/**
 * Pairing: a code of 8 letters, typed by hand, in place of a robot's address. The robot's page shows it, and its
 * owner says yes or no to the script that asks by it.
 */
import {
  pairingAnswerSchema,
  requestedPairingSchema,
  pairingRequestSchema,
  problemSchema,
  readJson,
  readValue,
} from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import type { HttpRequest, Platform } from "./platform.ts";

const MAX_ANSWER = 4_096;
/** One long poll. Short enough for filters that cut silent lines. */
const WAIT_SECONDS = 10;
/** Beyond the wait that was asked for, the line counts as lost. */
const GRACE_MS = 10_000;
/** Beside many wrong codes of the same network, the service checks a code after so long at most. */
const CHECK_MS = 10_000;
/** The service asks for as much when too many codes of the network wait. */
const TOO_FAST_PAUSE_MS = 1_000;
const FIRST_PAUSE_MS = 250;
const MAX_PAUSE_MS = 10_000;
/** Wrong codes of one page load or run: whoever types wrong so often has another problem than a slip. */
const MAX_WRONG_CODES = 10;

/** Those of this page load or run. */
const ownTries = { wrong: 0 };

export interface PairingRequest {
  /** where the robot's page is, such as http://HOST */
  service: string;
  code: string;
  name: string | null;
}

type Answer = { status: number; body: string };

/**
 * Asks by a code, and waits for the owner's yes.
 * @param answerMs for how long the service may be silent
 * @returns the robot's address
 * @throws ClientError bad-address, wrong-code, pairing-refused, pairing-over, too-many-tries or timeout
 */
export async function pairRobot(
  platform: Platform,
  { service, code, name }: PairingRequest,
  answerMs: number,
  tries: { wrong: number } = ownTries,
): Promise<string> {
  const url = `${originOf(service)}/api/v1/pairing`;
  if (tries.wrong >= MAX_WRONG_CODES) {
    throw new ClientError(
      "too-many-tries",
      `${MAX_WRONG_CODES} wrong codes were typed`,
      "Look at the code on the robot's page, and start the script again.",
    );
  }
  try {
    const wish = readValue(pairingRequestSchema, { code, name });
    if (!wish.ok) throw wrongCode("It has 8 letters, such as BCDF GHJK, and no vowel.");
    const body = JSON.stringify(wish.value);
    const asking = { method: "POST", url, key: null, body };
    const answer = await answerTo(platform, asking, CHECK_MS + GRACE_MS, answerMs);
    const asked = read(requestedPairingSchema, answer, "wrong-code");
    return await untilYes(platform, url, asked, answerMs);
  } catch (error) {
    if (error instanceof ClientError && error.code === "wrong-code") tries.wrong += 1;
    throw error;
  }
}

async function untilYes(
  platform: Platform,
  url: string,
  { key, endsInSeconds }: { key: string; endsInSeconds: number },
  answerMs: number,
): Promise<string> {
  const { clock } = platform;
  const end = clock.now() + endsInSeconds * 1000;
  const waiting = { method: "GET", url: `${url}?wait=${WAIT_SECONDS}`, key, body: null };
  for (;;) {
    const answer = await answerTo(platform, waiting, WAIT_SECONDS * 1000 + GRACE_MS, answerMs);
    const { address } = read(pairingAnswerSchema, answer, "pairing-over");
    if (address !== null) return address;
    if (clock.now() < end) continue;
    throw new ClientError(
      "pairing-over",
      "Nobody has answered",
      "Make a new code in the robot's page, and watch for the question there.",
    );
  }
}

/** The answer to a request, which is made again while the network or the service has a bad moment. */
async function answerTo(
  platform: Platform,
  request: HttpRequest,
  connectionMs: number,
  answerMs: number,
): Promise<Answer> {
  const { clock } = platform;
  const began = clock.now();
  for (let pauseMs = FIRST_PAUSE_MS; ; pauseMs = Math.min(MAX_PAUSE_MS, pauseMs * 2)) {
    const answer = await once(platform, request, connectionMs);
    const isTooFast = answer?.status === 429;
    if (answer !== null && answer.status < 500 && !isTooFast) return answer;
    const wait = platform.random() * pauseMs + (isTooFast ? TOO_FAST_PAUSE_MS : 0);
    if (clock.now() - began + wait > answerMs) {
      if (isTooFast) return answer;
      throw new ClientError(
        "timeout",
        "The service does not answer",
        "Check that it runs, that the address is right and that this computer has a network.",
      );
    }
    await new Promise<void>((resolve) => clock.after(wait, resolve));
  }
}

/** @returns null when no answer came */
async function once({ ask, clock }: Platform, request: HttpRequest, connectionMs: number) {
  if (ask === undefined) return null;
  const asking = ask(request);
  const cancelTimer = clock.after(connectionMs, () => asking.cancel());
  try {
    return await asking.answer;
  } catch {
    return null;
  } finally {
    cancelTimer();
  }
}

/** @param unknown what it means here that no such code counts */
function read<T>(
  schema: Parameters<typeof readJson<T>>[0],
  { status, body }: Answer,
  unknown: "wrong-code" | "pairing-over",
): T {
  const value = readJson(schema, body, MAX_ANSWER);
  if (status < 300 && value.ok) return value.value;
  const problem = readJson(problemSchema, body, MAX_ANSWER);
  if (status < 400 || !problem.ok) {
    throw new ClientError(
      "bad-address",
      "Something else than Corridor's service answers",
      "Copy the address of the robot's page; a network with a sign-in page wants that done first.",
    );
  }
  const { type, detail } = problem.value;
  if (type === "/problems/pairing-refused") {
    throw new ClientError("pairing-refused", "The robot's owner declined", detail);
  }
  if (type === "/problems/too-fast") {
    throw new ClientError("too-many-tries", "Too many codes come from this network", detail);
  }
  if (type === "/problems/no-pairing" && unknown === "pairing-over") {
    throw new ClientError("pairing-over", "The pairing code is no longer valid", detail);
  }
  if (type === "/problems/no-pairing" || type === "/problems/code-used") throw wrongCode(detail);
  throw new ClientError("refused", problem.value.title, detail);
}

function wrongCode(hint: string): ClientError {
  return new ClientError("wrong-code", "Unknown, expired or used pairing code", hint);
}

function originOf(service: string): string {
  const origin = /^https?:\/\/[^/?#\s@]+/.exec(service.trim().slice(0, 400))?.[0];
  if (origin !== undefined) return origin;
  throw new ClientError(
    "bad-address",
    "This is not the address of a service",
    "It looks like http://HOST: what the browser shows where the robot's page is open.",
  );
}
