/** A store whose commits are timed, whichever database is behind it. */
import type { SessionStore } from "./session-store.ts";

/** Every step that ends in a commit. */
const COMMITS: ReadonlySet<string | symbol> = new Set([
  "create",
  "changeKeys",
  "changeAway",
  "pause",
  "keepMaze",
  "touch",
  "remove",
  "removeExpired",
  "add",
  "deliver",
  "start",
  "end",
  "expire",
  "cancel",
  "abandon",
  "takeOver",
] as const satisfies readonly (keyof SessionStore)[]);

/** @param observe is told the seconds of each commit, also of one that failed */
export function timedStore<T extends SessionStore>(
  store: T,
  observe: (seconds: number) => void,
): T {
  return new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      if (!COMMITS.has(name)) return part.bind(target) as unknown;
      return async (...values: unknown[]): Promise<unknown> => {
        const begun = performance.now();
        try {
          return await (Reflect.apply(part, target, values) as Promise<unknown>);
        } finally {
          observe((performance.now() - begun) / 1000);
        }
      };
    },
  });
}
