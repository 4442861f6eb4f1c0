/**
 * Invalid mazes, programs and links to test every reader: packages, command line, relay, page.
 * A reader must reject each with a problem at `path` whose "expected" contains `expected`.
 */
import type { LinkRefusal } from "../link.ts";
import { encodeLink } from "../link.ts";

export interface BrokenDocument {
  name: string;
  kind: "maze" | "program" | "link";
  text: string;
  /** path of the reported field; "" for the document itself, "link" for a link */
  path: string;
  /** part of the reported expectation */
  expected: string;
  /** for links only */
  code?: LinkRefusal;
}

/** Fields that replace those of a document; undefined removes a field. */
type Changes = Record<string, unknown>;

const goodMaze = {
  format: "corridor/maze",
  version: 1,
  name: "Good",
  blocks: ["#####", "#...#", "#####"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 1 }],
};
const goodRule = { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" };
const goodProgram = {
  format: "corridor/program",
  version: 1,
  name: "Good",
  default: "forward",
  rules: [goodRule],
};

const mazeText = (changes: Changes): string => JSON.stringify({ ...goodMaze, ...changes });
const programText = (changes: Changes): string => JSON.stringify({ ...goodProgram, ...changes });
const ruleText = (changes: Changes): string =>
  programText({ rules: [goodRule, { ...goodRule, ...changes }] });
const whenText = (changes: Changes): string =>
  programText({ rules: [{ ...goodRule, when: { ...goodRule.when, ...changes } }] });
const openRows = (columns: number, rows: number): string[] =>
  Array.from({ length: rows }, () => ".".repeat(columns));
const nested = (depth: number): string => "[".repeat(depth) + "]".repeat(depth);

type Row = readonly [name: string, text: string, path: string, expected: string];

const mazes: readonly Row[] = [
  ["an empty text", "", "", "a JSON document"],
  ["only spaces", "   ", "", "a JSON document"],
  ["truncated JSON", mazeText({}).slice(0, -5), "", "a JSON document"],
  ["text after the document", `${mazeText({})} #`, "", "a JSON document"],
  ["two documents", mazeText({}) + mazeText({}), "", "a JSON document"],
  ["a byte order mark", `\u{feff}${mazeText({})}`, "", "a JSON document"],
  ["a comment", `// a maze\n${mazeText({})}`, "", "a JSON document"],
  ["single quotes", mazeText({}).replaceAll('"', "'"), "", "a JSON document"],
  ["a raw line break in a name", mazeText({}).replace("Good", "Go\nod"), "", "a JSON document"],
  ["a huge text", mazeText({ name: "x".repeat(300_000) }), "", "at most 262144 characters"],
  ["a text nested 100,000 deep", nested(100_000), "", "a maze"],
  ["null", "null", "", "a maze"],
  ["a list", "[]", "", "a maze"],
  ["a number", "12", "", "a maze"],
  ["a text in quotes", '"#.#"', "", "a maze"],
  ["an empty object", "{}", "format", '"corridor/maze"'],
  ["a program in place of a maze", programText({}), "format", '"corridor/maze"'],
  ["another format", mazeText({ format: "corridor/labyrinth" }), "format", '"corridor/maze"'],
  ["no format", mazeText({ format: undefined }), "format", '"corridor/maze"'],
  ["version 2", mazeText({ version: 2 }), "version", "version 1"],
  ["version 0", mazeText({ version: 0 }), "version", "version 1"],
  ["a version in quotes", mazeText({ version: "1" }), "version", "version 1"],
  ["no version", mazeText({ version: undefined }), "version", "version 1"],
  ["no name", mazeText({ name: undefined }), "name", "a name"],
  ["a number as name", mazeText({ name: 7 }), "name", "a name"],
  ["a name of 101 characters", mazeText({ name: "x".repeat(101) }), "name", "at most 100"],
  ["an unknown field", mazeText({ author: "me" }), "author", "no field of this name"],
  ["the field constructor", mazeText({ constructor: {} }), "constructor", "no field of this name"],
  [
    "the field __proto__",
    mazeText({}).replace('"name"', '"__proto__":{"name":"x"},"name"'),
    "__proto__",
    "no field of this name",
  ],
  ["no blocks", mazeText({ blocks: undefined }), "blocks", "rows"],
  ["blocks null", mazeText({ blocks: null }), "blocks", "rows"],
  ["blocks as one text", mazeText({ blocks: "#.#" }), "blocks", "rows"],
  ["blocks as an object", mazeText({ blocks: { 0: "..." } }), "blocks", "rows"],
  ["0 rows", mazeText({ blocks: [] }), "blocks", "1 to 256 rows"],
  ["0 columns", mazeText({ blocks: [""] }), "blocks[0]", "1 to 256 characters"],
  ["257 rows", mazeText({ blocks: openRows(5, 257) }), "blocks", "1 to 256 rows"],
  ["257 columns", mazeText({ blocks: openRows(257, 3) }), "blocks[0]", "1 to 256 characters"],
  ["a short row", mazeText({ blocks: ["#####", "#..", "#####"] }), "blocks[1]", "5 characters"],
  ["a long row", mazeText({ blocks: ["#####", "#...##", "#####"] }), "blocks[1]", "5 characters"],
  ["a list as row", mazeText({ blocks: ["#####", [], "#####"] }), "blocks[1]", "a row"],
  ["a null row", mazeText({ blocks: ["#####", null, "#####"] }), "blocks[1]", "a row"],
  ["another mark", mazeText({ blocks: ["#####", "#.x.#", "#####"] }), "blocks[1]", "# for a block"],
  [
    "a line break in a row",
    mazeText({ blocks: ["#####", "#...\n"] }),
    "blocks[1]",
    "# for a block",
  ],
  ["a zero byte in a row", mazeText({ blocks: ["#####", "#..\0#"] }), "blocks[1]", "# for a block"],
  ["no start", mazeText({ start: undefined }), "start", "a start"],
  ["a null start", mazeText({ start: null }), "start", "a start"],
  ["a list as start", mazeText({ start: [1, 1, "east"] }), "start", "a start"],
  [
    "a deeply nested start",
    mazeText({}).replace(JSON.stringify(goodMaze.start), nested(20_000)),
    "start",
    "a start",
  ],
  [
    "a start on a block",
    mazeText({ start: { column: 0, row: 0, heading: "east" } }),
    "start",
    "an open cell",
  ],
  [
    "a start right of the maze",
    mazeText({ start: { column: 5, row: 1, heading: "east" } }),
    "start.column",
    "inside the maze",
  ],
  [
    "a start below the maze",
    mazeText({ start: { column: 1, row: 3, heading: "east" } }),
    "start.row",
    "inside the maze",
  ],
  [
    "a start at a negative column",
    mazeText({ start: { column: -1, row: 1, heading: "east" } }),
    "start.column",
    "a whole number from 0",
  ],
  [
    "a start between cells",
    mazeText({ start: { column: 1.5, row: 1, heading: "east" } }),
    "start.column",
    "a whole number",
  ],
  [
    "a start without a row",
    mazeText({ start: { column: 1, heading: "east" } }),
    "start.row",
    "0 to",
  ],
  [
    "a start with another field",
    mazeText({ start: { ...goodMaze.start, speed: 3 } }),
    "start.speed",
    "no field of this name",
  ],
  [
    "a heading in degrees",
    mazeText({ start: { column: 1, row: 1, heading: 90 } }),
    "start.heading",
    "one of north, east, south, west",
  ],
  [
    "a heading in capitals",
    mazeText({ start: { column: 1, row: 1, heading: "East" } }),
    "start.heading",
    "one of north, east, south, west",
  ],
  [
    "the column 1e999",
    mazeText({}).replace('"column":1', '"column":1e999'),
    "start.column",
    "0 to",
  ],
  ["the column NaN", mazeText({}).replace('"column":1', '"column":NaN'), "", "a JSON document"],
  [
    "the column Infinity",
    mazeText({}).replace('"column":1', '"column":Infinity'),
    "",
    "a JSON document",
  ],
  ["no goals", mazeText({ goals: undefined }), "goals", "a list of cells"],
  ["goals null", mazeText({ goals: null }), "goals", "a list of cells"],
  [
    "one goal without a list",
    mazeText({ goals: { column: 3, row: 1 } }),
    "goals",
    "a list of cells",
  ],
  ["257 goals", mazeText({ goals: Array(257).fill(goodMaze.goals[0]) }), "goals", "at most 256"],
  ["a null goal", mazeText({ goals: [null] }), "goals[0]", "a cell"],
  ["a goal on a block", mazeText({ goals: [{ column: 4, row: 1 }] }), "goals[0]", "an open cell"],
  [
    "the second goal outside",
    mazeText({ goals: [goodMaze.goals[0], { column: 3, row: 9 }] }),
    "goals[1].row",
    "inside the maze",
  ],
  [
    "a goal with a heading",
    mazeText({ goals: [{ column: 3, row: 1, heading: "east" }] }),
    "goals[0].heading",
    "no field of this name",
  ],
  [
    "a goal in quotes",
    mazeText({ goals: [{ column: "3", row: 1 }] }),
    "goals[0].column",
    "a whole",
  ],
];

const programs: readonly Row[] = [
  ["an empty text", "", "", "a JSON document"],
  ["truncated JSON", programText({}).slice(0, 40), "", "a JSON document"],
  ["a byte order mark", `\u{feff}${programText({})}`, "", "a JSON document"],
  ["a huge text", programText({ name: "x".repeat(70_000) }), "", "at most 65536 characters"],
  ["a text nested 30,000 deep", nested(30_000), "", "a program"],
  ["null", "null", "", "a program"],
  ["a maze in place of a program", mazeText({}), "format", '"corridor/program"'],
  ["version 2", programText({ version: 2 }), "version", "version 1"],
  ["no name", programText({ name: undefined }), "name", "a name"],
  ["a name of 101 characters", programText({ name: "x".repeat(101) }), "name", "at most 100"],
  ["an unknown field", programText({ speed: 2 }), "speed", "no field of this name"],
  [
    "the field __proto__",
    programText({}).replace('"name"', '"__proto__":{"default":"stop"},"name"'),
    "__proto__",
    "no field of this name",
  ],
  ["no default", programText({ default: undefined }), "default", "one of forward"],
  ["a null default", programText({ default: null }), "default", "one of forward"],
  ["an unknown default", programText({ default: "fly" }), "default", "one of forward"],
  ["no rules", programText({ rules: undefined }), "rules", "a list of rules"],
  ["rules as an object", programText({ rules: {} }), "rules", "a list of rules"],
  ["201 rules", programText({ rules: Array(201).fill(goodRule) }), "rules", "at most 200 rules"],
  ["a null rule", programText({ rules: [null] }), "rules[0]", "a rule"],
  ["a text as rule", programText({ rules: ["forward"] }), "rules[0]", "a rule"],
  [
    "a rule with another field",
    ruleText({ else: "stop" }),
    "rules[1].else",
    "no field of this name",
  ],
  ["a rule without an action", ruleText({ do: undefined }), "rules[1].do", "one of forward"],
  ["an unknown action", ruleText({ do: "fly" }), "rules[1].do", "one of forward"],
  ["an action for remotes only", ruleText({ do: "move" }), "rules[1].do", "one of forward"],
  ["the action toString", ruleText({ do: "toString" }), "rules[1].do", "one of forward"],
  ["an action in capitals", ruleText({ do: "Left 90" }), "rules[1].do", "one of forward"],
  ["a rule without a condition", ruleText({ when: undefined }), "rules[1].when", "a condition"],
  ["a text as condition", ruleText({ when: "right > 60" }), "rules[1].when", "a condition"],
  ["a list as condition", ruleText({ when: ["right", ">", 60] }), "rules[1].when", "a condition"],
  ["an unknown sensor", whenText({ sensor: "up" }), "rules[0].when.sensor", "one of front"],
  [
    "a sensor of the thesis",
    whenText({ sensor: "forward" }),
    "rules[0].when.sensor",
    "one of front",
  ],
  ["no sensor", whenText({ sensor: undefined }), "rules[0].when.sensor", "one of front"],
  ["an unknown comparator", whenText({ is: ">=" }), "rules[0].when.is", 'one of ">", "<"'],
  ["no comparator", whenText({ is: undefined }), "rules[0].when.is", 'one of ">", "<"'],
  ["a negative number", whenText({ than: -1 }), "rules[0].when.than", "0 to 100000"],
  ["a number above 100000", whenText({ than: 100_001 }), "rules[0].when.than", "0 to 100000"],
  ["a number in quotes", whenText({ than: "60" }), "rules[0].when.than", "a number"],
  ["a null number", whenText({ than: null }), "rules[0].when.than", "a number"],
  ["no number", whenText({ than: undefined }), "rules[0].when.than", "a number"],
  ["the number 1e999", programText({}).replace("60", "1e999"), "rules[0].when.than", "a number"],
  ["the number NaN", programText({}).replace("60", "NaN"), "", "a JSON document"],
  [
    "left compared with back",
    whenText({ sensor: "left", than: "back" }),
    "rules[0].when.than",
    "a number",
  ],
  [
    "front compared with right",
    whenText({ sensor: "front", than: "right", plus: 1 }),
    "rules[0].when.sensor",
    '"left"',
  ],
  [
    "left compared with right without plus",
    whenText({ sensor: "left", than: "right" }),
    "rules[0].when.plus",
    "-100000 to 100000",
  ],
  [
    "plus above 100000",
    whenText({ sensor: "left", than: "right", plus: 100_001 }),
    "rules[0].when.plus",
    "-100000 to 100000",
  ],
  [
    "plus below -100000",
    whenText({ sensor: "left", than: "right", plus: -100_001 }),
    "rules[0].when.plus",
    "-100000 to 100000",
  ],
  [
    "plus together with a number",
    whenText({ sensor: "left", than: 60, plus: 1 }),
    "rules[0].when.plus",
    "no field of this name",
  ],
];

/** The link from which the broken ones below are derived. */
function goodLink(): string {
  const link = encodeLink({
    maze: {
      format: "corridor/maze",
      version: 1,
      name: "A good maze, long enough to be damaged",
      blocks: ["...#.....#.", ".#.#.#.#.#.", ".#...#...#.", ".#####.#.#."],
      start: { column: 0, row: 3, heading: "north" },
      goals: [{ column: 10, row: 0 }],
    },
  });
  if (!link.ok) throw new Error("the valid maze has no link");
  return link.text;
}

const link = goodLink();

function swapped(at: number): string {
  return (
    link.slice(0, at) + link.slice(at + 1, at + 2) + link.slice(at, at + 1) + link.slice(at + 2)
  );
}

type LinkRow = readonly [name: string, text: string, code: LinkRefusal, expected: string];

const links: readonly LinkRow[] = [
  ["nothing after the #", "", "empty", "a link"],
  ["the version alone", "1", "cut-off", "more than 6"],
  ["the header alone", link.slice(0, 6), "cut-off", "more than 6"],
  ["a link without its last character", link.slice(0, -1), "cut-off", "to its last character"],
  ["half a link", link.slice(0, link.length / 2), "cut-off", "to its last character"],
  ["a link without its first character", link.slice(1), "unknown-version", "begins with 1"],
  ["a link with an extra character", `${link}A`, "damaged", "copy it again"],
  ["a link twice", link + link, "cut-off", "copy it again"],
  ["two characters swapped in the checksum", swapped(2), "damaged", "copy it again"],
  ["two characters swapped in the blocks", swapped(10), "damaged", "copy it again"],
  ["a link in lower case", link.toLowerCase(), "damaged", "copy it again"],
  ["a link from version 9", `9${link.slice(1)}`, "unknown-version", "begins with 1"],
  ["an element id of the page", "main", "unknown-version", "begins with 1"],
  ["a link with a space", `${link.slice(0, 12)} ${link.slice(12)}`, "damaged", "letters, digits"],
  ["a space before a link", ` ${link}`, "unknown-version", "begins with 1"],
  ["a line break after a link", `${link}\n`, "damaged", "letters, digits"],
  ["a full stop after a link", `${link}.`, "damaged", "letters, digits"],
  [
    "a percent-encoded link",
    `${link.slice(0, 9)}%2D${link.slice(10)}`,
    "damaged",
    "letters, digits",
  ],
  ["a link with an emoji", `${link.slice(0, 9)}🤖${link.slice(9)}`, "damaged", "letters, digits"],
  ["a link with its #", `#${link}`, "unknown-version", "begins with 1"],
  ["a maze document as link", mazeText({}), "damaged", "letters, digits"],
  ["a link over 8192 characters", link + "A".repeat(8_192), "too-long", "at most 8192"],
  ["a million characters", "1".repeat(1_000_000), "too-long", "at most 8192"],
  ["ones only", "1".repeat(59), "damaged", "copy it again"],
];

function document(kind: "maze" | "program"): (row: Row) => BrokenDocument {
  return ([name, text, path, expected]) => ({ name, kind, text, path, expected });
}

/** All broken documents: mazes, then programs, then links. */
export const brokenDocuments: readonly BrokenDocument[] = [
  ...mazes.map(document("maze")),
  ...programs.map(document("program")),
  ...links.map(([name, text, code, expected]): BrokenDocument => ({
    name,
    kind: "link",
    text,
    path: "link",
    expected,
    code,
  })),
];
