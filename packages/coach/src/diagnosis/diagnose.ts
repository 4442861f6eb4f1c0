/**
 * Diagnoses a failed run. Names a cause only if a simulated change of one thing removed the
 * failure; otherwise the diagnosis contains only the event.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { Command, LineRef, Pose } from "@corridor/protocol";
import {
  ProgramRun,
  ROBOT_RADIUS,
  Simulation,
  contactOf,
  type BumpCause,
} from "@corridor/simulation";
import type { Fix } from "../advice.ts";
import { applyFix } from "../apply-fix.ts";
import type { LoopNotice } from "../loop-detector.ts";
import { candidates, isTurn } from "./candidates.ts";
import { causeOf } from "./cause-of.ts";
import type {
  BumpEvent,
  BumpPhase,
  Cause,
  Diagnosis,
  FailureEvent,
  StuckEvent,
} from "./diagnosis.ts";
import { isGuess, isShownByRun, isWrongAnyway, type Found } from "./evidence.ts";
import { isLeftOut, ranked } from "./rank.ts";
import { RunTrace, type SolvedCheck, type TraceStart } from "./run-trace.ts";
import { tryProgram, type TrialResult, type TrialTask } from "./trial.ts";

/**
 * Maximum number of simulated ticks of all trials, and of a run from the start: a limit of time
 * that is deterministic.
 */
const MAX_TRIAL_TICKS = 60_000;
/** In a task, the diagnosis stops after this many changes that solve the maze. */
const MAX_WHOLE_TRIALS = 4;
const MAX_FIXES = 2;
/** In free play, the diagnosis stops after this many changes that help. */
const MAX_GUESSES = 4;
/** Decisions of a line that are tried as the first changed one. */
const MAX_MOMENTS = 3;
/** In free play, the diagnosis starts this many ticks before the failure. */
export const FREE_PLAY_PAST = 3600;
/** In free play, a changed program must reach the goal within this many ticks after the failure. */
const FREE_PLAY_FUTURE = 3600;

/** The task of the run, and the permitted changes. */
export interface DiagnosisTask {
  /** the last tick of a whole run */
  until: number;
  /** more bumps than this are a failure; null: bumps are permitted */
  bumps: number | null;
  /** null if there is no task, or the stretch does not begin at the start */
  newSolvedCheck: (() => SolvedCheck) | null;
  /** whether the student may write this program */
  allows: (program: ProgramDocument) => boolean;
  /**
   * whether a program solves every maze of the task; null in free play, where getting past the
   * failure is as good as reaching the goal
   */
  solvesAll: ((program: ProgramDocument) => boolean) | null;
  /** number of mazes of the task */
  mazes: number;
}

/**
 * Free play: reach the goal, if there is one, without a bump.
 * @param failedAt tick of the failure
 */
export function freePlayTask({ goals }: MazeDocument, failedAt: number): DiagnosisTask {
  return {
    until: failedAt + FREE_PLAY_FUTURE,
    bumps: 0,
    newSolvedCheck: goals.length > 0 ? () => (robot) => robot.goalTick !== null : null,
    allows: () => true,
    solvesAll: null,
    mazes: 1,
  };
}

/** Runs a program from a state, and diagnoses its failure. @returns null if it does not fail */
export function diagnoseProgram(start: TraceStart, task: DiagnosisTask): Diagnosis | null {
  const { until, bumps, newSolvedCheck } = task;
  const isSolved = newSolvedCheck?.() ?? null;
  const trace = new RunTrace(start, { until, bumps, isSolved });
  if (trace.end === "solved") return null;
  if (trace.end === "late" && newSolvedCheck === null) return null;
  return diagnose(trace, task);
}

/**
 * Runs a program in free play as the page does: the run fails at a bump, or when a lack of progress
 * is detected, or else at the end of the time.
 * @param until the last tick of the run
 */
export function diagnoseFreePlay(start: TraceStart, until: number): Diagnosis | null {
  const { maze, program } = start;
  const task = freePlayTask(maze, until);
  const isSolved = task.newSolvedCheck?.() ?? null;
  const trace = new RunTrace(start, { until, bumps: 0, isSolved });
  if (trace.end === "solved") return null;
  const failure = trace.end === "bump" ? "bump" : trace.notice;
  if (failure === null) return isSolved === null ? null : diagnose(trace, { ...task, until });
  const tick = failure === "bump" ? trace.until : failure.tick;
  const state = trace.stateFrom(tick - FREE_PLAY_PAST);
  return diagnoseStretch({ maze, program, state }, freePlayTask(maze, tick), tick, failure);
}

/**
 * Diagnoses a run that failed at `until`: by a bump, at the end of the time, or without progress.
 * @param bumpsBefore number of bumps before the failure, after which the robot drove on
 * @returns null if the stretch has no such failure, or the robot reached the goal nevertheless
 */
export function diagnoseStretch(
  start: TraceStart,
  task: DiagnosisTask,
  until: number,
  failure: "bump" | "late" | LoopNotice,
  bumpsBefore: number = start.state.physics.bumps,
): Diagnosis | null {
  const bumps = failure === "bump" ? Math.max(task.bumps ?? 0, bumpsBefore) : null;
  const trace = new RunTrace(start, { until, bumps, isSolved: null });
  if (failure === "bump" && trace.end !== "bump") return null;
  if (solvesFromStart(trace, task)) {
    const event = typeof failure === "string" ? eventOf(trace) : { ...failure, tick: until };
    return { event, cause: null, fixes: [], solvesFromStart: true };
  }
  if (typeof failure === "string") return diagnose(trace, task);
  if (isSolvedLater(trace, task)) return null;
  return diagnose(trace, task, { ...failure, tick: until });
}

/**
 * Whether a run in free play would not have failed if the program had driven from the start: then
 * no line of the program is the cause.
 */
function solvesFromStart(trace: RunTrace, { newSolvedCheck, solvesAll }: DiagnosisTask): boolean {
  if (trace.from === 0 || newSolvedCheck === null || solvesAll !== null) return false;
  const simulation = new Simulation(trace.maze);
  const run = new ProgramRun(simulation, new CompiledProgram(trace.program));
  const isSolved = newSolvedCheck();
  while (simulation.tick < MAX_TRIAL_TICKS && simulation.bumps === 0) {
    run.step();
    if (isSolved(simulation)) return simulation.bumps === 0;
  }
  return false;
}

/** Whether the unchanged program solves the task later, so that the notice was wrong. */
function isSolvedLater(
  { maze, program, last }: RunTrace,
  { until, bumps, newSolvedCheck }: DiagnosisTask,
): boolean {
  if (newSolvedCheck === null) return false;
  const start = { maze, program, state: last.save() };
  const allowed = bumps === null ? null : Math.max(bumps, last.bumps);
  return (
    new RunTrace(start, { until, bumps: allowed, isSolved: newSolvedCheck() }).end === "solved"
  );
}

function diagnose(trace: RunTrace, task: DiagnosisTask, stuck?: StuckEvent): Diagnosis {
  const event = stuck ?? eventOf(trace);
  return { event, ...explain(trace, event, task) };
}

function eventOf({ bump, maze, last, until, decisions }: RunTrace): FailureEvent {
  if (bump === null) return { kind: "late", tick: until };
  return bumpEvent(maze, bump, last.pose, until, decisions.at(-1)?.line);
}

/** The event of a bump, for any driver. */
export function bumpEvent(
  maze: MazeDocument,
  cause: BumpCause,
  pose: Pose,
  tick: number,
  line: LineRef | null = null,
): BumpEvent {
  const { action, side, decidedAt, startedAt, reading, needed } = cause;
  return {
    kind: "bump",
    tick,
    line,
    action,
    phase: phaseOf(action, cause),
    side,
    decidedAt,
    startedAt,
    reading,
    needs: needed === null ? null : needed + ROBOT_RADIUS,
    contact: contactOf(maze, pose, side),
  };
}

function phaseOf(action: Command["action"], { needed, part }: BumpCause): BumpPhase {
  if (needed === null) return "steady";
  const isDelayed = action === "delayed left 90" || action === "delayed right 90";
  if (!isDelayed) return "measured";
  return part === 0 ? "delay" : "way-out";
}

function explain(
  trace: RunTrace,
  event: FailureEvent,
  task: DiagnosisTask,
): Pick<Diagnosis, "cause" | "fixes"> {
  const isBump = event.kind === "bump";
  const trialTask: TrialTask = {
    until: task.until,
    bumps: task.bumps,
    newSolvedCheck: task.newSolvedCheck,
  };
  const tried = new Set<string>();
  const found: Found[] = [];
  let cost = 0;
  for (const fix of candidates(trace, event)) {
    if (cost > MAX_TRIAL_TICKS || isEnough(found, task)) break;
    const program = applyFix(trace.program, fix);
    const text = JSON.stringify([program.default, program.rules]);
    if (tried.has(text) || !task.allows(program)) continue;
    tried.add(text);
    const renumbered = fix.kind === "number" ? fix.line : null;
    const trial = tryProgram(trace, program, trialTask, isBump, trace.from, renumbered);
    cost += trial.cost;
    const each = foundBy(trace, event, task, fix, program, trial);
    if (each !== null) found.push(each);
  }
  const momentOf = (each: Found) => momentToName(trace, each, trialTask, isBump);
  const best = ranked(trace, found, event, task.mazes, momentOf);
  const named = best.flatMap((each): { cause: Cause; fix: Fix }[] => {
    const cause = causeOf(trace, each.fix, momentOf(each));
    return cause === null ? [] : [{ cause, fix: each.fix }];
  });
  const [first] = named;
  if (first === undefined) return { cause: null, fixes: [] };
  const fixes = named.map(({ fix }) => fix).filter((fix) => fits(fix, first.cause));
  return { cause: first.cause, fixes: fixes.slice(0, MAX_FIXES) };
}

/** Whether a change does what the text about the cause recommends: for "undoing", a turn. */
function fits(fix: Fix, cause: Cause): boolean {
  if (cause.kind !== "action" || cause.detail?.kind !== "undoing") return true;
  return fix.kind === "action" && isTurn(fix.action);
}

/** The change, if it removes the failure and says something about its cause. */
function foundBy(
  trace: RunTrace,
  event: FailureEvent,
  { allows, solvesAll }: DiagnosisTask,
  fix: Fix,
  program: ProgramDocument,
  trial: TrialResult,
): Found | null {
  const { from, outcome, offCentre } = trial;
  if (from === null || outcome === "fails") return null;
  if (outcome === "further" && !isWrongAnyway(trace, fix, trial)) return null;
  const isWhole = solvesAll === null ? null : outcome === "solved" && solvesAll(program);
  const isShown = isShownByRun(trace, event, fix, trial);
  const isFreeGuess = solvesAll === null && isGuess(trace, { fix, isShown, outcome }, from);
  const found: Found = {
    fix,
    from,
    program,
    outcome,
    offCentre,
    isWhole,
    isShown,
    isGuess: isFreeGuess,
  };
  if (fix.kind !== "number" && fix.kind !== "condition") return found;
  if (!isIdle(trace, program, fix.line, trial)) return found;
  // It may be the right change for another maze of the task.
  if (isWhole !== true) return null;
  const removal: Fix = { kind: "delete", line: fix.line };
  const without = applyFix(trace.program, removal);
  // A line that is not needed in any maze is one too many, whatever its number.
  const isNeeded = !allows(without) || solvesAll?.(without) === false;
  return isNeeded ? found : { ...found, fix: removal, program: without };
}

/**
 * Whether a line with another condition never decides any more: then the run shows that the condition
 * is wrong, but not the right one.
 */
function isIdle(
  trace: RunTrace,
  { rules }: ProgramDocument,
  line: number,
  { outcome, lines, from }: TrialResult,
): boolean {
  const hasDecided = trace.decisions.some((each) => each.line === line && each.tick < (from ?? 0));
  if (hasDecided || lines.has(line)) return false;
  const when = rules[line]?.when ?? null;
  // A trial that ends soon after the failure may not have reached the decision of the line.
  return outcome === "solved" || when === null || !trace.isEverTrue(when);
}

/** Whether there are enough candidates; numbers of the same line count once. */
function isEnough(found: readonly Found[], { solvesAll, newSolvedCheck }: DiagnosisTask): boolean {
  const best = newSolvedCheck === null ? "lasts" : "solved";
  const solving = found.filter((each) => each.outcome === best && !isLeftOut(each));
  if (solvesAll === null) {
    const isFounded = solving.filter((each) => !each.isGuess).length >= MAX_FIXES;
    return isFounded || solving.length >= MAX_GUESSES;
  }
  const numbers = solving.flatMap(({ fix }) => (fix.kind === "number" ? [fix.line] : []));
  return solving.length - numbers.length + new Set(numbers).size >= MAX_WHOLE_TRIALS;
}

/**
 * The decision to name. Before a bump, it is the newest one from which on the change still removes
 * the failure, because the line may have been right, or not needed, before. Without a bump, it is
 * the first one, or an early one that turned to a wall if the first one shows nothing wrong.
 */
function momentToName(
  trace: RunTrace,
  { fix, from, program }: Found,
  task: TrialTask,
  isBump: boolean,
): number {
  const isRepeated = isBump && (fix.kind === "delete" || fix.kind === "insert");
  if (fix.kind !== "action" && !isRepeated) return from;
  const moments = trace.differences(new CompiledProgram(program)).filter((tick) => tick > from);
  const helpsFrom = (tick: number, asked: TrialTask): boolean => {
    const trial = tryProgram(trace, program, asked, isBump, tick);
    return trial.outcome !== "fails" && trial.outcome !== "further" && trial.from === tick;
  };
  if (isBump) {
    const soon = { ...task, until: 0, newSolvedCheck: null };
    const newest = moments.slice(-MAX_MOMENTS).toReversed();
    return newest.find((tick) => helpsFrom(tick, soon)) ?? from;
  }
  if (hasDetail(causeOf(trace, fix, from))) return from;
  const early = moments.slice(0, MAX_MOMENTS);
  return (
    early.find((tick) => hasDetail(causeOf(trace, fix, tick)) && helpsFrom(tick, task)) ?? from
  );
}

/** Whether the readings at the moment show why the action was wrong. */
function hasDetail(cause: Cause | null): boolean {
  return cause !== null && (cause.kind !== "action" || cause.detail !== null);
}
