/**
 * How long a failed run of one minute waits for its diagnosis: every preset program with one line's action or
 * number changed, in trees of 11 x 11. What the page does at a failure is timed: driving the run once more
 * and trying changes on it.
 */
import { diagnoseFreePlay } from "@corridor/coach";
import { generateTree } from "@corridor/maze";
import { menuActions, programPresets, type ProgramDocument, type Rule } from "@corridor/program";
import { Simulation } from "@corridor/simulation";
import { median } from "./measure.ts";

const MAZES = 4;
const SIDE = 11;
const MINUTE = 3600;
/** A failure from here on counts as one after a minute. */
const EARLIEST = 3000;
const ROUNDS = 5;

export interface JudgingTimes {
  /** runs that failed after a minute */
  runs: number;
  /** ms from the failure to its diagnosis: of all runs the median, and the longest */
  median: number;
  longest: number;
}

export function measureJudging(): JudgingTimes {
  const mistakes = programPresets.flatMap(({ program }) => [...oneChange(program)]);
  const times: number[] = [];
  for (let seed = 1; seed <= MAZES; seed++) {
    const maze = generateTree({ columns: SIDE, rows: SIDE, seed, name: "" });
    const state = new Simulation(maze).save();
    for (const program of mistakes) {
      const judge = () => diagnoseFreePlay({ maze, program, state }, MINUTE);
      const first = judge();
      if (first === null || first.event.tick < EARLIEST) continue;
      times.push(median(Array.from({ length: ROUNDS }, () => millisecondsOf(judge))));
    }
  }
  return { runs: times.length, median: median(times), longest: Math.max(...times) };
}

function* oneChange(program: ProgramDocument): Generator<ProgramDocument> {
  for (const [at, rule] of program.rules.entries()) {
    for (const change of changesOf(rule))
      yield { ...program, rules: program.rules.with(at, change) };
  }
}

function* changesOf(rule: Rule): Generator<Rule> {
  for (const action of menuActions) if (action !== rule.do) yield { ...rule, do: action };
  const { when } = rule;
  if (when === null || when.than === "right") return;
  for (const factor of [0.5, 2, 4]) yield { ...rule, when: { ...when, than: when.than * factor } };
}

function millisecondsOf(work: () => unknown): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}
