/** A request of a script: who may not is refused, and who may is heard until the answer is out. */
import type { Request, Response } from "express";
import type { Grant, SessionHub } from "../sessions/session-hub.ts";
import type { Verb } from "../sessions/rights.ts";
import { readBearer, readIntroduction, readScriptTime } from "./reading.ts";

export interface Heard extends Grant {
  /** ms by the relay's clock when the request came */
  cameAt: number;
  /** ms that it was on its way longer than the quickest one of its script; 0 where it tells no time */
  transitMs: number;
  /** says that it is answered before it is */
  answered: () => void;
}

/** @throws Refusal as `SessionHub.authorise` does */
export async function hearScript(
  hub: SessionHub,
  request: Request<{ id: string }>,
  response: Response,
  verb: Verb,
): Promise<Heard> {
  const cameAt = hub.clock.now();
  const grant = await hub.authorise(
    request.params.id,
    readBearer(request),
    verb,
    readIntroduction(request),
  );
  const { session, key } = grant;
  const transitMs = session.scriptClocks.came(key.hash, readScriptTime(request), cameAt);
  const answered = session.heard(key);
  response.once("close", answered);
  // Whoever hung up while it was authorised is not waited for.
  if (response.closed) answered();
  return { ...grant, cameAt, transitMs, answered };
}
