/** Invalid documents for a short link, each with the field that the error must name. */
import { challenge, lesson, maze, program, project } from "../platform/testing/sample-documents.ts";

const text = (document: object, change: object): string =>
  JSON.stringify({ ...document, ...change });
/** The maze with a start of any JSON text. */
const startingAt = (start: string): string =>
  JSON.stringify(maze).replace(JSON.stringify(maze.start), start);

export const badDocuments: { name: string; body: string; path: string }[] = [
  { name: "an empty body", body: "", path: "" },
  { name: "text that is not JSON", body: "#####", path: "" },
  { name: "JSON that is cut off", body: JSON.stringify(maze).slice(0, -2), path: "" },
  { name: "null", body: "null", path: "" },
  { name: "a list of documents", body: JSON.stringify([maze]), path: "" },
  { name: "an empty object", body: "{}", path: "format" },
  { name: "a run", body: '{"format":"corridor/run","version":1}', path: "format" },
  { name: "a format from the prototype", body: text(maze, { format: "toString" }), path: "format" },
  { name: "a newer version", body: text(maze, { version: 2 }), path: "version" },
  { name: "a name too long", body: text(maze, { name: "x".repeat(101) }), path: "name" },
  { name: "rows of two lengths", body: text(maze, { blocks: ["#####", "#"] }), path: "blocks[1]" },
  {
    name: "a start outside",
    body: text(maze, { start: { column: 9, row: 1, heading: "east" } }),
    path: "start.column",
  },
  {
    name: "a start at NaN",
    body: startingAt('{"column":NaN,"row":1,"heading":"east"}'),
    path: "",
  },
  {
    name: "a start at an infinite number",
    body: startingAt('{"column":1e999,"row":1,"heading":"east"}'),
    path: "start.column",
  },
  {
    name: "a start at a huge whole number",
    body: startingAt('{"column":9007199254740993,"row":1,"heading":"east"}'),
    path: "start.column",
  },
  { name: "an unknown field", body: text(maze, { author: "me" }), path: "author" },
  {
    name: "a __proto__ field",
    body: JSON.stringify(maze).replace("{", '{"__proto__":{"a":1},'),
    path: "__proto__",
  },
  { name: "a constructor field", body: text(maze, { constructor: 1 }), path: "constructor" },
  {
    name: "a duplicate field",
    body: JSON.stringify(maze).replace("{", '{"name":"One",'),
    path: "",
  },
  {
    name: "an unknown action",
    body: text(program, { rules: [{ when: null, do: "fly" }] }),
    path: "rules[0].do",
  },
  {
    name: "a condition on a sensor that does not exist",
    body: text(program, {
      rules: [{ when: { sensor: "nose", is: ">", than: 1 }, do: "forward" }],
    }),
    path: "rules[0].when.sensor",
  },
  {
    name: "a challenge without a goal to reach",
    body: text(challenge, { mazes: [{ ...maze, goals: [] }] }),
    path: "mazes[0].goals",
  },
  { name: "a challenge of version 3", body: text(challenge, { version: 3 }), path: "version" },
  { name: "a lesson without a task", body: text(lesson, { tasks: [] }), path: "tasks" },
  {
    name: "a lesson whose second task allows an unknown tool",
    body: JSON.stringify(lesson).replace(/"speed"(?!.*"speed")/, '"chat"'),
    path: "tasks[1].allowed.tools[0]",
  },
  { name: "a project without a program", body: text(project, { program: null }), path: "program" },
  {
    name: "a project with a maze without a start",
    body: text(project, { maze: { ...maze, start: null } }),
    path: "maze.start",
  },
  {
    name: "deeply nested JSON",
    body: `${"[".repeat(30_000)}${"]".repeat(30_000)}`,
    path: "",
  },
  {
    name: "deep nesting inside a document",
    body: text(maze, { goals: "DEEP" }).replace(
      '"DEEP"',
      `${"[".repeat(20_000)}${"]".repeat(20_000)}`,
    ),
    path: "goals[0]",
  },
];
