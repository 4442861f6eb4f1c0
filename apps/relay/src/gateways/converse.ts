/** From a hello to a conversation, and from a refusal to a goodbye: the same on every kind of line. */
import { closeReasons, scriptName, type CloseReason, type Hello } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../clock.ts";
import type { Metrics } from "../metrics/metrics.ts";
import type { ProblemKind } from "../problem-kinds.ts";
import { asRefusal } from "../problems.ts";
import type { Introduction } from "../sessions/script.ts";
import type { Grant } from "../sessions/session-hub.ts";
import { bounded } from "./bounded.ts";
import { closeWith, type Conversation } from "./conversation.ts";
import { DriverConversation } from "./driver-conversation.ts";
import { PageConversation } from "./page-conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

const closeReasonByProblem = new Map<ProblemKind, CloseReason>([
  ["no-robot", closeReasons.noRobot],
  ["not-authorised", closeReasons.notAuthorised],
  ["forbidden", closeReasons.forbidden],
  ["sent-away", closeReasons.forbidden],
  ["too-many-readers", closeReasons.tooMany],
  ["restarting", closeReasons.restart],
]);

export interface Guest {
  hello: Hello;
  /** what its key allows */
  grant: Grant;
  line: ReaderLine;
  metrics: Metrics;
  clock: Clock;
}

/**
 * Begins to speak with whoever said hello, as a page or as a script.
 * @throws Refusal when too many read already
 */
export function converse({ hello, grant, line, metrics, clock }: Guest): Conversation {
  if (hello.role === "own") return bounded(new PageConversation(grant, line), line);
  const refused = (kind: ProblemKind): void => metrics.refused(kind);
  const { since = null, sentAt } = hello;
  return new DriverConversation({ grant, line, since, sentAt, clock, refused });
}

/** What a hello says of the script. @param client its language, as the request's headers have it */
export function introduced({ name }: Hello, client: string): Introduction {
  return { client, name: name === undefined ? null : scriptName(name) };
}

/** Closes a line because of an error; a mistake of the relay goes to its log. */
export function closeFor(
  error: unknown,
  line: { close(code: number, reason: string): void },
  { metrics, log }: { metrics: Metrics; log: Logger },
): void {
  const { kind } = asRefusal(error);
  metrics.refused(kind);
  const reason = closeReasonByProblem.get(kind) ?? closeReasons.busy;
  if (reason === closeReasons.busy) log.error({ err: error }, "a message failed");
  closeWith(line, reason);
}
