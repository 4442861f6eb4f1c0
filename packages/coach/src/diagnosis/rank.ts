/** Orders the changes that remove a failure by how likely each is the student's mistake. */
import { causeOf } from "./cause-of.ts";
import type { FailureEvent } from "./diagnosis.ts";
import {
  CENTRED,
  isDelayWithoutRoom,
  isGuess,
  isIntoWall,
  isMissingDelay,
  isShownByReadings,
  isStraight,
  type Found,
} from "./evidence.ts";
import type { RunTrace } from "./run-trace.ts";
import { distanceFromLane } from "./trial.ts";

/** What decides the rank of a change. */
interface Facts {
  fix: Found["fix"]["kind"];
  outcome: Found["outcome"];
  isFreePlay: boolean;
  /** whether it passes: in a task, in every maze; in free play, only a change that is no guess */
  isSolution: boolean;
  /** whether it only happens to help in free play */
  isGuess: boolean;
  /** whether it moves a line, and passes in every maze of the task */
  isOrder: boolean;
  /** whether the run itself shows the mistake, at the first moment or at the one to name */
  isShown: boolean;
  /** whether it changes the decision that led to the failure */
  isLastDecision: boolean;
  /** whether the robot turns beside the middle of squares after it */
  isBeside: boolean;
  /** whether it adds the delay that is missing at the edge of an opening */
  addsDelay: boolean;
  /** whether it removes the delay that had no room and led to the bump */
  removesDelay: boolean;
  /** whether a missing delay alone passes in every maze of the task */
  isDelayEnough: boolean;
  /** whether it is an action that only avoids the place, where the run shows another mistake */
  isEvasion: boolean;
  /** whether the run shows nothing wrong about the line, but a delay that is wrong or missing */
  isDoubtful: boolean;
}

/**
 * The ranks, the most plausible first. The first one that applies is the rank of a change. Without
 * one, it is not named: for example a guess about an early decision, if another failure follows.
 */
const ranks: Readonly<Record<string, (change: Facts) => boolean>> = {
  "another order of the lines, if a delay alone is not enough": (it) =>
    it.isOrder && !it.isDelayEnough,
  "a solution": (it) =>
    it.isSolution &&
    (it.removesDelay || it.isOrder || !(it.isBeside || it.isEvasion || it.isDoubtful)),
  // Two mistakes need two changes. So a delay comes before another action with which the run shows
  // nothing wrong, and before the number of another line.
  "a delay": (it) => it.outcome !== "further" && (it.addsDelay || it.removesDelay),
  "a delay that only gets the robot further": (it) => it.addsDelay,
  "a doubtful solution": (it) => it.isSolution && !it.isBeside && !it.isEvasion,
  "a solution after which the robot turns beside the middle of squares": (it) =>
    it.isSolution && !it.isEvasion,
  "what the run shows": (it) =>
    !it.isSolution && (it.outcome === "solved" || it.outcome === "lasts") && it.isShown,
  "what the run shows, if another failure follows": (it) => it.outcome === "past" && it.isShown,
  "an evasion": (it) => it.isSolution,
  // With two wrong lines, each maze of a task may show one of them. So an action that does not pass
  // in every maze comes late, and must pass in this one.
  "another line, condition or number": (it) =>
    isPermanent(it) && !it.isGuess && it.fix !== "action" && (it.fix !== "move" || isPassed(it)),
  "in free play, a guess that passes": (it) =>
    it.isGuess && it.outcome === "solved" && !it.isBeside,
  "a change with which the run shows nothing wrong": (it) => isPermanent(it) && isPassed(it),
  "in free play, a change after which another failure follows": (it) =>
    it.isFreePlay && it.outcome === "past" && !it.isGuess,
  "in free play, a guess about the last decision": (it) =>
    it.isFreePlay && it.outcome === "past" && it.isLastDecision,
  "another action that only gets the robot further": (it) => it.outcome === "further",
};

/** In a task, getting past the failure is worth naming even if another one follows. */
function isPermanent({ outcome, isFreePlay }: Facts): boolean {
  return outcome !== "further" && !(isFreePlay && outcome === "past");
}

function isPassed({ outcome, isFreePlay }: Facts): boolean {
  return isFreePlay || outcome === "solved";
}

/**
 * Sorts the changes, the most plausible first, and leaves out those that only happen to help: in a
 * task, a sign, a sensor or a number that does not solve every maze, and one that only compensates
 * for an earlier turn.
 */
export function ranked(
  trace: RunTrace,
  found: readonly Found[],
  event: FailureEvent,
  mazes: number,
  momentOf: (found: Found) => number,
): Found[] {
  const factsOf = factsIn(trace, found, event, mazes, momentOf);
  const tests = Object.values(ranks);
  return found
    .filter((each) => !isLeftOut(each) && !isCompensation(trace, each))
    .map((each) => {
      const facts = factsOf(each);
      return { each, rank: tests.findIndex((applies) => applies(facts)) };
    })
    .filter(({ rank }) => rank >= 0)
    .toSorted((a, b) => a.rank - b.rank)
    .map(({ each }) => each);
}

function factsIn(
  trace: RunTrace,
  found: readonly Found[],
  event: FailureEvent,
  mazes: number,
  momentOf: (found: Found) => number,
): (change: Found) => Facts {
  const delays = found.filter(({ fix, from }) => isMissingDelay(trace, fix, from));
  const isDelayEnough = delays.some(({ isWhole }) => isWhole === true);
  const turnsIntoWall = found.some(({ fix, from }) => isIntoWall(causeOf(trace, fix, from)));
  const withoutRoom = found.find((each) => isDelayWithoutRoom(trace, event, each));
  return (each) => {
    const { fix, outcome, isWhole } = each;
    const isUnfounded = fix.kind === "action" && !each.isShown;
    const isProved = isWhole === true && mazes > 1;
    const isOtherNumber = fix.kind === "number" && event.kind === "bump" && fix.line !== event.line;
    const isFreePlay = isWhole === null;
    const isFreeGuess = each.isGuess && isGuess(trace, each, momentOf(each));
    const isSolution = outcome === "solved" && isWhole !== false && !isFreeGuess;
    return {
      fix: fix.kind,
      outcome,
      isFreePlay,
      isSolution,
      isGuess: isFreeGuess,
      isOrder: isSolution && isWhole === true && fix.kind === "move",
      // The moment to name needs simulations.
      get isShown() {
        return each.isShown || isShownByReadings(trace, fix, momentOf(each));
      },
      get isLastDecision() {
        return momentOf(each) >= (trace.decisions.at(-1)?.tick ?? 0);
      },
      isBeside: each.offCentre > CENTRED,
      addsDelay: delays.includes(each),
      removesDelay: each === withoutRoom,
      isDelayEnough,
      isEvasion: isUnfounded && !isProved && (isStraight(event) || turnsIntoWall),
      isDoubtful:
        (isUnfounded && delays.length > 0) || (isOtherNumber && withoutRoom !== undefined),
    };
  };
}

/** Whether the change says nothing about the task, because it only happens to help in this maze. */
export function isLeftOut({ fix, isWhole, isShown }: Found): boolean {
  if (isWhole !== false) return false;
  return fix.kind === "condition" || (fix.kind === "number" && !isShown);
}

/**
 * Whether the robot was beside the middle of squares before the change mattered: then the change only
 * compensates for an earlier turn.
 */
function isCompensation(trace: RunTrace, { from, isWhole }: Found): boolean {
  if (isWhole === null) return false;
  return distanceFromLane(trace.at(from).pose) > CENTRED;
}
