/** Text entries on the device or in the tab: localStorage and sessionStorage. */

/** The part of the browser's Storage that is used. Any call may throw: full, forbidden. */
export type KeyValueStorage = Pick<
  Storage,
  "length" | "key" | "getItem" | "setItem" | "removeItem"
>;

/** All keys that start with `prefix`, in no particular order. */
export function keysUnder(storage: KeyValueStorage, prefix: string): string[] {
  const keys = Array.from({ length: storage.length }, (_, index) => storage.key(index));
  return keys.flatMap((key) => (key?.startsWith(prefix) === true ? [key] : []));
}

/**
 * The browser's storage or, if it is forbidden, an empty one that refuses writes.
 * @param open reads `localStorage` or `sessionStorage`, which may throw
 */
export function storageOrNone(open: () => KeyValueStorage): KeyValueStorage {
  try {
    return open();
  } catch (error) {
    return {
      length: 0,
      key: () => null,
      getItem: () => null,
      setItem: () => {
        throw error;
      },
      removeItem: () => undefined,
    };
  }
}
