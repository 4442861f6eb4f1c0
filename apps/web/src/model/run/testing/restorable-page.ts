/** A page whose run survives a reload: the worker's parts are real, its storage is in memory. */
import { createWorkspaceStore } from "../../workspace/workspace-store.ts";
import { restoreWorld, type RestoredJournal } from "../../../simulator/worker/restored-world.ts";
import { RunLoader } from "../../../simulator/worker/run-loader.ts";
import { RunLoop } from "../../../simulator/worker/run-loop.ts";
import { MemoryWorldStore } from "../../../simulator/worker/testing/memory-world-store.ts";
import { WorldRepository } from "../../../simulator/worker/world-repository.ts";
import type { WorldJournal } from "../../../simulator/worker/world-store.ts";
import type {
  FromWorker,
  LoadedRun,
  ToWorker,
} from "../../../simulator/protocol/worker-messages.ts";
import { firstMaze, firstProgram } from "../../../simulator/protocol/first-project.ts";
import { RunRestorer } from "../run-restorer.ts";
import { MemoryStorage } from "../../storage/testing/memory-storage.ts";

/** The state that outlives a page: its tab, and the device. */
interface Left {
  tab: MemoryStorage;
  store: MemoryWorldStore;
}

let writers = 0;
/** A page opens after all earlier ones. */
let openedAt = 0;
const HOUR_MS = 3_600_000;

/** A page with a real run, connected as in the worker's entry. */
export function openPage(
  { tab, store }: Left = { tab: new MemoryStorage(), store: new MemoryWorldStore() },
  maze = firstMaze,
) {
  let time = (openedAt += HOUR_MS);
  /** whether the page receives what the worker sends */
  let isBusy = false;
  const listeners = new Set<(message: FromWorker) => void>();
  const lost: string[] = [];
  const loop = new RunLoop(maze, firstProgram, () => time);
  const post = (message: FromWorker) => {
    if (isBusy) return;
    for (const listener of listeners) listener(message);
  };
  const postUpdate = () => {
    const update = loop.updates.take();
    if (update !== null) post({ type: "frame", frame: update.frame, timeline: null });
    worlds.update();
  };
  const notes: ((ok: boolean) => void)[] = [];
  const of: { journal: WorldJournal | null; restored: RestoredJournal | null } = {
    journal: null,
    restored: null,
  };
  const worlds = new WorldRepository({
    openStore: async () => store,
    recording: () => loop.recording,
    startedAt: () => loop.startedAt,
    journal: () => of.journal ?? of.restored,
    storeKey: (key) => {
      const noted = new Promise<boolean>((resolve) => notes.push(resolve));
      post({ type: "run-key", key });
      return noted;
    },
    onClaimed: () => void lost.push("claimed"),
    newId: () => `id-${(writers += 1)}`,
    now: () => time,
    after: () => () => undefined,
  });
  const answer = (id: number, loaded: LoadedRun) => {
    worlds.claimed();
    post({ type: "run-loaded", id, loaded });
  };
  /** whether a slice of a long run takes all its time */
  let isSlow = false;
  let slowTime = 0;
  const slices: (() => void)[] = [];
  const loader = new RunLoader({
    now: () => (isSlow ? (slowTime += 10) : time),
    later: () => void slices.push(() => loader.next()),
    onPart: () => undefined,
    answer,
  });
  const send = (message: ToWorker) => {
    if (message.type === "run-key-noted") notes.shift()?.(message.ok);
    if (message.type === "edit-program") loop.editProgram(message.program);
    if (message.type === "cancel-load") loader.cancel(message.id);
    if (message.type === "restore-run") {
      const { id } = message;
      void restoreWorld(message, {
        repository: worlds,
        run: loop,
        load: (run, open) => loader.load({ id, run }, open),
        answer: (loaded) => answer(id, loaded),
        restored: (journal) => (of.restored = journal),
      });
    }
    postUpdate();
  };
  const workspace = createWorkspaceStore(maze, firstProgram);
  const restorer = new RunRestorer({
    simulator: {
      send,
      isGone: false,
      listen: (listener) => {
        listeners.add(listener);
        return () => listeners.delete(listener);
      },
    },
    workspace,
    tab,
    onNotStored: () => void lost.push("not stored"),
    onLost: () => void lost.push("lost"),
  });
  const pass = async (milliseconds: number) => {
    for (const end = time + milliseconds; time < end;) {
      time += 8;
      loop.advance();
      postUpdate();
      await settle();
    }
  };
  const beSlow = () => void (isSlow = true);
  const beBusy = () => void (isBusy = true);
  /** Replays a slice. @returns false if none waits */
  const slice = (): boolean => {
    const next = slices.shift();
    next?.();
    return next !== undefined;
  };
  postUpdate();
  return { loop, restorer, worlds, of, tab, store, workspace, pass, lost, beSlow, beBusy, slice };
}

/** Runs everything that depends on no timer. */
export async function settle(): Promise<void> {
  for (let n = 0; n < 20; n++) await Promise.resolve();
}
