/**
 * Finds environment variables that look like a misspelt setting. A misspelt ALLOWED_HOST would leave the service open
 * without a word. The environment also holds the variables of other programs, so only names count that resemble a
 * setting word by word.
 */
import type { FieldProblem } from "@corridor/protocol";
import leven from "leven";

/** Words with as many common first letters are forms of one word: PROXY and PROXIES, ALLOW and ALLOWED. */
const STEM = 3;

/**
 * @param names of all settings
 * @param given names of the environment's variables that have a value
 * @returns a problem for each misspelt name whose nearest setting is not given itself
 */
export function misspeltSettings(
  names: readonly string[],
  given: readonly string[],
): FieldProblem[] {
  const known = new Set(names);
  return given.flatMap((name) => {
    if (known.has(name)) return [];
    const nearest = names
      .filter((setting) => resembles(setting, name.toUpperCase()))
      .toSorted((a, b) => leven(a, name) - leven(b, name))[0];
    if (nearest === undefined || given.includes(nearest)) return [];
    return [{ path: name, found: "a name that is no setting", expected: nearest }];
  });
}

function resembles(setting: string, name: string): boolean {
  if (setting.replaceAll("_", "") === name.replaceAll("_", "")) return true;
  const words = setting.split("_");
  const others = name.split("_");
  // A name of one word, such as HOSTNAME, may be anything.
  if (words.length < 2 || words.length !== others.length) return false;
  return words.every((word, place) => isForm(word, others[place] ?? ""));
}

function isForm(word: string, other: string): boolean {
  if (word.slice(0, STEM) === other.slice(0, STEM)) return true;
  return leven(word, other) <= (Math.min(word.length, other.length) > 4 ? 2 : 1);
}
