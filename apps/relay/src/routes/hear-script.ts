/** A request of a script: who may not is refused, and who may is heard until the answer is out. */
import type { Request, Response } from "express";
import type { Grant, SessionHub } from "../sessions/session-hub.ts";
import type { Verb } from "../sessions/rights.ts";
import { readBearer, readIntroduction } from "./reading.ts";

/**
 * @returns the session and the script's key, and a function that says that it is answered before it is
 * @throws Refusal as `SessionHub.authorise` does
 */
export async function hearScript(
  hub: SessionHub,
  request: Request<{ id: string }>,
  response: Response,
  verb: Verb,
): Promise<Grant & { answered: () => void }> {
  const grant = await hub.authorise(
    request.params.id,
    readBearer(request),
    verb,
    readIntroduction(request),
  );
  const answered = grant.session.heard(grant.key);
  response.once("close", answered);
  // Whoever hung up while it was authorised is not waited for.
  if (response.closed) answered();
  return { ...grant, answered };
}
