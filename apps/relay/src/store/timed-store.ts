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

/**
 * Its methods are wrapped once: a store is asked thousands of times a second.
 * @param observe is told the seconds of each commit, also of one that failed
 */
export function timedStore<T extends SessionStore>(
  store: T,
  observe: (seconds: number) => void,
): T {
  const wrapped = new Map<string | symbol, unknown>();
  return new Proxy(store, {
    get(target, name) {
      const known = wrapped.get(name);
      if (known !== undefined) return known;
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      const bound = part.bind(target) as (...values: unknown[]) => Promise<unknown>;
      const method = COMMITS.has(name) ? timed(bound, observe) : bound;
      wrapped.set(name, method);
      return method;
    },
  });
}

function timed(
  commit: (...values: unknown[]) => Promise<unknown>,
  observe: (seconds: number) => void,
): typeof commit {
  return (...values) => {
    const begun = performance.now();
    const result = commit(...values);
    const done = (): void => observe((performance.now() - begun) / 1000);
    // Of what went wrong whoever asked is told.
    result.finally(done).catch(() => undefined);
    return result;
  };
}
