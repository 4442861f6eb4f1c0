/** Requests of a robot's owner to the service about the pairing code. */
import {
  createdPairingSchema,
  pairingSchema,
  problemSchema,
  readJson,
  type Pairing,
  type CreatedPairing,
} from "@corridor/protocol";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { bearer, isDone, type Ask } from "./owner-calls.ts";

export type Owner = Pick<RemoteSession, "id" | "ownerKey">;

const MAX_ANSWER = 4_096;

/** @returns the code; null if the service created none */
export async function makeCode(ask: Ask, owner: Owner): Promise<CreatedPairing | null> {
  try {
    const answer = await ask(url(owner), { method: "POST", headers: bearer(owner.ownerKey) });
    const made = readJson(createdPairingSchema, await answer.text(), MAX_ANSWER);
    return answer.ok && made.ok ? made.value : null;
  } catch {
    return null;
  }
}

/**
 * The state of the pairing. Waits up to `seconds` for a script that uses the code.
 * @returns null if the state is unavailable; "gone" if the robot does not exist
 */
export async function lookAtPairing(
  ask: Ask,
  owner: Owner,
  seconds: number,
): Promise<Pairing | "gone" | null> {
  try {
    const answer = await ask(`${url(owner)}?wait=${seconds}`, { headers: bearer(owner.ownerKey) });
    if (answer.status === 401 || answer.status === 404) return "gone";
    const pairing = readJson(pairingSchema, await answer.text(), MAX_ANSWER);
    return answer.ok && pairing.ok ? pairing.value : null;
  } catch {
    return null;
  }
}

/** Accepts or declines a script. @returns the outcome; over: the question has expired */
export async function replyToPairing(
  ask: Ask,
  owner: Owner,
  question: string,
  accept: boolean,
): Promise<"done" | "over" | "tooManyKeys" | "failed"> {
  try {
    const answer = await ask(url(owner), {
      method: "PUT",
      headers: { ...bearer(owner.ownerKey), "Content-Type": "application/json" },
      body: JSON.stringify({ id: question, accept }),
    });
    if (answer.ok) return "done";
    if (answer.status === 404) return "over";
    if (answer.status !== 409) return "failed";
    const problem = readJson(problemSchema, await answer.text(), MAX_ANSWER);
    return problem.ok && problem.value.type === "/problems/too-many-keys" ? "tooManyKeys" : "over";
  } catch {
    return "failed";
  }
}

/** @returns whether the service deleted the code */
export async function cancelCode(ask: Ask, owner: Owner): Promise<boolean> {
  return isDone(ask, owner, "/pairing", { method: "DELETE" });
}

function url({ id }: Owner): string {
  return `/api/v1/robots/${id}/pairing`;
}
