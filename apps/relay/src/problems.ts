/**
 * Everything that the relay refuses, as problem documents (RFC 9457). The same document answers an
 * HTTP request and a WebSocket message, and it never tells more than the client may know.
 */
import type { FieldProblem, ProblemDocument } from "@corridor/protocol";
import { isDiskFull } from "./store/disk-full.ts";
import { StoreAway } from "./store/store-away.ts";

interface Kind {
  status: number;
  title: string;
}

/** Every kind of problem by the last part of its `type`, with its HTTP status. */
export const problemKinds = {
  "bad-request": { status: 400, title: "The request cannot be read" },
  "not-authorised": { status: 401, title: "A valid key is missing" },
  forbidden: { status: 403, title: "This key does not allow that" },
  "sent-away": { status: 403, title: "This script was sent away" },
  "pairing-refused": { status: 403, title: "The robot's owner said no" },
  "not-found": { status: 404, title: "There is nothing here" },
  "no-robot": { status: 404, title: "There is no such robot" },
  "no-line": { status: 404, title: "This line is closed" },
  "no-document": { status: 404, title: "There is no such short link" },
  "no-key": { status: 404, title: "There is no such key" },
  "no-pairing": { status: 404, title: "This pairing code does not count" },
  "no-script": { status: 404, title: "There is no such script" },
  "no-maze": { status: 404, title: "The robot's maze is not known" },
  "no-command": { status: 404, title: "There is no such command" },
  "method-not-allowed": { status: 405, title: "This address does not know the method" },
  "too-slow": { status: 408, title: "The request took too long" },
  "key-conflict": { status: 409, title: "The idempotency key was used for another command" },
  "code-used": { status: 409, title: "This pairing code was used" },
  "driving-paused": { status: 409, title: "Remote driving is paused" },
  "no-snapshot": { status: 409, title: "The robot has not reported yet" },
  "nothing-to-replace": { status: 409, title: "The key to replace is not there" },
  "too-many-keys": { status: 409, title: "The robot has too many keys" },
  "too-many-away": { status: 409, title: "Too many scripts are away" },
  "too-large": { status: 413, title: "The body is too large" },
  "not-json": { status: 415, title: "The body is not JSON" },
  "wrong-host": { status: 421, title: "This service has another name" },
  "too-late": { status: 422, title: "The command came too late" },
  "queue-full": { status: 429, title: "Too many commands wait" },
  "too-fast": { status: 429, title: "Too many requests" },
  "too-many-readers": { status: 429, title: "Too many connections" },
  "headers-too-large": { status: 431, title: "The headers are too large" },
  internal: { status: 500, title: "The relay made a mistake" },
  "page-not-built": { status: 503, title: "The page has not been built" },
  restarting: { status: 503, title: "The relay is being restarted" },
  "no-store": { status: 503, title: "The relay's store does not answer" },
  "storage-full": { status: 507, title: "The relay's disk is full" },
} as const satisfies Record<string, Kind>;

export type ProblemKind = keyof typeof problemKinds;

export interface RefusalOptions {
  errors?: FieldProblem[];
  /** further HTTP headers, such as Retry-After */
  headers?: Record<string, string>;
}

/** A refusal on its way to whoever asked. */
export class Refusal extends Error {
  override readonly name = "Refusal";
  readonly kind: ProblemKind;
  readonly problem: ProblemDocument;
  readonly headers: Record<string, string>;

  /** @param detail what happened and how to mend it, in one or two sentences */
  constructor(kind: ProblemKind, detail: string, options: RefusalOptions = {}) {
    super(detail);
    const { status, title } = problemKinds[kind];
    this.kind = kind;
    this.headers = options.headers ?? {};
    this.problem = {
      type: `/problems/${kind}`,
      title,
      status,
      detail,
      errors: options.errors ?? [],
    };
  }
}

/** A refusal of input that breaks a schema. */
export function badRequest(what: string, errors: FieldProblem[]): Refusal {
  return new Refusal("bad-request", `${what} See "errors" for each field.`, { errors });
}

/** A refusal for want of a valid key. @param detail which key to send, and how */
export function notAuthorised(detail: string): Refusal {
  return new Refusal("not-authorised", detail, { headers: { "WWW-Authenticate": "Bearer" } });
}

/** "Come back in so many seconds." */
export function retryAfter(milliseconds: number): Record<string, string> {
  return { "Retry-After": String(Math.max(1, Math.ceil(milliseconds / 1000))) };
}

/** The answer to whoever asks while the relay ends. */
export function restarting(): Refusal {
  return new Refusal("restarting", "It comes back by itself. Send this again in a moment.", {
    headers: retryAfter(2_000),
  });
}

/** The answer where no session has the id. */
export function noRobot(): Refusal {
  return new Refusal(
    "no-robot",
    "There is no robot with this id. Robots are forgotten after 2 hours without use: open the page and copy the new address.",
  );
}

/** Turns whatever was thrown into a refusal; what is not ours becomes "internal" without a detail. */
export function asRefusal(error: unknown): Refusal {
  if (error instanceof Refusal) return error;
  // The disk, not the request, is at fault, and waiting may help.
  if (isDiskFull(error)) {
    return new Refusal("storage-full", "Nothing was stored. Try again in a minute.", {
      headers: retryAfter(60_000),
    });
  }
  if (error instanceof StoreAway) {
    return new Refusal("no-store", "Send this again in a moment, with the same key.", {
      headers: retryAfter(2_000),
    });
  }
  return new Refusal("internal", "It was noted in the relay's log. Try again in a moment.");
}
