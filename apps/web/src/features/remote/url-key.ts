/**
 * The robot's key for URLs. It is created when the user first copies a text that needs it, and
 * reused from then on, also after a reload: the service stores only its hash.
 */
import { storageOrNone, type KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { keyIdOf } from "./key-id.ts";
import { createUrlKey, type Ask } from "./owner-calls.ts";

const STORED = "corridor.remote.url-key";
const MAX_LENGTH = 512;

/** sessionStorage, which is not available in a frame. */
export const tabStorage = storageOrNone(() => sessionStorage);

type Robot = Pick<RemoteSession, "id" | "ownerKey">;

/** Requests without a response yet, by robot. */
const pending = new Map<string, Promise<string | null>>();

/** @param tab sessionStorage @returns null if the robot has none yet */
export function readUrlKey(tab: KeyValueStorage, robot: string): string | null {
  const text = tab.getItem(STORED) ?? "";
  const key = text.slice(robot.length + 1);
  return text.length <= MAX_LENGTH && key !== "" && text === `${robot} ${key}` ? key : null;
}

/** Returns the robot's key, or creates it. @returns null if the service created none */
export async function provideUrlKey(
  ask: Ask,
  tab: KeyValueStorage,
  robot: Robot,
): Promise<string | null> {
  const stored = readUrlKey(tab, robot.id);
  if (stored !== null) return stored;
  const running = pending.get(robot.id) ?? createUrlKey(ask, robot);
  pending.set(robot.id, running);
  const key = await running;
  pending.delete(robot.id);
  if (key !== null) store(tab, `${robot.id} ${key}`);
  return key;
}

/** Deletes the stored key after its owner revoked it. @param id of the revoked key */
export function dropUrlKey(tab: KeyValueStorage, id: string): void {
  const key = tab.getItem(STORED)?.split(" ")[1];
  if (key !== undefined && keyIdOf(key) === id) tab.removeItem(STORED);
}

function store(tab: KeyValueStorage, text: string): void {
  try {
    tab.setItem(STORED, text);
  } catch {
    // The storage is full: the next copy creates another key.
  }
}
