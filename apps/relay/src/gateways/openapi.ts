/** All operations of the gateways, with the schemas that validate requests and responses. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { longPollCalls } from "./long-poll/openapi.ts";
import { classCalls } from "./rest/classes/openapi.ts";
import { commandCalls } from "./rest/commands/openapi.ts";
import { oembedCalls } from "./rest/embedding/openapi.ts";
import { keyCalls } from "./rest/keys/openapi.ts";
import { mazeCalls } from "./rest/maze/openapi.ts";
import { pairingCalls } from "./rest/pairing/openapi.ts";
import { robotCalls } from "./rest/robots/openapi.ts";
import { scriptCalls } from "./rest/scripts/openapi.ts";
import { sensorCalls } from "./rest/sensors/openapi.ts";
import { documentCalls } from "./rest/short-links/openapi.ts";
import { eventCalls } from "./sse/openapi.ts";

export const gatewayCalls: ZodOpenApiPathsObject = {
  ...robotCalls,
  ...keyCalls,
  ...scriptCalls,
  ...pairingCalls,
  ...sensorCalls,
  ...mazeCalls,
  ...commandCalls,
  ...eventCalls,
  ...longPollCalls,
  ...documentCalls,
  ...oembedCalls,
  ...classCalls,
};
