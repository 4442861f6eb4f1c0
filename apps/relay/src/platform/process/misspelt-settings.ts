/**
 * Finds environment variables that look like a misspelt setting. A misspelt ALLOWED_HOST would
 * leave the service open without a warning. The environment also holds variables of other programs,
 * so only names that resemble a setting word by word are reported.
 */
import type { FieldProblem } from "@corridor/protocol";
import leven from "leven";

/**
 * Words that share this many first letters count as one word: PROXY and PROXIES, ALLOW and ALLOWED.
 */
const STEM = 3;

/**
 * @param names all settings
 * @param given environment variables that have a value
 * @returns a problem for each misspelt name whose nearest setting is not set itself
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
    return [{ path: name, found: "an unknown setting", expected: nearest }];
  });
}

function resembles(setting: string, name: string): boolean {
  if (setting.replaceAll("_", "") === name.replaceAll("_", "")) return true;
  const words = setting.split("_");
  const others = name.split("_");
  // A single word, such as HOSTNAME, may belong to any program.
  if (words.length < 2 || words.length !== others.length) return false;
  return words.every((word, place) => isForm(word, others[place] ?? ""));
}

function isForm(word: string, other: string): boolean {
  if (word.slice(0, STEM) === other.slice(0, STEM)) return true;
  return leven(word, other) <= (Math.min(word.length, other.length) > 4 ? 2 : 1);
}
