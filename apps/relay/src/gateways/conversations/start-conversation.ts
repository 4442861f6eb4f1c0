/** Creates the conversation for a hello and closes connections on errors, on every transport. */
import { closeReasons, scriptName, type CloseReason, type Hello } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../../platform/time/clock.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import { asRefusal } from "../../platform/errors/problems.ts";
import type { Introduction } from "../../robots/access/caller.ts";
import type { Grant } from "../../robots/registry.ts";
import { withBoundedQueue } from "./bounded-queue.ts";
import { closeWith, type Conversation } from "./conversation.ts";
import { DriverConversation } from "./driver-conversation.ts";
import { PageConversation } from "./page-conversation.ts";
import type { ReaderConnection } from "./reader-connection.ts";

const closeReasonByProblem = new Map<ProblemKind, CloseReason>([
  ["no-robot", closeReasons.noRobot],
  ["not-authorised", closeReasons.notAuthorised],
  ["forbidden", closeReasons.forbidden],
  ["blocked", closeReasons.forbidden],
  ["too-many-readers", closeReasons.tooMany],
  ["restarting", closeReasons.restart],
]);

/** Counts what the gateways reject and close. */
export interface GatewayMetrics {
  refused(problem: ProblemKind): void;
  socketClosed(code: number): void;
}

export interface ConversationOptions {
  hello: Hello;
  /** what its key permits */
  grant: Grant;
  connection: ReaderConnection;
  metrics: GatewayMetrics;
  clock: Clock;
}

/**
 * Starts a conversation as a page or as a script.
 * @throws Refusal if the robot has too many readers
 */
export function startConversation({
  hello,
  grant,
  connection,
  metrics,
  clock,
}: ConversationOptions): Conversation {
  if (hello.role === "own")
    return withBoundedQueue(new PageConversation(grant, connection), connection);
  const onRefusal = (kind: ProblemKind): void => metrics.refused(kind);
  const { since = null, sentAt } = hello;
  return new DriverConversation({ grant, connection, since, sentAt, clock, onRefusal });
}

/** How a hello identifies its script. @param client its language, from the request's headers */
export function introductionOf({ name }: Hello, client: string): Introduction {
  return { client, name: name === undefined ? null : scriptName(name) };
}

/** Closes a connection because of an error. Unexpected errors are logged. */
export function closeOnError(
  error: unknown,
  connection: { close(code: number, reason: string): void },
  { metrics, log }: { metrics: GatewayMetrics; log: Logger },
): void {
  const { kind } = asRefusal(error);
  metrics.refused(kind);
  const reason = closeReasonByProblem.get(kind) ?? closeReasons.busy;
  if (reason === closeReasons.busy) log.error({ err: error }, "handling a message failed");
  closeWith(connection, reason);
}
