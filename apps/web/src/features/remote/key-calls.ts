/** Lists and revokes the keys of a robot for its owner. */
import { keyListSchema, readJson, type KeyList } from "@corridor/protocol";
import { keyIdOf } from "./key-id.ts";
import { bearer, isDone, type Ask } from "./owner-calls.ts";
import type { Owner } from "./pairing-calls.ts";

const MAX_ANSWER = 4_096;

export interface ListedKey {
  id: string;
  kind: "drive" | "watch";
  /** whether it works in the URL of another program only */
  isForUrl: boolean;
  /** ms since its creation, by the service's clock */
  madeAgo: number;
  /** ms since its last use, by the service's clock; null: never used */
  usedAgo: number | null;
  /** whether it is the key in the address that the panel displays */
  isShown: boolean;
}

/**
 * @returns all keys but the owner's, first that of the address, then the oldest; null if
 * unavailable
 */
export async function listKeys(
  ask: Ask,
  { id, ownerKey, driverKey }: Owner & { driverKey: string },
): Promise<ListedKey[] | null> {
  try {
    const answer = await ask(`/api/v1/robots/${id}/keys`, { headers: bearer(ownerKey) });
    const list = readJson(keyListSchema, await answer.text(), MAX_ANSWER);
    if (!answer.ok || !list.ok) return null;
    const serverTime = Date.parse(answer.headers.get("date") ?? "");
    return listed(
      list.value,
      keyIdOf(driverKey),
      Number.isNaN(serverTime) ? Date.now() : serverTime,
    );
  } catch {
    return null;
  }
}

/** @returns whether the service revoked the key */
export async function revokeKey(ask: Ask, owner: Owner, key: string): Promise<boolean> {
  return isDone(ask, owner, `/keys/${key}`, { method: "DELETE" });
}

/**
 * @param shown id of the key in the address
 * @param now ms since 1970, by the service's clock
 */
export function listed({ keys }: KeyList, shown: string, now: number): ListedKey[] {
  const ago = (time: string): number => Math.max(0, now - Date.parse(time));
  const others = keys.flatMap(({ id, kind, use, createdAt, lastUsedAt }): ListedKey[] => {
    if (kind === "own") return [];
    const usedAgo = lastUsedAt === null ? null : ago(lastUsedAt);
    const isForUrl = use === "url";
    return [{ id, kind, isForUrl, madeAgo: ago(createdAt), usedAgo, isShown: id === shown }];
  });
  return others.toSorted((a, b) => Number(b.isShown) - Number(a.isShown) || b.madeAgo - a.madeAgo);
}
