/** Classes as an endpoint: students, dashboards and big screens connect to them. */
import {
  classHelloSchema,
  classIdSchema,
  closeReasons,
  MAX_DISPLAY_LENGTH,
  type ClassHello,
  type CloseReason,
} from "@corridor/protocol";
import type { ClassRegistry } from "../../classes/registry.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { Clock } from "../../platform/time/clock.ts";
import { startClassConversation } from "./class-conversation.ts";
import type { Endpoint } from "./endpoint.ts";
import type { GatewayMetrics } from "./start-conversation.ts";

const OVER = "The class has ended, or the address contains a typing error.";

const closings = new Map<ProblemKind, CloseReason>([
  ["no-class", closeReasons.over],
  ["not-authorised", closeReasons.notAuthorised],
  ["forbidden", closeReasons.forbidden],
  ["too-many-readers", closeReasons.tooMany],
  ["restarting", closeReasons.restart],
]);

export function classEndpoint(parts: {
  classes: ClassRegistry;
  metrics: GatewayMetrics;
  clock: Clock;
}): Endpoint<ClassHello> {
  const { classes, metrics, clock } = parts;
  return {
    name: "classes",
    helloSchema: classHelloSchema,
    // Characters of a display may have several bytes. The conversation counts characters.
    maxMessageBytes: 3 * MAX_DISPLAY_LENGTH,
    connectionsPerAddress: limits.classConnectionsPerAddress,
    unauthorised: {
      reason: closeReasons.notAuthorised,
      detail: "The relay received no valid hello in time. Send it first, with a key of this class.",
    },
    checkId: (id) =>
      classIdSchema.safeParse(id).success ? null : { reason: closeReasons.over, detail: OVER },
    admit: async (id, hello) => {
      const grant = await classes.authorise(id, hello.key, hello.role);
      return {
        requested: () => grant.found.used(),
        start: (connection) => startClassConversation({ hello, grant, connection, metrics, clock }),
      };
    },
    closingOf: ({ kind, problem }) => {
      const reason = closings.get(kind);
      if (reason === undefined) return null;
      return { reason, detail: kind === "no-class" ? OVER : problem.detail };
    },
  };
}
