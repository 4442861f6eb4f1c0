/** What the owner of a robot asks of the service: how long the robot has left, and a new key for scripts. */
import { madeKeySchema, readJson } from "@corridor/protocol";
import type { RemoteSession } from "../../worker/worker-messages.ts";

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
 * Makes a new key for scripts; who has the old one is cut off by the service.
 * @returns the session with the new address; null when the service made none
 */
export async function withNewKey(ask: Ask, session: RemoteSession): Promise<RemoteSession | null> {
  const { id, ownerKey } = session;
  try {
    const answer = await ask(`/api/v1/robots/${id}/keys`, {
      method: "POST",
      headers: { ...bearer(ownerKey), "Content-Type": "application/json" },
      body: JSON.stringify({ kind: "drive", replace: true }),
    });
    const made = readJson(madeKeySchema, await answer.text(), MAX_ANSWER);
    if (!answer.ok || !made.ok) return null;
    return { ...session, driverKey: made.value.key, address: made.value.address };
  } catch {
    return null;
  }
}

function bearer(key: string): Record<string, string> {
  return { Authorization: `Bearer ${key}` };
}
