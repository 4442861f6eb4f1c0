/**
 * Decides which sounds a run makes, and when. A tick gets faster as the chosen beam gets shorter,
 * and each decision, bump and goal has a sound. The class has neither Web Audio nor a clock.
 * Minimum gaps between sounds keep speed "max" quiet.
 */
import { ROBOT_RADIUS } from "@corridor/simulation";
import type { LineRef, SensorName, Snapshot } from "@corridor/protocol";
import type { RunView } from "../../stage/drawing/frame.ts";

/** Plays the sounds. */
export interface SoundPort {
  tick: () => void;
  /** @param hertz pitch of the deciding line */
  note: (hertz: number) => void;
  bump: () => void;
  goal: () => void;
}

/**
 * Milliseconds between ticks: with the wall at the robot's edge, for each cm beyond it, and at
 * most.
 */
const FASTEST_MS = 80;
const MS_PER_CM = 2.2;
const SLOWEST_MS = 900;

/** Minimum milliseconds between two sounds of a kind. */
const NOTE_GAP_MS = 120;
const BUMP_GAP_MS = 300;

/** Hertz of "otherwise" and of line 1. Lines go up a scale of five steps, for two octaves. */
const OTHERWISE_HERTZ = 196;
const FIRST_HERTZ = 261.6;
const steps = [0, 2, 4, 7, 9] as const;
const HIGHEST_LINE = 10;

export class SoundPlan {
  readonly #port: SoundPort;
  readonly #now: () => number;
  /** the beam to listen to; null: none */
  beam: SensorName | null = null;
  #snapshot: Snapshot | null = null;
  #isRunning = false;
  #tickAt = Number.NEGATIVE_INFINITY;
  #noteAt = Number.NEGATIVE_INFINITY;
  #bumpAt = Number.NEGATIVE_INFINITY;

  /** @param now monotonic milliseconds */
  constructor(port: SoundPort, now: () => number) {
    this.#port = port;
    this.#now = now;
  }

  /**
   * Whether ticks may be due. Nothing sounds while the robot rests, or while an earlier tick is
   * displayed.
   */
  get isRunning(): boolean {
    return this.#isRunning;
  }

  /** Updates the displayed tick. */
  show(snapshot: Snapshot, view: RunView): void {
    const before = this.#snapshot;
    this.#snapshot = snapshot;
    this.#isRunning = view !== "past" && snapshot.state === "running";
    // Going back or viewing the past makes no sound. The last frame of a run already rests.
    if (before === null || view === "past" || snapshot.tick <= before.tick) return;
    this.#events(before, snapshot);
  }

  /** Plays the tick if one is due at the current time. */
  advance(): void {
    const snapshot = this.#snapshot;
    if (snapshot === null || this.beam === null || !this.#isRunning) return;
    const now = this.#now();
    if (now - this.#tickAt < tickGap(snapshot.sensors[this.beam])) return;
    this.#tickAt = now;
    this.#port.tick();
  }

  #events(before: Snapshot, snapshot: Snapshot): void {
    const now = this.#now();
    if (snapshot.goalReached && !before.goalReached) {
      this.#port.goal();
      return;
    }
    if (snapshot.bumps > before.bumps && now - this.#bumpAt >= BUMP_GAP_MS) {
      this.#bumpAt = now;
      this.#port.bump();
      return;
    }
    const { line, motion } = snapshot;
    if (line === null || (line === before.line && motion === before.motion)) return;
    if (now - this.#noteAt < NOTE_GAP_MS) return;
    this.#noteAt = now;
    this.#port.note(pitchOf(line));
  }
}

/** Milliseconds between two ticks at a distance in cm. */
export function tickGap(distance: number): number {
  const free = Math.max(0, distance - ROBOT_RADIUS);
  return Math.min(SLOWEST_MS, FASTEST_MS + MS_PER_CM * free);
}

/** The pitch of a line in hertz: later lines are higher, "otherwise" is the lowest. */
export function pitchOf(line: LineRef): number {
  if (line === "default") return OTHERWISE_HERTZ;
  const at = Math.min(line, HIGHEST_LINE);
  const semitones = 12 * Math.floor(at / steps.length) + (steps[at % steps.length] ?? 0);
  return FIRST_HERTZ * 2 ** (semitones / 12);
}
