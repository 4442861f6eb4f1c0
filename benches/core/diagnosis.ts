/**
 * Measures how long the diagnosis of a failed run of one minute takes. The programs are all presets
 * with the action or number of one line changed, in trees of 11 x 11. As on the page, a diagnosis
 * simulates the run again and tries changes to the program.
 */
import { diagnoseFreePlay } from "@corridor/coach";
import { generateTree } from "@corridor/maze";
import { menuActions, programPresets, type ProgramDocument, type Rule } from "@corridor/program";
import { Simulation } from "@corridor/simulation";
import { median } from "./measure.ts";

const MAZES = 4;
const SIDE = 11;
const MINUTE_TICKS = 3600;
/** Failures from this tick on count as failures after one minute. */
const MIN_FAILURE_TICK = 3000;
const ROUNDS = 5;

export interface DiagnosisTimes {
  /** number of runs that failed after one minute */
  runs: number;
  /** milliseconds per diagnosis, median and maximum of all runs */
  median: number;
  longest: number;
}

export function measureDiagnosis(): DiagnosisTimes {
  const mutants = programPresets.flatMap(({ program }) => [...mutantsOf(program)]);
  const times: number[] = [];
  for (let seed = 1; seed <= MAZES; seed++) {
    const maze = generateTree({ columns: SIDE, rows: SIDE, seed, name: "" });
    const state = new Simulation(maze).save();
    for (const program of mutants) {
      const diagnose = () => diagnoseFreePlay({ maze, program, state }, MINUTE_TICKS);
      const first = diagnose();
      if (first === null || first.event.tick < MIN_FAILURE_TICK) continue;
      times.push(median(Array.from({ length: ROUNDS }, () => millisecondsOf(diagnose))));
    }
  }
  return { runs: times.length, median: median(times), longest: Math.max(...times) };
}

function* mutantsOf(program: ProgramDocument): Generator<ProgramDocument> {
  for (const [at, rule] of program.rules.entries()) {
    for (const mutant of mutateRule(rule))
      yield { ...program, rules: program.rules.with(at, mutant) };
  }
}

function* mutateRule(rule: Rule): Generator<Rule> {
  for (const action of menuActions) if (action !== rule.do) yield { ...rule, do: action };
  const { when } = rule;
  if (when === null || when.than === "right") return;
  for (const factor of [0.5, 2, 4]) yield { ...rule, when: { ...when, than: when.than * factor } };
}

function millisecondsOf(action: () => unknown): number {
  const start = performance.now();
  action();
  return performance.now() - start;
}
