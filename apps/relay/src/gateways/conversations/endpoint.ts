/**
 * What clients connect to, robots or classes, independent of the transport: how a hello is read,
 * who is admitted, and the conversation that follows.
 */
import {
  closeReasons,
  helloSchema,
  MAX_FRAME_BYTES,
  robotIdSchema,
  scriptName,
  type CloseReason,
  type Hello,
} from "@corridor/protocol";
import type { z } from "zod";
import type { Clock } from "../../platform/time/clock.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import type { Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { verbOfRole } from "../../robots/access/callers.ts";
import type { RobotRegistry } from "../../robots/registry.ts";
import type { Conversation, ClientConnection } from "./conversation.ts";
import { startConversation, type GatewayMetrics } from "./start-conversation.ts";

/** A client whose key is valid. */
export interface Admitted {
  /** Counts a request on a long-poll connection as activity, like a message on a socket. */
  requested(): void;
  /** @throws Refusal if there are too many connections */
  start(connection: ClientConnection): Conversation;
}

/** Why a connection closes, and a text in place of that of the reason. */
export interface Closing {
  reason: CloseReason;
  detail?: string;
}

export interface Endpoint<H extends { role: string; key: string }> {
  /** first part of the path, below /api/v1 */
  readonly name: "robots" | "classes";
  readonly helloSchema: z.ZodType<H>;
  /** largest message of a client that is authenticated, in bytes */
  readonly maxMessageBytes: number;
  readonly connectionsPerAddress: number;
  /** closes a connection without a hello in time */
  readonly unauthorised: Closing;
  /** @returns why there can be nothing with this id; null: it is possible */
  checkId(id: string): Closing | null;
  /**
   * Checks the key.
   * @param client its language, from the request's headers
   * @throws Refusal if the key does not permit the connection
   */
  admit(id: string, hello: H, client: string): Promise<Admitted>;
  /** @returns null for an error that is not the client's */
  closingOf(refusal: Refusal): Closing | null;
}

const closings = new Map<ProblemKind, CloseReason>([
  ["no-robot", closeReasons.noRobot],
  ["not-authorised", closeReasons.notAuthorised],
  ["forbidden", closeReasons.forbidden],
  ["blocked", closeReasons.forbidden],
  ["too-many-readers", closeReasons.tooMany],
  ["restarting", closeReasons.restart],
]);

/** Robots, whose clients are pages and scripts. */
export function robotEndpoint(parts: {
  registry: RobotRegistry;
  metrics: GatewayMetrics;
  clock: Clock;
}): Endpoint<Hello> {
  const { registry, metrics, clock } = parts;
  return {
    name: "robots",
    helloSchema,
    maxMessageBytes: MAX_FRAME_BYTES,
    connectionsPerAddress: limits.socketsPerAddress,
    unauthorised: { reason: closeReasons.notAuthorised },
    checkId: (id) =>
      robotIdSchema.safeParse(id).success ? null : { reason: closeReasons.noRobot },
    admit: async (id, hello, client) => {
      const { role, key, name } = hello;
      const introduction = { client, name: name === undefined ? null : scriptName(name) };
      const grant = await registry.authorise(id, key, verbOfRole[role], introduction);
      return {
        requested: () => {
          if (role !== "own") grant.robot.spoke(grant.caller);
        },
        start: (connection) => startConversation({ hello, grant, connection, metrics, clock }),
      };
    },
    closingOf: ({ kind }) => {
      const reason = closings.get(kind);
      return reason === undefined ? null : { reason };
    },
  };
}
