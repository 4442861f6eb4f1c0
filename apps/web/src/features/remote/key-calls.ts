/** The keys of a robot as its owner is told of them, and taking one back. */
import { keyListSchema, readJson, type KeyList } from "@corridor/protocol";
import { bearer, isDone, type Ask } from "./owner-calls.ts";
import type { Owner } from "./pairing-calls.ts";

const MAX_ANSWER = 4_096;

export interface ListedKey {
  id: string;
  kind: "drive" | "watch";
  /** ms, by the service's clock */
  madeAgo: number;
  /** null: never used */
  usedAgo: number | null;
  /** the one in the address that the panel shows */
  isShown: boolean;
}

/** @returns all but the owner's own, oldest first; null when nobody can tell */
export async function listKeys(ask: Ask, { id, ownerKey }: Owner): Promise<ListedKey[] | null> {
  try {
    const answer = await ask(`/api/v1/robots/${id}/keys`, { headers: bearer(ownerKey) });
    const list = readJson(keyListSchema, await answer.text(), MAX_ANSWER);
    if (!answer.ok || !list.ok) return null;
    const told = Date.parse(answer.headers.get("date") ?? "");
    return listed(list.value, Number.isNaN(told) ? Date.now() : told);
  } catch {
    return null;
  }
}

/** @returns whether the service did so */
export async function revokeKey(ask: Ask, owner: Owner, key: string): Promise<boolean> {
  return isDone(ask, owner, `/keys/${key}`, { method: "DELETE" });
}

/** @param now by the clock that wrote the times */
export function listed({ keys }: KeyList, now: number): ListedKey[] {
  const ago = (time: string): number => Math.max(0, now - Date.parse(time));
  const others = keys.flatMap(({ id, kind, madeAt, lastUsedAt }) =>
    kind === "own"
      ? []
      : [{ id, kind, madeAgo: ago(madeAt), usedAgo: lastUsedAt === null ? null : ago(lastUsedAt) }],
  );
  const sorted = others.toSorted((a, b) => b.madeAgo - a.madeAgo);
  // A new key in the address revokes all that drive, so those that scripts were paired with are younger.
  const shown = sorted.find(({ kind }) => kind === "drive");
  return sorted.map((key) => ({ ...key, isShown: key === shown }));
}
