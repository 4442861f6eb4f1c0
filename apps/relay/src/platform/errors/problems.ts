/**
 * Errors of the relay as problem documents (RFC 9457). HTTP responses and WebSocket messages carry
 * the same documents, which never reveal more than the client may see.
 */
import {
  describeProblem,
  RefusedError,
  UNKNOWN_ROBOT,
  type FieldProblem,
  type ProblemDocument,
} from "@corridor/protocol";
import { problemKinds, type ProblemKind } from "./problem-kinds.ts";
import { isDiskFull } from "./disk-full.ts";
import { StoreUnavailableError } from "./store-unavailable.ts";

export interface RefusalOptions {
  errors?: FieldProblem[];
  /** extra HTTP headers, such as Retry-After */
  headers?: Record<string, string>;
}

/** Error that the relay returns to the client as a problem document. */
export class Refusal extends Error {
  override readonly name = "Refusal";
  readonly kind: ProblemKind;
  readonly problem: ProblemDocument;
  readonly headers: Record<string, string>;

  /** @param detail what happened and how to fix it, in one or two sentences */
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

/**
 * Rejects input that violates a schema. `detail` names the first wrong field, because short scripts
 * print nothing else. It contains no double quotes, because scripts without a JSON parser read it
 * up to the next one.
 */
export function badRequest(what: string, errors: FieldProblem[]): Refusal {
  const first = errors.slice(0, 1).map((each) => ` ${describeProblem(each)}.`);
  const rest = errors.length > 1 ? " The field 'errors' lists all problems." : "";
  const detail = `${what}${first.join("")}${rest}`.replaceAll('"', "'");
  return new Refusal("bad-request", detail, { errors });
}

/**
 * Rejects a body that is not JSON. `detail` contains no example, because it contains no double
 * quotes.
 * @param body the text that is not JSON
 * @param example of a valid body
 */
export function notJson(what: string, body: string, example?: string): Refusal {
  const where = example === undefined ? "" : ", as in the example in 'errors'";
  const expected = `a JSON document${example === undefined ? "" : `, such as ${example}`}`;
  return new Refusal("bad-request", `${what} The body is not JSON. ${jsonHint(body)}${where}.`, {
    errors: [{ path: "", found: "text that is not JSON", expected }],
  });
}

/** What to correct in a text that is not JSON. */
function jsonHint(body: string): string {
  if (body.trim() === "") return "It is empty: send a JSON document";
  const withoutTexts = body.replaceAll(/"(?:[^"\\]|\\[^])*\\?(?:"|$)/g, "");
  const withoutNumbers = withoutTexts.replaceAll(
    /\b(?:true|false|null|NaN|Infinity|\d[\w.]*)\b/g,
    "",
  );
  return /[\p{L}'\u2018-\u201D]/u.test(withoutNumbers)
    ? "Put names and texts into double quotes"
    : "Check quotes, commas, brackets and numbers";
}

/** Rejects a request without a valid key. @param detail which key to send, and how */
export function notAuthorised(detail: string): Refusal {
  return new Refusal("not-authorised", detail, { headers: { "WWW-Authenticate": "Bearer" } });
}

/** Retry-After header, rounded up to whole seconds and at least 1. */
export function retryAfter(milliseconds: number): Record<string, string> {
  return { "Retry-After": String(Math.max(1, Math.ceil(milliseconds / 1000))) };
}

/** Response to requests during shutdown. */
export function restarting(): Refusal {
  return new Refusal("restarting", "The relay is restarting. Send the request again in 2 s.", {
    headers: retryAfter(2_000),
  });
}

/** Response if no robot has the id. */
export function noRobot(): Refusal {
  return new Refusal("no-robot", UNKNOWN_ROBOT);
}

/** Response if no class has the id. */
export function noClass(): Refusal {
  return new Refusal(
    "no-class",
    "The class has ended, or the id contains a typing error. The relay deletes a class when its teacher ends it, after 2 hours without use, and 12 hours after its creation.",
  );
}

/**
 * Converts any error to a refusal as ports throw it. Its cause is the original error, for the log.
 */
export function asRefused(error: unknown, refusal = asRefusal(error)): RefusedError {
  if (error instanceof RefusedError) return error;
  const seconds = refusal.headers["Retry-After"];
  const retryAfterSeconds = seconds === undefined ? null : Number(seconds);
  return new RefusedError(refusal.problem, { cause: error, retryAfter: retryAfterSeconds });
}

/** Converts any error to a problem. Unexpected errors become "internal" without details. */
export function asRefusal(error: unknown): Refusal {
  if (error instanceof Refusal) return error;
  // The disk causes this, not the request, and waiting may help.
  if (isDiskFull(error)) {
    return new Refusal(
      "storage-full",
      "The relay cannot store new data because its disk is full. Try again in a minute.",
      {
        headers: retryAfter(60_000),
      },
    );
  }
  if (error instanceof StoreUnavailableError) {
    return new Refusal(
      "no-store",
      "The relay's database does not respond. Send the request again in 2 s, with the same idempotency key.",
      {
        headers: retryAfter(2_000),
      },
    );
  }
  return new Refusal(
    "internal",
    "The relay failed to process the request. Try again in a few seconds. The relay's log contains the details.",
  );
}
