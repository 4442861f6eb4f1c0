/**
 * Reads the address of a robot, which is for a viewer if it contains a watch key. The key is
 * removed from the address at once and stored for this tab, so that a reload continues to watch.
 */
import { keyPrefixes } from "@corridor/protocol";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import type { WatchedRobot } from "../../simulator/protocol/watch-messages.ts";

export type Visit =
  | { kind: "watch"; robot: WatchedRobot }
  /** the address is for a script */
  | { kind: "script" }
  /** a part of the address is missing */
  | { kind: "broken" };

export interface WatchAddressPorts {
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
}

const STORAGE_KEY = "corridor.watch";
const PATH = /^\/r\/([A-Za-z0-9_-]{22})\/?$/;
const WATCH_KEY = new RegExp(`^${keyPrefixes.watch}[A-Za-z0-9_-]{22}$`);

/** Reads the address and removes the key from it. */
export function takeVisit({ location, tab, replaceAddress }: WatchAddressPorts): Visit {
  const { pathname, search } = location;
  const key = location.hash.slice(1);
  // First of all, so that nobody can read the key on the screen.
  if (key !== "") replaceAddress(pathname + search);
  const id = PATH.exec(pathname)?.[1];
  if (id === undefined) return { kind: "broken" };
  if (key.startsWith(keyPrefixes.drive)) return { kind: "script" };
  const robot = { id, key: key === "" ? storedKey(tab, id) : key };
  if (!WATCH_KEY.test(robot.key)) return { kind: "broken" };
  store(tab, robot);
  return { kind: "watch", robot };
}

function storedKey(tab: KeyValueStorage, id: string): string {
  const [storedId, key = ""] = (tab.getItem(STORAGE_KEY) ?? "").split(" ");
  return storedId === id ? key : "";
}

function store(tab: KeyValueStorage, { id, key }: WatchedRobot): void {
  try {
    tab.setItem(STORAGE_KEY, `${id} ${key}`);
  } catch {
    // Without storage, a reload needs the whole link again.
  }
}
