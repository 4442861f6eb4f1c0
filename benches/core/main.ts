/**
 * `npm run bench:core`: times the complete headless loop (sensors, rules, motion, physics,
 * snapshot) under the right-wall program, and compares it with a limit and two peers. Prints tables
 * and one line per goal; exits with code 1 if a goal is missed. docs/performance.md describes the
 * variants.
 */
import { availableParallelism, cpus } from "node:os";
import { encodeLink } from "@corridor/link";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { measureChecking } from "./checking.ts";
import { measureDiagnosis } from "./diagnosis.ts";
import { formatGoal, formatNumber, isMet, type Goal } from "./goals.ts";
import { measureGrading } from "./grading.ts";
import { Limit } from "./limit.ts";
import { allocatedPerTick, measureRounds, median, timesSlower, type Timed } from "./measure.ts";
import { NaiveMatter } from "./naive-matter.ts";
import { Planck } from "./planck.ts";
import { Product } from "./product.ts";

const sides = [11, 33, 101, 255] as const;
const SEED = 1;
const ROUNDS = 41;
/** Short, so that a slow period of the machine affects all variants of a round. */
const ROUND_MS = 25;
/** The naive world needs more time: a tick at 255 x 255 takes about 50 ms. */
const NAIVE_ROUND_MS = 100;
const ALLOCATION_TICKS = 200_000;
const LINKS = 100;

const variants = [
  "product",
  "limit",
  "limit without snapshots",
  "planck",
  "naive matter-js",
] as const;
type VariantName = (typeof variants)[number];
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
  ...limits.map((each) => ({
    run: (ticks: number) => each.runWithoutSnapshots(ticks),
    roundMs: ROUND_MS,
  })),
  ...plancks.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: ROUND_MS })),
  ...naives.map((each) => ({ run: (ticks: number) => each.run(ticks), roundMs: NAIVE_ROUND_MS })),
];
const times = measureRounds(timed, ROUNDS);
const timesOf = (variant: VariantName, side: Side): number[] =>
  times[variants.indexOf(variant) * sides.length + sides.indexOf(side)] ?? [];
/** The ratio of the times per tick of two variants in the same maze. */
const slower = (slow: VariantName, fast: VariantName, side: Side): number =>
  timesSlower(timesOf(slow, side), timesOf(fast, side));

printRow("cells per side", (side) => `${side}`);
console.log("\ntime per tick of the product, relative to");
printRow("limit", (side) => formatNumber(slower("product", "limit", side)));
printRow("limit without snapshots", (side) =>
  formatNumber(slower("product", "limit without snapshots", side)),
);
console.log("\ntime per tick, relative to the product");
printRow("planck", (side) => formatNumber(slower("planck", "product", side)));
printRow("naive matter-js", (side) => formatNumber(slower("naive matter-js", "product", side)));
console.log("\nticks per second");
for (const variant of variants) {
  printRow(variant, (side) => formatNumber(1e9 / median(timesOf(variant, side))));
}
const bytes = products.map((each) =>
  allocatedPerTick((ticks) => each.run(ticks), ALLOCATION_TICKS),
);
console.log("\nbytes allocated per tick, including garbage");
printRow("product", (side) => formatNumber(bytes[sides.indexOf(side)] ?? Number.NaN));

const grading = measureGrading(program);
console.log(
  `\ngrade, 1,000 runs of 7,200 ticks at 33 x 33: ${formatNumber(grading.runs.seconds)} s`,
);
console.log(
  `grade --challenge, 5 programs in 1,000 mazes of 11 x 11: ${formatNumber(grading.lesson.seconds)} s`,
);
const checking = measureChecking(program);
const diagnosis = measureDiagnosis();
console.log(
  `diagnosis of ${diagnosis.runs} failed runs of one minute: median ${formatNumber(diagnosis.median)} ms, longest ${formatNumber(diagnosis.longest)} ms`,
);
console.log(`${ROUNDS} rounds; Node ${process.versions.node}, ${machine()}\n`);

const goals: Goal[] = [
  ...sides.map((side) => ({
    label: `time per tick at ${side}, relative to the limit`,
    measured: slower("product", "limit", side),
    bound: { atMost: 20 },
    unit: "times",
  })),
  {
    label: "time per tick at 255, relative to 11",
    measured: timesSlower(timesOf("product", 255), timesOf("product", 11)),
    bound: { atMost: 1.2 },
    unit: "times",
  },
  {
    label: "naive matter-js at 33, relative to the product",
    measured: slower("naive matter-js", "product", 33),
    bound: { atLeast: 90 },
    unit: "times",
  },
  {
    label: "naive matter-js at 101, relative to the product",
    measured: slower("naive matter-js", "product", 101),
    bound: { atLeast: 2500 },
    unit: "times",
  },
  {
    label: "planck at 33, relative to the product",
    measured: slower("planck", "product", 33),
    bound: { atLeast: 6 },
    unit: "times",
  },
  {
    label: "allocated per tick, maximum of all sizes",
    measured: Math.max(...bytes),
    bound: { atMost: 2048 },
    unit: "bytes",
  },
  {
    label: `longest link of ${LINKS} mazes of 33 x 33`,
    measured: longestLink(),
    bound: { atMost: 200 },
    unit: "characters",
  },
  {
    label: `grade, relative to its ticks at single-core speed on ${grading.runs.cores} cores`,
    measured: grading.runs.timesIdeal,
    bound: { atMost: 1.3 },
    unit: "times",
  },
  {
    label: `grade --challenge in 1,000 unseen mazes, relative to its ticks on ${grading.lesson.cores} cores`,
    measured: grading.lesson.timesIdeal,
    bound: { atMost: 1.3 },
    unit: "times",
  },
  {
    label: "ticks of a check of a task, relative to raw ticks",
    measured: checking,
    bound: { atLeast: 0.85 },
    unit: "times",
  },
  {
    label: "longest diagnosis of a failed run of one minute",
    measured: diagnosis.longest,
    bound: { atMost: 50 },
    unit: "ms",
  },
];
for (const goal of goals) console.log(formatGoal(goal));
if (!goals.every(isMet)) process.exitCode = 1;

function tree(side: number, seed: number): MazeDocument {
  return generateTree({ columns: side, rows: side, seed, name: `Tree ${seed}` });
}

function printRow(name: string, cell: (side: Side) => string): void {
  console.log(`  ${name.padEnd(24)}${sides.map((side) => cell(side).padStart(14)).join("")}`);
}

/** The length of the longest link in characters; NaN if a maze cannot be encoded as a link. */
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
