/**
 * The robot of another page for a viewer. Snapshots arrive some 20 times a second and never quite
 * evenly; the displayed robot moves smoothly between them, a tenth of a second behind. Jumps of the
 * run (a reset, another tick, a very high speed) are displayed as jumps. Pure except for the given
 * time.
 */
import type { Pose, Snapshot } from "@corridor/protocol";
import { blendHeading } from "../protocol/blend-heading.ts";
import type { Frame } from "../../stage/drawing/frame.ts";

/** A robot this far from its last position, in units, did not drive there. */
const JUMP = 400;
/** A reading that differs by this much is of another wall. */
const OTHER_WALL = 60;
/** A position this far beside the straight line, in units, is a corner of the trail. */
const BESIDE = 0.5;
/** Largest number of queued snapshots; older ones are skipped, for example in a hidden tab. */
const MOST_WAITING = 40;
/** Bounds of the interval between snapshots, in ms; the display is behind by more than that. */
const LEAST_GAP_MS = 40;
const MOST_GAP_MS = 250;
const LATE_MS = 20;

interface Seen {
  snapshot: Snapshot;
  at: number;
}

export class WatchMirror {
  readonly #now: () => number;
  /** the displayed snapshot, then its successors */
  #seen: Seen[] = [];
  #gapMs = 50;
  #shownAt = Number.NEGATIVE_INFINITY;
  /** new corners of the trail since the last frame */
  #corners: number[] = [];
  #bumps: number[] = [];
  #isReset = true;
  #corner: { x: number; y: number } | null = null;
  #hasChanged = false;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  add(snapshot: Snapshot): void {
    const at = this.#now();
    const newest = this.#seen.at(-1);
    if (newest !== undefined) {
      // A standing robot reports once a second, which says nothing about regularity.
      const gap = Math.min(MOST_GAP_MS, Math.max(LEAST_GAP_MS, at - newest.at));
      if (at - newest.at < 2 * MOST_GAP_MS) this.#gapMs += (gap - this.#gapMs) / 10;
    }
    this.#seen.push({ snapshot, at });
    if (this.#seen.length === 1) this.#hasChanged = true;
    while (this.#seen.length > MOST_WAITING) this.#pass();
  }

  /** The robot now; null if it has not moved since the last call. */
  frame(): Frame | null {
    const wanted = this.#now() - 1.5 * this.#gapMs - LATE_MS;
    const at = (this.#shownAt = Math.max(this.#shownAt, wanted));
    while ((this.#seen[1]?.at ?? Number.POSITIVE_INFINITY) <= at) this.#pass();
    const [from, to] = this.#seen;
    if (from === undefined || (to === undefined && !this.#hasChanged)) return null;
    this.#hasChanged = false;
    const snapshot = to === undefined ? from.snapshot : between(from, to, at);
    const [corners, bumps, trailReset] = [this.#corners, this.#bumps, this.#isReset];
    this.#corners = [];
    this.#bumps = [];
    this.#isReset = false;
    return {
      snapshot,
      hasEnded: false,
      progress: null,
      view: "now",
      nowTick: snapshot.tick,
      waited: 0,
      nowDriver: snapshot.driver,
      revision: 0,
      startedAt: 0,
      corners,
      bumps,
      trailReset,
    };
  }

  /** The next snapshot is reached. */
  #pass(): void {
    const [from, to] = this.#seen;
    if (from === undefined || to === undefined) return;
    this.#seen.shift();
    this.#hasChanged = true;
    const { pose } = from.snapshot;
    if (isJump(from.snapshot, to.snapshot)) {
      this.#corners = [];
      this.#bumps = [];
      this.#isReset = true;
      this.#corner = null;
    } else if (isBeside(this.#corner, pose, to.snapshot.pose)) {
      this.#corners.push(pose.x, pose.y);
      this.#corner = pose;
    } else {
      this.#corner ??= pose;
    }
    if (to.snapshot.bumps > from.snapshot.bumps) {
      this.#bumps.push(to.snapshot.pose.x, to.snapshot.pose.y);
    }
  }
}

/** The robot between two snapshots. */
function between(from: Seen, to: Seen, at: number): Snapshot {
  const a = from.snapshot;
  const b = to.snapshot;
  if (isJump(a, b)) return a;
  const part = Math.min(1, Math.max(0, (at - from.at) / (to.at - from.at)));
  if (part === 0) return a;
  const blend = (x: number, y: number): number => x + (y - x) * part;
  const reading = (x: number, y: number): number =>
    Math.abs(x - y) > OTHER_WALL ? x : blend(x, y);
  const { front, right, back, left } = a.sensors;
  return {
    ...a,
    pose: {
      x: blend(a.pose.x, b.pose.x),
      y: blend(a.pose.y, b.pose.y),
      heading: blendHeading(a.pose.heading, b.pose.heading, part),
    },
    sensors: {
      front: reading(front, b.sensors.front),
      right: reading(right, b.sensors.right),
      back: reading(back, b.sensors.back),
      left: reading(left, b.sensors.left),
    },
  };
}

function isJump(a: Snapshot, b: Snapshot): boolean {
  return b.tick < a.tick || Math.abs(b.pose.x - a.pose.x) + Math.abs(b.pose.y - a.pose.y) > JUMP;
}

/** Whether the line from a corner by a point to another point has a bend there. */
function isBeside(corner: { x: number; y: number } | null, by: Pose, to: Pose): boolean {
  if (corner === null) return false;
  const dx = to.x - corner.x;
  const dy = to.y - corner.y;
  const length = Math.sqrt(dx * dx + dy * dy);
  const cross = Math.abs((by.x - corner.x) * dy - (by.y - corner.y) * dx);
  // Back to the corner itself: the farthest point is the bend.
  if (length < BESIDE) return Math.abs(by.x - corner.x) + Math.abs(by.y - corner.y) > BESIDE;
  return cross / length > BESIDE;
}
