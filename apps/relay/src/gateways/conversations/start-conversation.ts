/** Creates the conversation with a robot for a hello, on every transport. */
import type { Hello, GatewayName } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import type { Grant } from "../../robots/registry.ts";
import { withBoundedQueue } from "./bounded-queue.ts";
import type { Conversation, ClientConnection } from "./conversation.ts";
import { DriverConversation } from "./driver-conversation.ts";
import { PageConversation } from "./page-conversation.ts";

/** Counts what the gateways reject and close. */
export interface GatewayMetrics {
  refused(problem: ProblemKind): void;
  socketClosed(code: number): void;
  gatewayMessage(gateway: GatewayName): void;
}

export interface ConversationOptions {
  hello: Hello;
  /** what its key permits */
  grant: Grant;
  connection: ClientConnection;
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
