/** All operations of the HTTP API, with the schemas that validate requests and responses. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentCalls } from "./document-calls.ts";
import { healthCalls } from "../ops/health-openapi.ts";
import { longPollCalls } from "./long-poll-calls.ts";
import { pairingCalls } from "./pairing-calls.ts";
import { robotCalls } from "./robot-calls.ts";
import { scriptCalls } from "./script-calls.ts";

export const calls: ZodOpenApiPathsObject = {
  ...robotCalls,
  ...pairingCalls,
  ...scriptCalls,
  ...longPollCalls,
  ...documentCalls,
  ...healthCalls,
};
