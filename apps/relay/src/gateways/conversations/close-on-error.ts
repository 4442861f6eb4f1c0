/** Closes connections on errors, on every transport. */
import { closeReasons } from "@corridor/protocol";
import type { Logger } from "pino";
import { asRefusal } from "../../platform/errors/problems.ts";
import { closeWith } from "./conversation.ts";
import type { Endpoint } from "./endpoint.ts";
import type { GatewayMetrics } from "./start-conversation.ts";

/** Closes a connection because of an error. Unexpected errors are logged. */
export function closeOnError(
  error: unknown,
  connection: { close(code: number, reason: string): void },
  parts: {
    endpoint: Pick<Endpoint<never>, "closingOf">;
    metrics: GatewayMetrics;
    log: Logger;
  },
): void {
  const refusal = asRefusal(error);
  parts.metrics.refused(refusal.kind);
  const closing = parts.endpoint.closingOf(refusal);
  if (closing === null) parts.log.error({ err: error }, "handling a message failed");
  closeWith(connection, closing?.reason ?? closeReasons.busy, closing?.detail);
}
