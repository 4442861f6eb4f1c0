/** The errors of checks. */
import { describeProblem, readValue } from "@corridor/protocol";

/** The host fails a check. */
export class Mismatch extends Error {
  override readonly name = "Mismatch";
  readonly expected: string;
  readonly found: string;

  constructor(expected: string, found: string) {
    super(`expected ${expected}, found ${found}`);
    this.expected = expected;
    this.found = found;
  }
}

/** The host does not answer, or not to this key: no other check can be tested. */
export class NoAccess extends Mismatch {}

/** A precondition of the check is missing, such as the robot's position in the pen. */
export class NotTestable extends Error {
  override readonly name = "NotTestable";
}

/** No script can test this during a run, at any host. It does not count against the host. */
export class NeverTestable extends Error {
  override readonly name = "NeverTestable";
}

/** @throws Mismatch unless the condition holds */
export function must(condition: boolean, expected: string, found: unknown): asserts condition {
  if (!condition) throw new Mismatch(expected, show(found));
}

/** Validates a value. @throws Mismatch */
export function validate<T>(
  schema: Parameters<typeof readValue<T>>[0],
  value: unknown,
  what: string,
): T {
  const result = readValue(schema, value);
  if (result.ok) return result.value;
  throw new Mismatch(`the shape of ${what}`, result.problems.map(describeProblem).join("; "));
}

/** The value at a path such as `pose.position.x`; undefined if there is none. */
export function valueAt(value: unknown, path: string): unknown {
  return path.split(".").reduce<unknown>((part, name) => {
    if (typeof part !== "object" || part === null) return undefined;
    return (part as Record<string, unknown>)[name];
  }, value);
}

/** @throws Mismatch unless there is a number at the path */
export function numberAt(value: unknown, path: string): number {
  const found = valueAt(value, path);
  must(typeof found === "number", `a number ${path}`, found ?? value);
  return found;
}

/** A found value as text of limited length. */
export function show(found: unknown): string {
  const text = typeof found === "string" ? found : (JSON.stringify(found) ?? String(found));
  return text.length > 300 ? `${text.slice(0, 300)}…` : text;
}

/** An error with its cause, such as that of a network. */
export function describeError(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const cause = error.cause instanceof Error ? ` (${error.cause.message})` : "";
  return `${error.message}${cause}`;
}
