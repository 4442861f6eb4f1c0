/**
 * Reads the address of a class. The key is removed from the address at once, so that nobody can read
 * it on the screen. The first teacher's key of a class is stored on the device.
 */
import type { OwnClass, OwnClasses } from "./own-classes.ts";

export type ClassVisit =
  | { kind: "teach"; room: OwnClass }
  | { kind: "show"; id: string; key: string }
  /** the address has no key, and this device has none */
  | { kind: "broken" };

export interface ClassAddressPorts {
  location: Pick<Location, "pathname" | "search" | "hash">;
  classes: OwnClasses;
  /** sessionStorage, for the key of a big screen */
  tab: Pick<Storage, "getItem" | "setItem">;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
  /** ms since 1970 */
  now: () => number;
}

const SCREEN_KEY = "corridor.screen";
const PATH = /^\/class\/([A-Za-z0-9_-]{22})\/?$/;
const SCREEN = /^scr_[A-Za-z0-9_-]{22}$/;
/** The key of a teacher; a second device also gets the key of the big screens. */
const TEACHER = /^(tea_[A-Za-z0-9_-]{22})(?:\.(scr_[A-Za-z0-9_-]{22}))?$/;

/** Reads the address and removes the key from it. */
export function takeClassVisit(ports: ClassAddressPorts): ClassVisit {
  const { location, classes, tab, replaceAddress, now } = ports;
  const { pathname, search } = location;
  const given = location.hash.slice(1);
  if (given !== "") replaceAddress(pathname + search);
  const id = PATH.exec(pathname)?.[1];
  if (id === undefined || (given !== "" && !isKey(given))) return { kind: "broken" };
  const stored = classes.read(id);
  const [, key, screenKey = null] = TEACHER.exec(given) ?? [];
  if (key !== undefined) {
    const known = stored ?? { id, screenKey: null, label: "", startedAt: now(), notes: {} };
    const room = { ...known, key, screenKey: known.screenKey ?? screenKey };
    // A wrong link must not replace the right key. The dashboard stores another key that works.
    if (stored === null || stored.key === key) classes.store(room);
    return { kind: "teach", room };
  }
  if (given !== "") {
    storeScreen(tab, id, given);
    return { kind: "show", id, key: given };
  }
  const screen = storedScreen(tab, id);
  if (screen !== null) return { kind: "show", id, key: screen };
  return stored === null ? { kind: "broken" } : { kind: "teach", room: stored };
}

/** Whether the address has a key. @param hash of the address, with # */
export function hasClassKey(hash: string): boolean {
  return isKey(hash.slice(1));
}

function isKey(text: string): boolean {
  return TEACHER.test(text) || SCREEN.test(text);
}

/**
 * The address of the dashboard for a second device of the teacher. The teacher's key permits more
 * than the key of the big screens, so the second one adds no permission.
 */
export function secondDeviceAddress(
  origin: string,
  { id, key, screenKey }: Pick<OwnClass, "id" | "key" | "screenKey">,
): string {
  return classAddress(origin, id, screenKey === null ? key : `${key}.${screenKey}`);
}

/** The address of the dashboard or the big screen of a class, with its key. */
export function classAddress(origin: string, id: string, key: string): string {
  return `${origin}/class/${id}#${key}`;
}

/** In this tab only, so that a reload shows the big screen again. */
function storeScreen(tab: ClassAddressPorts["tab"], id: string, key: string): void {
  try {
    tab.setItem(SCREEN_KEY, `${id} ${key}`);
  } catch {
    // Without storage, a reload needs the whole link again.
  }
}

function storedScreen(tab: ClassAddressPorts["tab"], id: string): string | null {
  const [storedId, key = ""] = (tab.getItem(SCREEN_KEY) ?? "").split(" ");
  return storedId === id && SCREEN.test(key) ? key : null;
}
