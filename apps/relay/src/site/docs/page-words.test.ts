/** Names of buttons in the documentation are the labels on the page. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { problemKinds } from "../../platform/errors/problem-kinds.ts";

const WORDS = join(import.meta.dirname, "../../../../web/src/text/en");

/** All texts in a file of English texts. */
function textsIn(words: unknown): string[] {
  if (typeof words === "string") return [words];
  return typeof words === "object" && words !== null ? Object.values(words).flatMap(textsIn) : [];
}

const onPage = new Set(
  readdirSync(WORDS)
    .filter((file) => file.endsWith(".json"))
    .flatMap((file) => textsIn(JSON.parse(readFileSync(join(WORDS, file), "utf8")))),
);

const page = (name: string): string =>
  readFileSync(join(import.meta.dirname, `pages/${name}.md`), "utf8");

const library = (name: string): string =>
  readFileSync(join(import.meta.dirname, `../../../../../packages/${name}/README.md`), "utf8");

const guide = (name: string): string =>
  readFileSync(join(import.meta.dirname, `../../../../../docs/${name}.md`), "utf8");

it.each([
  { where: "the text of problems", text: JSON.stringify(problemKinds) },
  { where: "the text of the quickstart", text: page("quickstart") },
  { where: "the text of the recipes", text: page("recipes") },
  { where: "the text about the state of a robot", text: page("reading") },
  { where: "the text of the Python library", text: library("client-python") },
  { where: "the text of the TypeScript library", text: library("client") },
])("$where uses the labels of the page", ({ text }) => {
  const named = [...text.matchAll(/\*\*([^`*]+)\*\*/g)].map(([, words = ""]) => words);
  expect(named).toContain("Remote");
  expect(named.filter((words) => !onPage.has(words))).toEqual([]);
});

it.each(["teaching", "grading", "lms"])("the guide %s uses the labels of the page", (name) => {
  const named = [...guide(name).matchAll(/\*\*([^`*]+)\*\*/g)].map(([, words = ""]) =>
    words.replaceAll(/\s+/g, " "),
  );
  expect(named.length).toBeGreaterThan(0);
  expect(named.filter((words) => !onPage.has(words))).toEqual([]);
});
