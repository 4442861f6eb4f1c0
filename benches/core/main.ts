/**
 * `npm run bench:core`: the whole headless loop (sensors, rules, motion, physics, snapshot) under the
 * right-wall program, beside a limit and two rivals. Prints a table and a line for each goal; exit code
 * 1 when one is missed. What each variant is: docs/performance.md.
 */
import { availableParallelism, cpus } from "node:os";
import { encodeLink } from "@corridor/link";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { digits, goalLine, isMet, type Goal } from "./goals.ts";
import { measureGrading } from "./grading.ts";
import { measureJudging } from "./judging.ts";
import { Limit } from "./limit.ts";
import { allocatedPerTick, measureRounds, median, timesSlower, type Timed } from "./measure.ts";
import { NaiveMatter } from "./naive-matter.ts";
import { Planck } from "./planck.ts";
import { Product } from "./product.ts";

const sides = [11, 33, 101, 255] as const;
const SEED = 1;
const ROUNDS = 41;
/** Short, so that one moment of the machine meets all variants of a round. */
const ROUND_MS = 25;
/** The naive world needs more time: a tick at 255 x 255 takes about 50 ms. */
const NAIVE_ROUND_MS = 100;
const ALLOCATION_TICKS = 200_000;
const LINKS = 100;

const variants = ["product", "limit", "limit unseen", "planck", "naive matter-js"] as const;
type Variant = (typeof variants)[number];
type Side = (typeof sides)[number];

const program = programPresets.find(({ id }) => id === "right-wall")?.program;
if (program === undefined) throw new Error("no right-wall program among the presets");

const products = sides.map((side) => new Product(tree(side, SEED), program));
const limits = sides.map((side) => new Limit(tree(side, SEED), program));
const plancks = sides.map((side) => new Planck(tree(side, SEED), program));
const naives = sides.map((side) => new NaiveMatter(tree(side, SEED), program));
const timed: Timed[] = [
  ...products.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: ROUND_MS })),
  ...limits.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: ROUND_MS })),
  ...limits.map((each) => ({ run: (ticks: number) => each.runUnseen(ticks), roundMs: ROUND_MS })),
  ...plancks.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: ROUND_MS })),
  ...naives.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: NAIVE_ROUND_MS })),
];
const times = measureRounds(timed, ROUNDS);
const timesOf = (variant: Variant, side: Side): number[] =>
  times[variants.indexOf(variant) * sides.length + sides.indexOf(side)] ?? [];
/** How many times as long a tick of one variant takes as one of another, in the same maze. */
const slower = (slow: Variant, fast: Variant, side: Side): number =>
  timesSlower(timesOf(slow, side), timesOf(fast, side));

printRow("cells a side", (side) => `${side}`);
console.log("\ntimes as slow as the limit, with and without a snapshot of each tick");
printRow("product", (side) => digits(slower("product", "limit", side)));
printRow("product, limit unseen", (side) => digits(slower("product", "limit unseen", side)));
console.log("\ntimes as fast as");
printRow("planck", (side) => digits(slower("planck", "product", side)));
printRow("naive matter-js", (side) => digits(slower("naive matter-js", "product", side)));
console.log("\nticks a second");
for (const variant of variants) {
  printRow(variant, (side) => digits(1e9 / median(timesOf(variant, side))));
}
const bytes = products.map((each) =>
  allocatedPerTick((ticks) => each.run(ticks), ALLOCATION_TICKS),
);
console.log("\nbytes allocated a tick, garbage included");
printRow("product", (side) => digits(bytes[sides.indexOf(side)] ?? Number.NaN));

const grading = measureGrading(program);
console.log(`\ngrade, 1,000 runs of 7,200 ticks at 33 x 33: ${digits(grading.seconds)} s`);
const judging = measureJudging();
console.log(
  `diagnosis of ${judging.runs} failed runs of a minute: median ${digits(judging.median)} ms, longest ${digits(judging.longest)} ms`,
);
console.log(`${ROUNDS} rounds; Node ${process.versions.node}, ${machine()}\n`);

const goals: Goal[] = [
  ...sides.map((side) => ({
    words: `a tick at ${side} against the limit`,
    measured: slower("product", "limit", side),
    bound: { atMost: 20 },
    unit: "times",
  })),
  {
    words: "a tick at 255 against one at 11",
    measured: timesSlower(timesOf("product", 255), timesOf("product", 11)),
    bound: { atMost: 1.2 },
    unit: "times",
  },
  {
    words: "naive matter-js at 33 against the product",
    measured: slower("naive matter-js", "product", 33),
    bound: { atLeast: 90 },
    unit: "times",
  },
  {
    words: "naive matter-js at 101 against the product",
    measured: slower("naive matter-js", "product", 101),
    bound: { atLeast: 2500 },
    unit: "times",
  },
  {
    words: "planck with rays at 33 against the product",
    measured: slower("planck", "product", 33),
    bound: { atLeast: 6 },
    unit: "times",
  },
  {
    words: "allocated a tick, the worst of the sizes",
    measured: Math.max(...bytes),
    bound: { atMost: 2048 },
    unit: "bytes",
  },
  {
    words: `the longest link of ${LINKS} mazes of 33 x 33`,
    measured: longestLink(),
    bound: { atMost: 200 },
    unit: "characters",
  },
  {
    words: `grade against its ticks at the single-core speed / ${grading.cores} cores`,
    measured: grading.timesIdeal,
    bound: { atMost: 1.3 },
    unit: "times",
  },
  {
    words: "the longest wait for a diagnosis after a run of a minute",
    measured: judging.longest,
    bound: { atMost: 50 },
    unit: "ms",
  },
];
for (const goal of goals) console.log(goalLine(goal));
if (!goals.every(isMet)) process.exitCode = 1;

function tree(side: number, seed: number): MazeDocument {
  return generateTree({ columns: side, rows: side, seed, name: `Tree ${seed}` });
}

function printRow(name: string, cell: (side: Side) => string): void {
  console.log(`  ${name.padEnd(24)}${sides.map((side) => cell(side).padStart(14)).join("")}`);
}

/** Characters; NaN when a maze has no link. */
function longestLink(): number {
  const lengths = Array.from({ length: LINKS }, (_, seed) => {
    const link = encodeLink({ maze: tree(33, seed) });
    return link.ok ? link.text.length : Number.NaN;
  });
  return Math.max(...lengths);
}

function machine(): string {
  const model = cpus()[0]?.model.trim() ?? "unknown processor";
  return `${availableParallelism()} cores, ${model}, ${process.platform}`;
}
