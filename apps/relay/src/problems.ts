/**
 * Everything that the relay refuses, as problem documents (RFC 9457). The same document answers an
 * HTTP request and a WebSocket message, and it never tells more than the client may know.
 */
import { describeProblem, type FieldProblem, type ProblemDocument } from "@corridor/protocol";
import { problemKinds, type ProblemKind } from "./problem-kinds.ts";
import { isDiskFull } from "./store/disk-full.ts";
import { StoreAway } from "./store/store-away.ts";

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

/**
 * A refusal of input that breaks a schema. `detail` names the first wrong field, because short scripts print
 * nothing else. It has no double quotes, because scripts without a JSON parser read it up to the next one.
 */
export function badRequest(what: string, errors: FieldProblem[]): Refusal {
  const first = errors.slice(0, 1).map((each) => ` ${describeProblem(each)}.`);
  const rest = errors.length > 1 ? " The field 'errors' lists all that is wrong." : "";
  const detail = `${what}${first.join("")}${rest}`.replaceAll('"', "'");
  return new Refusal("bad-request", detail, { errors });
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
