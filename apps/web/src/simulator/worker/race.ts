/**
 * The ghosts of a race: recorded runs, each at the displayed tick of the live run. A ghost has no
 * clock of its own, so speed, pause, the past and Reset apply to it as to the robot. It stays at
 * its end once its recording is over.
 */
import { countLines } from "@corridor/program";
import { Replay, type Playback } from "@corridor/recording";
import { type AddedGhost, type AddGhost, type FromWorker } from "../protocol/worker-messages.ts";
import { MAX_GHOSTS, type GhostPose } from "../../stage/drawing/frame.ts";

/** Longest slice of loading, in milliseconds, so that a driving robot does not stutter. */
const SLICE_MS = 8;

export interface RacePorts {
  /** monotonic milliseconds */
  now: () => number;
  /** calls `next` after the messages that are already queued */
  later: () => void;
  post: (message: Extract<FromWorker, { type: "ghost-added" }>) => void;
  /** the ghosts changed: a frame is due even while the robot rests */
  onChange: () => void;
}

interface Ghost {
  id: number;
  badge: string;
  playback: Playback;
  /** the last tick of its recording */
  ticks: number;
}

export class Race {
  readonly #ports: RacePorts;
  readonly #loading: { id: number; badge: string; replay: Replay }[] = [];
  #ghosts: Ghost[] = [];

  constructor(ports: RacePorts) {
    this.#ports = ports;
  }

  /** Starts to load a ghost; answered by `ghost-added` with the same id. */
  add({ id, badge, run }: AddGhost): void {
    if (this.#ghosts.length + this.#loading.length >= MAX_GHOSTS) {
      this.#answer(id, { ok: false, problems: [] });
      return;
    }
    this.#loading.push({ id, badge, replay: new Replay(run) });
    this.#ports.later();
  }

  /** Removes a ghost from the race, even while it is loading. */
  remove(id: number): void {
    const at = this.#loading.findIndex((each) => each.id === id);
    if (at >= 0) this.#loading.splice(at, 1);
    this.#ghosts = this.#ghosts.filter((each) => each.id !== id);
    this.#ports.onChange();
  }

  /** Runs the next slice of the first loading recording. */
  next(): void {
    const first = this.#loading[0];
    if (first === undefined) return;
    const { now, later, onChange } = this.#ports;
    const until = now() + SLICE_MS;
    const { id, badge, replay } = first;
    const end = replay.advance(() => now() < until);
    if (end !== null) {
      this.#loading.shift();
      if (end.ok) {
        const { run } = end.value;
        const ghost = { id, badge, playback: end.value.playback(), ticks: run.tick };
        this.#ghosts = [...this.#ghosts, ghost].toSorted((a, b) => (a.badge < b.badge ? -1 : 1));
        this.#answer(id, { ok: true, finish: finishOf(ghost, run.goalTick) });
        onChange();
      } else this.#answer(id, end);
    }
    if (this.#loading.length > 0) later();
  }

  /** Every ghost at the end of a tick of the race. */
  posesAt(tick: number): readonly GhostPose[] {
    return this.#ghosts.map(({ badge, playback, ticks }) => {
      playback.seek(Math.min(tick, ticks));
      const { x, y, heading } = playback.run.pose;
      return { badge, x, y, heading };
    });
  }

  #answer(id: number, added: AddedGhost): void {
    this.#ports.post({ type: "ghost-added", id, added });
  }
}

/** Result of a run: at its goal, or at its end if it reached none. */
function finishOf({ playback, ticks }: Ghost, goalTick: number | null) {
  playback.seek(goalTick ?? ticks);
  const { bumps, driver, program } = playback.run;
  return {
    goalTick,
    bumps,
    driver,
    lines: countLines(program.rules),
  };
}
