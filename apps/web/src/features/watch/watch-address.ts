/**
 * What somebody wants who opens a robot's address: to look on, where it ends in a watch key. A key is
 * taken out of the address at once and kept in this tab, so that a reload goes on looking.
 */
import type { KeyValueStorage } from "../../app/project-storage.ts";
import type { WatchedRobot } from "../../worker/watch-messages.ts";

export type Visit =
  | { kind: "watch"; robot: WatchedRobot }
  /** the address is for a script */
  | { kind: "script" }
  /** a part of it is missing */
  | { kind: "broken" };

export interface WatchAddressPorts {
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** sessionStorage */
  tab: KeyValueStorage;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
}

const KEPT = "corridor.watch";
const PATH = /^\/r\/([A-Za-z0-9_-]{22})\/?$/;
const WATCH_KEY = /^wch_[A-Za-z0-9_-]{22}$/;

/** Reads the address and takes the key out of it. */
export function takeVisit({ location, tab, replaceAddress }: WatchAddressPorts): Visit {
  const { pathname, search } = location;
  const key = location.hash.slice(1);
  // First of all: from here on nobody reads the key over the reader's shoulder.
  if (key !== "") replaceAddress(pathname + search);
  const id = PATH.exec(pathname)?.[1];
  if (id === undefined) return { kind: "broken" };
  if (key.startsWith("drv_")) return { kind: "script" };
  const robot = { id, key: key === "" ? keptKey(tab, id) : key };
  if (!WATCH_KEY.test(robot.key)) return { kind: "broken" };
  keep(tab, robot);
  return { kind: "watch", robot };
}

function keptKey(tab: KeyValueStorage, id: string): string {
  const [keptId, key = ""] = (tab.getItem(KEPT) ?? "").split(" ");
  return keptId === id ? key : "";
}

function keep(tab: KeyValueStorage, { id, key }: WatchedRobot): void {
  try {
    tab.setItem(KEPT, `${id} ${key}`);
  } catch {
    // A reload then asks for the whole link again.
  }
}
