/** All operations of the HTTP API, with the schemas that validate requests and responses. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentCalls } from "./document-calls.ts";
import { healthCalls } from "./health-calls.ts";
import { lineCalls } from "./line-calls.ts";
import { pairingCalls } from "./pairing-calls.ts";
import { robotCalls } from "./robot-calls.ts";
import { scriptCalls } from "./script-calls.ts";

export const calls: ZodOpenApiPathsObject = {
  ...robotCalls,
  ...pairingCalls,
  ...scriptCalls,
  ...lineCalls,
  ...documentCalls,
  ...healthCalls,
};
