import {
  pairingAnswerSchema,
  requestedPairingSchema,
  pairingRequestSchema,
  problemSchema,
  readJson,
  readValue,
  isTemporary,
} from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import { Backoff } from "./backoff.ts";
import type { HttpRequest, HttpResponse, Platform } from "./platform.ts";
import { retryDelay } from "./retry-delay.ts";

const MAX_RESPONSE = 4_096;
/** Wait of a long poll. Short enough for proxies that close idle connections. */
const WAIT_SECONDS = 10;
/** Request timeout, in addition to the wait. */
const GRACE_MS = 10_000;
/** The service may delay the check of a code after many wrong codes from the same network. */
const CHECK_MS = 10_000;
/** Maximum number of wrong codes per page load or process. */
const MAX_WRONG_CODES = 10;

/** The wrong codes of this page load or process. */
const ownAttempts = { wrong: 0 };

export interface PairingRequest {
  /** origin of the robot's page, such as http://HOST */
  service: string;
  code: string;
  name: string | null;
}

/**
 * Requests access by a pairing code of 8 letters, and waits until the robot's owner accepts.
 * @param timeoutMs until a request is given up
 * @returns the robot's address
 * @throws ClientError bad-address, wrong-code, pairing-refused, pairing-over, too-many-tries or
 * timeout
 */
export async function pairRobot(
  platform: Platform,
  { service, code, name }: PairingRequest,
  timeoutMs: number,
  attempts: { wrong: number } = ownAttempts,
): Promise<string> {
  const url = `${originOf(service)}/api/v1/pairing`;
  if (attempts.wrong >= MAX_WRONG_CODES) {
    throw new ClientError(
      "too-many-tries",
      `${MAX_WRONG_CODES} wrong codes were entered`,
      "Check the code on the robot's page, and start the script again.",
    );
  }
  try {
    const input = readValue(pairingRequestSchema, { code, name });
    if (!input.ok) throw wrongCode("A code has 8 letters, such as BCDF GHJK, and no vowels.");
    const body = JSON.stringify(input.value);
    const request = { method: "POST", url, key: null, body };
    const response = await send(platform, request, CHECK_MS + GRACE_MS, timeoutMs);
    const requested = read(requestedPairingSchema, response, "wrong-code");
    return await untilAccepted(platform, url, requested, timeoutMs);
  } catch (error) {
    if (error instanceof ClientError && error.code === "wrong-code") attempts.wrong += 1;
    throw error;
  }
}

async function untilAccepted(
  platform: Platform,
  url: string,
  { key, endsInSeconds }: { key: string; endsInSeconds: number },
  timeoutMs: number,
): Promise<string> {
  const { clock } = platform;
  const end = clock.now() + endsInSeconds * 1000;
  const request = { method: "GET", url: `${url}?wait=${WAIT_SECONDS}`, key, body: null };
  for (;;) {
    const response = await send(platform, request, WAIT_SECONDS * 1000 + GRACE_MS, timeoutMs);
    const { address } = read(pairingAnswerSchema, response, "pairing-over");
    if (address !== null) return address;
    if (clock.now() < end) continue;
    throw new ClientError(
      "pairing-over",
      "The owner did not answer",
      "Create a new code on the robot's page, and accept this script there.",
    );
  }
}

/** Sends a request, and repeats it after temporary failures. */
async function send(
  platform: Platform,
  request: HttpRequest,
  requestMs: number,
  timeoutMs: number,
): Promise<HttpResponse> {
  const { clock } = platform;
  const start = clock.now();
  const backoff = new Backoff();
  for (;;) {
    const response = await sendOnce(platform, request, requestMs);
    if (response !== null && !isTemporary(response)) return response;
    const wait = retryDelay(response, backoff.next(clock.now(), platform.random()));
    if (clock.now() - start + wait > timeoutMs) {
      if (response?.status === 429) return response;
      throw new ClientError(
        "timeout",
        "The service does not respond",
        "Check the network and the address of the page.",
      );
    }
    await new Promise<void>((resolve) => clock.after(wait, resolve));
  }
}

/** @returns null if there is no response */
async function sendOnce(
  { request: sendRequest, clock }: Platform,
  request: HttpRequest,
  requestMs: number,
) {
  if (sendRequest === undefined) return null;
  const pending = sendRequest(request);
  const cancelTimer = clock.after(requestMs, () => pending.cancel());
  try {
    return await pending.response;
  } catch {
    return null;
  } finally {
    cancelTimer();
  }
}

/** @param unknown the error if there is no such code */
function read<T>(
  schema: Parameters<typeof readJson<T>>[0],
  { status, body }: HttpResponse,
  unknown: "wrong-code" | "pairing-over",
): T {
  const value = readJson(schema, body, MAX_RESPONSE);
  if (status < 300 && value.ok) return value.value;
  const problem = readJson(problemSchema, body, MAX_RESPONSE);
  if (status < 400 || !problem.ok) {
    throw new ClientError(
      "bad-address",
      "The response does not come from a Corridor service",
      "Copy the address of the robot's page. If the network has a sign-in page, sign in first.",
    );
  }
  const { type, detail } = problem.value;
  if (type === "/problems/pairing-refused") {
    throw new ClientError("pairing-refused", "The robot's owner declined", detail);
  }
  if (type === "/problems/too-fast") {
    throw new ClientError("too-many-tries", "Too many codes were sent from this network", detail);
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
    "It looks like http://HOST. Copy it from the browser in which the robot's page is open.",
  );
}
