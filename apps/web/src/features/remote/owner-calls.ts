/**
 * Requests of a robot's owner to the service: remaining lifetime, gateways, new keys, and
 * permissions of scripts.
 */
import {
  createdKeySchema,
  readJson,
  type KeyRequest,
  type CreatedKey,
  type ScriptRef,
} from "@corridor/protocol";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { keyIdOf } from "./key-id.ts";

const MAX_ANSWER = 4_096;

type RobotOwner = Pick<RemoteSession, "id" | "ownerKey">;

/** The part of `fetch` that is used here. */
export type Ask = (
  url: string,
  init: { method?: string; headers: Record<string, string>; body?: string },
) => Promise<Response>;

/** @returns seconds until the service deletes the robot; null if unavailable */
export async function secondsLeft(ask: Ask, owner: RobotOwner): Promise<number | null> {
  const { endsInSeconds } = await readRobot(ask, owner);
  return typeof endsInSeconds === "number" ? endsInSeconds : null;
}

/** @returns the names of the gateways that the service offers; null if unavailable */
export async function offeredGateways(ask: Ask, owner: RobotOwner): Promise<string[] | null> {
  const { gateways } = await readRobot(ask, owner);
  return Array.isArray(gateways) ? gateways.filter((name) => typeof name === "string") : null;
}

/**
 * Creates a new key for the address. The service disconnects scripts that use the old key; scripts
 * with their own keys continue.
 * @returns the session with the new address; null if the service created none
 */
export async function withNewKey(ask: Ask, session: RemoteSession): Promise<RemoteSession | null> {
  const request: KeyRequest = { kind: "drive", replace: keyIdOf(session.driverKey) };
  let answer = await makeKey(ask, session, request);
  // The old key no longer exists: the response to an earlier request may have been lost.
  if (answer.status === 409) answer = await makeKey(ask, session, { kind: "drive" });
  const { made } = answer;
  if (made === null || made.address === null) return null;
  return { ...session, driverKey: made.key, address: made.address };
}

/**
 * Creates a watch key for viewers, which replaces an earlier one.
 * @returns the address with the key; null if the service created none
 */
export async function createWatchAddress(ask: Ask, session: RemoteSession): Promise<string | null> {
  const { made } = await makeKey(ask, session, { kind: "watch", replace: true });
  return made?.address ?? null;
}

/** Creates a key that a URL may contain. @returns the key; null if the service created none */
export async function createUrlKey(ask: Ask, owner: RobotOwner): Promise<string | null> {
  const { made } = await makeKey(ask, owner, { kind: "drive", use: "url" });
  return made?.key ?? null;
}

/** Blocks a script until it is unblocked. @returns whether the service did so */
export async function blockScript(
  ask: Ask,
  session: RemoteSession,
  { driver, name, client }: ScriptRef,
): Promise<boolean> {
  return isDone(ask, session, "/blocked", {
    method: "POST",
    body: JSON.stringify({ driver, name, client }),
  });
}

/** Unblocks a script. @param script its id @returns whether the service did so */
export async function unblockScript(
  ask: Ask,
  session: RemoteSession,
  script: string,
): Promise<boolean> {
  return isDone(ask, session, `/blocked/${script}`, { method: "DELETE" });
}

/** Pauses all scripts, or resumes them. @returns whether the service did so */
export async function pauseDriving(
  ask: Ask,
  session: RemoteSession,
  isPaused: boolean,
): Promise<boolean> {
  return isDone(ask, session, "/pause", { method: isPaused ? "PUT" : "DELETE" });
}

/** Lets scripts reset the robot, or not. @returns whether the service did so */
export async function permitReset(
  ask: Ask,
  session: RemoteSession,
  mayReset: boolean,
): Promise<boolean> {
  return isDone(ask, session, "/script-reset", { method: mayReset ? "PUT" : "DELETE" });
}

/** @returns whether the service accepted the request */
export async function isDone(
  ask: Ask,
  { id, ownerKey }: RobotOwner,
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

/** @returns the stored data of the robot; without fields if unavailable */
async function readRobot(
  ask: Ask,
  { id, ownerKey }: RobotOwner,
): Promise<{ endsInSeconds?: unknown; gateways?: unknown }> {
  try {
    const answer = await ask(`/api/v1/robots/${id}`, { headers: bearer(ownerKey) });
    return answer.ok ? ((await answer.json()) as object) : {};
  } catch {
    return {};
  }
}

/** @returns the key, and the status: null if the service does not respond */
async function makeKey(
  ask: Ask,
  { id, ownerKey }: RobotOwner,
  request: KeyRequest,
): Promise<{ status: number | null; made: CreatedKey | null }> {
  try {
    const answer = await ask(`/api/v1/robots/${id}/keys`, {
      method: "POST",
      headers: { ...bearer(ownerKey), "Content-Type": "application/json" },
      body: JSON.stringify(request),
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
