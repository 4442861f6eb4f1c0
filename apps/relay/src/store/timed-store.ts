/** Measures the commits of a store, for any database. */
import type { RobotStore } from "./robot-store.ts";

/** Every step that ends in a commit. */
const COMMITS: ReadonlySet<string | symbol> = new Set([
  "create",
  "commit",
  "storeMaze",
  "touch",
  "remove",
  "removeExpired",
] as const satisfies readonly (keyof RobotStore)[]);

/**
 * Wraps each method once, because a store receives thousands of calls a second.
 * @param observe receives the seconds of each commit, including failed ones
 */
export function timedStore<T extends RobotStore>(store: T, observe: (seconds: number) => void): T {
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
    // The caller receives the error.
    result.finally(done).catch(() => undefined);
    return result;
  };
}
