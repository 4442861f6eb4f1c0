/** All operations of the HTTP API, with the schemas that validate requests and responses. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentCalls } from "./rest/short-links/openapi.ts";
import { healthCalls } from "../ops/health-openapi.ts";
import { longPollCalls } from "./long-poll/openapi.ts";
import { pairingCalls } from "./rest/pairing/openapi.ts";
import { robotCalls } from "./rest/robots/openapi.ts";
import { scriptCalls } from "./rest/commands/openapi.ts";

export const calls: ZodOpenApiPathsObject = {
  ...robotCalls,
  ...pairingCalls,
  ...scriptCalls,
  ...longPollCalls,
  ...documentCalls,
  ...healthCalls,
};
