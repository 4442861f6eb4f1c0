/** Authorises a request of a script and marks the script as active until the response has ended. */
import type { Request, Response } from "express";
import type { Grant, RobotRegistry } from "../../robots/registry.ts";
import type { Verb } from "../../robots/access/caller.ts";
import { readBearer } from "../../platform/http/reading.ts";
import { readIntroduction, readScriptTime } from "./reading.ts";

export interface AuthorisedRequest extends Grant {
  /** arrival time of the request in ms, by the relay's clock */
  arrivedAt: number;
  /** ms that the request took longer than the fastest one of its script; 0 without a timestamp */
  transitMs: number;
  /** ends the activity of the script before the response ends */
  markAnswered: () => void;
}

/** @throws Refusal with the same errors as `RobotRegistry.authorise` */
export async function authoriseScript(
  registry: RobotRegistry,
  request: Request<{ id: string }>,
  response: Response,
  verb: Verb,
): Promise<AuthorisedRequest> {
  const arrivedAt = registry.clock.now();
  const grant = await registry.authorise(
    request.params.id,
    readBearer(request),
    verb,
    readIntroduction(request),
  );
  const { robot, key } = grant;
  const transitMs = robot.scriptClocks.came(key.hash, readScriptTime(request), arrivedAt);
  const markAnswered = robot.received(key);
  response.once("close", markAnswered);
  // The client may have disconnected during authorisation.
  if (response.closed) markAnswered();
  return { ...grant, arrivedAt, transitMs, markAnswered };
}
