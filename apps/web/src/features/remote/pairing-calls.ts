/** What the owner of a robot asks of the service about its pairing code. */
import {
  createdPairingSchema,
  pairingSchema,
  problemSchema,
  readJson,
  type Pairing,
  type CreatedPairing,
} from "@corridor/protocol";
import type { RemoteSession } from "../../worker/worker-messages.ts";
import { bearer, isDone, type Ask } from "./owner-calls.ts";

export type Owner = Pick<RemoteSession, "id" | "ownerKey">;

const MAX_ANSWER = 4_096;

/** @returns the code; null when the service made none */
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
 * How it stands with the code. Waits for so many seconds for a script that asks.
 * @returns null when nobody can tell at the moment; "gone" when there is no such robot
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

/** Says yes or no. @returns how that went; over: nobody asks any more */
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

/** @returns whether the service did so */
export async function takeBackCode(ask: Ask, owner: Owner): Promise<boolean> {
  return isDone(ask, owner, "/pairing", { method: "DELETE" });
}

function url({ id }: Owner): string {
  return `/api/v1/robots/${id}/pairing`;
}
