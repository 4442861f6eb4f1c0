/**
 * From the world that this tab stored before a reload to the run that is there again. A file of its own, because it
 * needs the schemas, and most visits restore nothing.
 */
import { parseRun, type Recording, type Run, type RunDocument } from "@corridor/recording";
import { RELOADED } from "../drivers/cancel-reason.ts";
import type { RunLoop } from "./run-loop.ts";
import type { LoadedRun, RestoreRun } from "./worker-messages.ts";
import type { WorldKeeper } from "./world-keeper.ts";
import type { WorldJournal } from "./world-store.ts";

/** All commands in it have ended. */
export type RestoredJournal = WorldJournal & { running: null };

export interface RestorePorts {
  keeper: Pick<WorldKeeper, "claim">;
  /** null before the documents have come */
  run: () => Pick<RunLoop, "isUntouched" | "isOf" | "open"> | null;
  /** runs the document again, then calls `open`, and answers what that returns */
  load: (run: RunDocument, open: (recording: Recording) => LoadedRun) => void;
  /** where there is nothing to load */
  answer: (loaded: LoadedRun) => void;
  restored: (journal: RestoredJournal | null) => void;
}

/** Restores the stored world, unless another project is open now or the robot drives already. */
export async function restoreWorld(
  { key, isSameProject }: Pick<RestoreRun, "key" | "isSameProject">,
  { keeper, run, load, answer, restored }: RestorePorts,
): Promise<void> {
  const world = await keeper.claim(key);
  const loop = run();
  if (world === null || loop === null) return answer({ ok: false, reason: "not-stored" });
  const read = parseRun({ format: "corridor/run", version: 1, name: "", seed: 0, ...world.run });
  if (!read.ok) return answer({ ...read, reason: "refused" });
  if (!loop.isUntouched) return answer({ ok: false, reason: "cancelled" });
  load(read.value, (recording) => {
    const { maze, program } = recording.run;
    if (!isSameProject && !loop.isOf(maze, program)) return { ok: false, reason: "other-project" };
    restored(world.journal === null ? null : endedBy(world.journal, recording.run));
    return loop.open(recording);
  });
}

/** The journal after the reload, which ends what ran where the robot stands. */
function endedBy(journal: WorldJournal, { pose, distance }: Pick<Run, "pose" | "distance">) {
  const { running, endings, ...rest } = journal;
  if (running === null) return { ...rest, endings, running };
  const ending = {
    seq: running.seq,
    state: "cancelled",
    reason: RELOADED,
    pose,
    distance: Math.max(0, distance - running.distance),
  } as const;
  return { ...rest, endings: [...endings, ending], running: null };
}
