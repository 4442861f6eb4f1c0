/** What the owner of a robot asks of the service: how long the robot has left, new keys, and which
 * scripts may drive. */
import {
  createdKeySchema,
  readJson,
  type KeyRequest,
  type CreatedKey,
  type ScriptRef,
} from "@corridor/protocol";
import type { RemoteSession } from "../../worker/worker-messages.ts";
import { keyIdOf } from "./key-id.ts";

const MAX_ANSWER = 4_096;

/** fetch, as far as it is needed */
export type Ask = (
  url: string,
  init: { method?: string; headers: Record<string, string>; body?: string },
) => Promise<Response>;

/** @returns seconds until the robot is forgotten; null when nobody can tell */
export async function secondsLeft(
  ask: Ask,
  { id, ownerKey }: Pick<RemoteSession, "id" | "ownerKey">,
): Promise<number | null> {
  try {
    const answer = await ask(`/api/v1/robots/${id}`, { headers: bearer(ownerKey) });
    if (!answer.ok) return null;
    const { endsInSeconds } = (await answer.json()) as { endsInSeconds?: unknown };
    return typeof endsInSeconds === "number" ? endsInSeconds : null;
  } catch {
    return null;
  }
}

/**
 * Makes a new key for the address; who has the old one is cut off by the service, and scripts with keys of their
 * own go on.
 * @returns the session with the new address; null when the service made none
 */
export async function withNewKey(ask: Ask, session: RemoteSession): Promise<RemoteSession | null> {
  const wish: KeyRequest = { kind: "drive", replace: keyIdOf(session.driverKey) };
  let answer = await makeKey(ask, session, wish);
  // The old one is gone already: the answer to an earlier wish may have been lost.
  if (answer.status === 409) answer = await makeKey(ask, session, { kind: "drive" });
  const { made } = answer;
  return made === null ? null : { ...session, driverKey: made.key, address: made.address };
}

/**
 * Makes a key for whoever only looks on; an earlier one ends.
 * @returns the address with it; null when the service made none
 */
export async function watchAddress(ask: Ask, session: RemoteSession): Promise<string | null> {
  const { made } = await makeKey(ask, session, { kind: "watch", replace: true });
  return made?.address ?? null;
}

/** Sends a script away, until it is let back. @returns whether the service did so */
export async function sendAway(
  ask: Ask,
  session: RemoteSession,
  { driver, name, client }: ScriptRef,
): Promise<boolean> {
  return isDone(ask, session, "/blocked", {
    method: "POST",
    body: JSON.stringify({ driver, name, client }),
  });
}

/** @param script id @returns whether the service did so */
export async function letBack(ask: Ask, session: RemoteSession, script: string): Promise<boolean> {
  return isDone(ask, session, `/blocked/${script}`, { method: "DELETE" });
}

/** Pauses remote driving, or lets scripts drive again. @returns whether the service did so */
export async function pauseDriving(
  ask: Ask,
  session: RemoteSession,
  isPaused: boolean,
): Promise<boolean> {
  return isDone(ask, session, "/pause", { method: isPaused ? "PUT" : "DELETE" });
}

/** @returns whether the service did what was asked of it */
export async function isDone(
  ask: Ask,
  { id, ownerKey }: Pick<RemoteSession, "id" | "ownerKey">,
  path: string,
  request: { method: string; body?: string },
): Promise<boolean> {
  try {
    const headers = { ...bearer(ownerKey), "Content-Type": "application/json" };
    return (await ask(`/api/v1/robots/${id}${path}`, { ...request, headers })).ok;
  } catch {
    return false;
  }
}

/** @returns the status too: that of a service that does not answer is null */
async function makeKey(
  ask: Ask,
  { id, ownerKey }: RemoteSession,
  wish: KeyRequest,
): Promise<{ status: number | null; made: CreatedKey | null }> {
  try {
    const answer = await ask(`/api/v1/robots/${id}/keys`, {
      method: "POST",
      headers: { ...bearer(ownerKey), "Content-Type": "application/json" },
      body: JSON.stringify(wish),
    });
    const made = readJson(createdKeySchema, await answer.text(), MAX_ANSWER);
    return { status: answer.status, made: answer.ok && made.ok ? made.value : null };
  } catch {
    return { status: null, made: null };
  }
}

export function bearer(key: string): Record<string, string> {
  return { Authorization: `Bearer ${key}` };
}
