/**
 * Default texts for what a schema expects, in place of zod's texts for programmers. Set in the
 * relay and not in the shared reader, because each text would add to the size of the page.
 */
import { z } from "zod";

const types: Record<string, string> = {
  object: "an object",
  array: "a list",
  string: "a text",
  number: "a number",
  int: "a whole number",
  boolean: "true or false",
};

z.config({
  localeError: (issue) => {
    if (issue.code === "invalid_type") return types[issue.expected] ?? issue.expected;
    if (issue.code === "too_big") return `at most ${issue.maximum}${unitOf(issue.origin)}`;
    if (issue.code === "too_small") return `at least ${issue.minimum}${unitOf(issue.origin)}`;
    if (issue.code === "invalid_format") return "a text in another format";
    if (issue.code !== "invalid_value") return "another value";
    return issue.values.length === 1
      ? JSON.stringify(issue.values[0])
      : `one of ${issue.values.join(", ")}`;
  },
});

function unitOf(origin: string): string {
  return origin === "string" ? " characters" : origin === "array" ? " entries" : "";
}
