/** In which words it is said that a robot's host does something else than it must. */
import { describeProblem, readValue } from "@corridor/protocol";

/** The host does something else than it must. */
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

/** The check needs something that is missing here, such as the robot's place in the pen. */
export class NotTestable extends Error {
  override readonly name = "NotTestable";
}

/** @throws Mismatch unless the condition holds */
export function must(condition: boolean, expected: string, found: unknown): asserts condition {
  if (!condition) throw new Mismatch(expected, show(found));
}

/** The value in the shape that it must have. */
export function shaped<T>(
  schema: Parameters<typeof readValue<T>>[0],
  value: unknown,
  what: string,
): T {
  const result = readValue(schema, value);
  if (result.ok) return result.value;
  throw new Mismatch(`the shape of ${what}`, result.problems.map(describeProblem).join("; "));
}

function show(found: unknown): string {
  const text = typeof found === "string" ? found : (JSON.stringify(found) ?? String(found));
  return text.length > 300 ? `${text.slice(0, 300)}…` : text;
}
