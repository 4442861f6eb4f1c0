/**
 * Restores the run from the world that this tab stored before a reload. In its own file, because it
 * needs the schemas, and most visits restore nothing.
 */
import { parseRun, type Run, type RunDocument } from "@corridor/recording";
import { RELOADED_REASON } from "@corridor/protocol";
import type { OpenRecording } from "./run-loader.ts";
import type { RunLoop } from "./run-loop.ts";
import type { LoadedRun, RestoreRun } from "../protocol/worker-messages.ts";
import type { WorldRepository } from "./world-repository.ts";
import type { WorldJournal } from "./world-store.ts";

/** All commands in it have ended. */
export type RestoredJournal = WorldJournal & { running: null };

export interface RestorePorts {
  repository: Pick<WorldRepository, "claim">;
  run: Pick<RunLoop, "isUntouched" | "isOf" | "open">;
  /** replays the document, then calls `open`, and answers with its result */
  load: (run: RunDocument, open: OpenRecording) => void;
  /** answers if there is nothing to load */
  answer: (loaded: LoadedRun) => void;
  restored: (journal: RestoredJournal | null) => void;
}

/**
 * Restores the stored world, unless another project is open now, the run was reset since, or the
 * robot drives already.
 */
export async function restoreWorld(
  { key, isSameProject, atStartSince }: Pick<RestoreRun, "key" | "isSameProject" | "atStartSince">,
  { repository, run, load, answer, restored }: RestorePorts,
): Promise<void> {
  const world = await repository.claim(key);
  if (world === null) return answer({ ok: false, reason: "not-stored" });
  const read = parseRun({ format: "corridor/run", version: 1, name: "", seed: 0, ...world.run });
  if (!read.ok) return answer({ ...read, reason: "refused" });
  if (!run.isUntouched) return answer({ ok: false, reason: "cancelled" });
  load(read.value, (recording) => {
    if (!run.isUntouched) return { ok: false, reason: "cancelled" };
    const { maze, program, tick } = recording.run;
    const isOther = !isSameProject && !run.isOf(maze, program);
    const isBeforeReset = tick > 0 && atStartSince !== null && world.startedAt < atStartSince;
    if (isOther || isBeforeReset) return { ok: false, reason: "other-run" };
    restored(world.journal === null ? null : endedBy(world.journal, recording.run));
    return run.open(recording);
  });
}

/** The journal after the reload, in which the running command ends where the robot stands. */
function endedBy(journal: WorldJournal, { pose, distance }: Pick<Run, "pose" | "distance">) {
  const { running, endings, ...rest } = journal;
  if (running === null) return { ...rest, endings, running };
  const ending = {
    seq: running.seq,
    state: "cancelled",
    reason: RELOADED_REASON,
    pose,
    distance: Math.max(0, distance - running.distance),
  } as const;
  return { ...rest, endings: [...endings, ending], running: null };
}
