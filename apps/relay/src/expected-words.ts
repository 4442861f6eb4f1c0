/**
 * Words for what a schema expects, where it does not say so itself: what zod says of it is for programmers. Set
 * here and not where schemas are read, because a page pays for each word that it loads.
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
    if (issue.code === "too_big") return `at most ${issue.maximum}${countedIn(issue.origin)}`;
    if (issue.code === "too_small") return `at least ${issue.minimum}${countedIn(issue.origin)}`;
    if (issue.code === "invalid_format") return "a text of another form";
    if (issue.code !== "invalid_value") return "something else";
    return issue.values.length === 1
      ? JSON.stringify(issue.values[0])
      : `one of ${issue.values.join(", ")}`;
  },
});

function countedIn(origin: string): string {
  return origin === "string" ? " characters" : origin === "array" ? " entries" : "";
}
