/** Parts of the descriptions of operations on a robot: who may call them, and with which headers. */
import { robotIdSchema } from "@corridor/protocol";
import { z } from "zod";
import type { oas31 } from "zod-openapi";
import { parameters } from "../../platform/openapi/parts.ts";
import { clockHeader, idempotencyHeader, nameHeader } from "./script-requests.ts";

/** Errors of every operation with a key. */
export const keyed = ["bad-request", "not-authorised", "forbidden", "no-robot"] as const;
/** Errors of every operation for scripts. */
export const asScript = [...keyed, "blocked"] as const;
/** Security of operations for the robot's owner. */
export const owner = [{ ownerKey: [] }];

/** Security of operations for scripts, for all readers, and for everyone with a key. */
export const driver = [{ driverKey: [] }];
export const reader = [...driver, { watchKey: [] }];
export const anyKey = [...reader, ...owner];

/** Path parameter of the robot. */
export const robot: oas31.ParameterObject[] = parameters("path", z.object({ id: robotIdSchema }));

export const idempotencyKey: oas31.ParameterObject[] = parameters("header", idempotencyHeader);
/** Headers with which a script identifies itself. */
export const ofScript: oas31.ParameterObject[] = [
  ...parameters("header", nameHeader),
  ...parameters("header", clockHeader),
];
