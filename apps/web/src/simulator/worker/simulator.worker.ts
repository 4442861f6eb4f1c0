/**
 * Entry of the simulator worker: simulation, program and relay link run here, so that they continue
 * while the page is hidden. A thin shell; the logic is in `run-loop.ts` and `remote-host.ts`.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Race } from "./race.ts";
import { loadRaceGhosts } from "../../stage/layers/lazy-race-ghosts.ts";
import { afterMessages } from "./after-messages.ts";
import { describeFault } from "./describe-fault.ts";
import { earlyProject, type FirstProject } from "../protocol/first-project.ts";
import { FrameThrottle } from "./frame-throttle.ts";
import { Lazy } from "./lazy.ts";
import type { RemoteHost } from "./remote-host.ts";
import type { RestoredJournal } from "./restored-world.ts";
import type { RunLoader } from "./run-loader.ts";
import { RunLoop } from "./run-loop.ts";
import { StagePainter } from "../../stage/stage-painter.ts";
import type {
  AddGhost,
  FromWorker,
  LoadedRun,
  RestoreRun,
  SavedRun,
  ToWorker,
} from "../protocol/worker-messages.ts";
import type { WorldRepository } from "./world-repository.ts";

/** Half of a 60 Hz frame, so that no frame waits for a whole interval. */
const INTERVAL_MS = 8;
/**
 * Least interval of snapshots to the relay while the robot moves, and the interval while it stands.
 */
const RELAY_INTERVAL_MS = 50;
const RELAY_HEARTBEAT_MS = 1000;
/** Held while a robot runs, so that browsers do not freeze the hidden page. */
const LOCK_NAME = "corridor-simulation";

const worker = self as unknown as DedicatedWorkerGlobalScope;
const post = (message: FromWorker): void => worker.postMessage(message);
const now = (): number => performance.now();

let loop: RunLoop | null = null;
let releaseLock: (() => void) | null = null;
let sentToRelayAt = Number.NEGATIVE_INFINITY;
let hasUnsentNews = false;
let pastMaze: MazeDocument | null = null;
/** id of the newest `judge` message */
let judgeId = 0;

/** The relay link is loaded when Remote is opened for the first time. */
const remote = new Lazy(loadRemote, guarded);

function withRemote(use: (host: RemoteHost) => void): void {
  remote.use(use, () => {
    const status = { kind: "lost", reason: "connectionLost" } as const;
    post({
      type: "remote",
      remote: { status, session: null, commands: [], scripts: [], isPaused: false },
    });
  });
}

async function loadRemote(): Promise<RemoteHost> {
  const [{ RemoteHost: Host }, { RemoteDriver }] = await Promise.all([
    import("./remote-host.ts"),
    import("../drivers/remote-driver.ts"),
  ]);
  const host = new Host({
    origin: worker.location.origin,
    now: () => Date.now(),
    snapshot: () => loop?.snapshot() ?? null,
    onView: (view) => post({ type: "remote", remote: view }),
    onDelivery: (delivery) => loop?.accept(delivery),
    cancel: (reason) => loop?.cancelRemote(reason),
    cancelOne: (seq, reason) => loop?.remote?.cancelOne(seq, reason),
    reset: () => loop?.remote?.reset(),
    renew: (alive) => loop?.remote?.renew(alive),
    save: saveWorld,
    restored: () => restored,
    fetch: (url, request) => fetch(url, request),
  });
  loop?.connect((robot) => new RemoteDriver(host, robot, now));
  return host;
}

/** The world repository is loaded once there is something to store. */
let repository: WorldRepository | null = null;
let keeperLoading: Promise<WorldRepository> | null = null;
/** of the world before a reload, if it was restored */
let restored: RestoredJournal | null = null;
const keyNotes: ((isNoted: boolean) => void)[] = [];

function storeKey(key: string | null): Promise<boolean> {
  post({ type: "run-key", key });
  return new Promise((resolve) => keyNotes.push(resolve));
}

function loadRepository(): Promise<WorldRepository> {
  keeperLoading ??= startKeeper();
  return keeperLoading;
}

async function startKeeper(): Promise<WorldRepository> {
  try {
    const [{ WorldRepository: Keeper }, { openWorldStore }] = await Promise.all([
      import("./world-repository.ts"),
      import("./world-store.ts"),
    ]);
    repository = new Keeper({
      openStore: () => openWorldStore(Date.now),
      recording: () => {
        if (loop === null) throw new Error("a world is stored before the documents came");
        return loop.recording;
      },
      journal: () => {
        const journal = remote.loaded?.journal ?? null;
        return journal === null ? restored : { ...journal, running: loop?.remote?.running ?? null };
      },
      storeKey,
      onClaimed: () => remote.loaded?.worldClaimed(),
      newId: () => crypto.getRandomValues(new Uint32Array(4)).join("-"),
      now,
      after: (milliseconds, call) => {
        const timer = setTimeout(call, milliseconds);
        return () => clearTimeout(timer);
      },
    });
    return repository;
  } catch (error) {
    // The file did not load: a reload restores nothing.
    await storeKey(null);
    throw error;
  }
}

/** Before an ending is sent. */
async function saveWorld(): Promise<void> {
  const loaded = await loadRepository().catch(() => null);
  await loaded?.save();
}

async function restoreRun(message: RestoreRun): Promise<void> {
  const [storage, { restoreWorld }] = await Promise.all([
    loadRepository(),
    import("./restored-world.ts"),
  ]);
  await restoreWorld(message, {
    repository: storage,
    run: () => loop,
    load: (run, open) =>
      loader.use(
        (runs) => runs.load({ id: message.id, run }, open),
        () => failedLoad(message.id),
      ),
    answer: (loaded) => runLoaded(message.id, loaded),
    restored: (journal) => (restored = journal),
  });
}

function runLoaded(id: number, loaded: LoadedRun): void {
  repository?.claimed();
  post({ type: "run-loaded", id, loaded });
}

const failedLoad = (id: number): void => runLoaded(id, { ok: false, reason: "fault" });

/** Least milliseconds between two catch-ups before drawing. */
const RECENT_MS = 2;
let advancedAt = Number.NEGATIVE_INFINITY;

const pace = new FrameThrottle(now);
const painter = new StagePainter({
  post,
  requestFrame: (paint) => requestAnimationFrame(() => guarded(paint)),
  cancelFrame: (request) => cancelAnimationFrame(request),
  catchUp: () => {
    if (now() - advancedAt > RECENT_MS) advance();
  },
  loadFont: async (name, address) => {
    const font = new FontFace(name, `url("${address}")`, { weight: "100 900" });
    worker.fonts.add(await font.load());
  },
});

const postSoon = afterMessages(() => guarded(postUpdate));

/** The loader of recorded runs is loaded with the first of them. */
const loader = new Lazy(loadLoader, guarded);

async function loadLoader(): Promise<RunLoader> {
  const { RunLoader: Loader } = await import("./run-loader.ts");
  const runs: RunLoader = new Loader({
    now,
    later: afterMessages(() =>
      guarded(() => {
        runs.next();
        postUpdate();
      }),
    ),
    onPart: (id, part) => post({ type: "run-loading", id, part }),
    answer: runLoaded,
  });
  return runs;
}

/** The race is loaded with the first ghost. */
const ghosts = new Lazy(loadRace, guarded);

async function loadRace(): Promise<Race> {
  const [{ Race: Ghosts }] = await Promise.all([import("./race.ts"), loadRaceGhosts()]);
  const race: Race = new Ghosts({
    now,
    later: afterMessages(() => guarded(() => race.next())),
    post,
    onChange: () => {
      loop?.updates.raceWith(race);
      postUpdate();
    },
  });
  return race;
}

function addGhost(message: AddGhost): void {
  ghosts.use(
    (race) => race.add(message),
    () => post({ type: "ghost-added", id: message.id, added: { ok: false, problems: [] } }),
  );
}

worker.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  try {
    handle(data);
    // Of several requested ticks, only the newest is displayed: the others arrived before this
    // message.
    if (data.type === "seek") postSoon();
    else advance();
  } catch (error) {
    reportFault(error);
  }
};

setInterval(() => {
  guarded(() => {
    advance();
    holdLock(loop?.isRunning === true);
  });
}, INTERVAL_MS);

/** Brings the run up to now, and posts its updates. */
function advance(): void {
  loop?.advance();
  advancedAt = now();
  postUpdate();
}

/** An error pauses the robot and is reported once, instead of recurring on every interval. */
function guarded(work: () => void): void {
  try {
    work();
  } catch (error) {
    loop?.pause();
    reportFault(error);
  }
}

function reportFault(error: unknown): void {
  post({ type: "fault", reason: describeFault(error) });
}

const digests = new Lazy(() => import("./digest.ts"), guarded);

function handle(message: ToWorker): void {
  if (message.type === "load") return load(message);
  if (message.type === "digest") {
    digests.use(({ digestOf }) => post({ type: "digest", digest: digestOf(message) }), reportFault);
    return;
  }
  if (message.type === "load-run") {
    return loader.use(
      (runs) =>
        runs.load(message, (recording) => {
          if (loop === null) throw new Error("a run comes before the documents");
          return loop.open(recording);
        }),
      () => failedLoad(message.id),
    );
  }
  if (message.type === "restore-run") {
    void restoreRun(message).catch(() => failedLoad(message.id));
    return;
  }
  if (message.type === "run-key-noted") return keyNotes.shift()?.(message.ok);
  if (loop === null) return;
  switch (message.type) {
    case "edit-maze":
      return loop.editMaze(message.maze);
    case "edit-program":
      return loop.editProgram(message.program);
    case "run":
      return loop.run();
    case "pause":
      return loop.pause();
    case "step":
      return loop.step(message.length);
    case "reset":
      if (loader.isRequested) loader.use((runs) => runs.cancel());
      return loop.reset();
    case "judge":
      return judge(message.id, message.attempt);
    case "speed":
      return loop.setSpeed(message.speed);
    case "driver":
      return loop.setDriver(message.driver);
    case "offer-driver":
      return loop.offerDriver(message.driver);
    case "hold":
      return loop.hold(message.key);
    case "seek":
      return loop.seek(message.tick);
    case "seek-step":
      return loop.seekStep(message.by);
    case "play":
      return loop.play();
    case "now":
      return loop.now();
    case "run-here":
      return loop.run();
    case "save-run":
      return saveRun(loop, message.id);
    case "add-ghost":
      return addGhost(message);
    case "remove-ghost":
      return ghosts.use((race) => race.remove(message.id));
    case "cancel-load":
      return loader.use((runs) => runs.cancel(message.id));
    case "remote-open":
      return withRemote((host) => host.open(message.session, message.fresh));
    case "remote-close":
      return withRemote((host) => host.close());
    case "remote-clear":
      return withRemote((host) => host.clearCommands());
    case "stage-mount":
    case "stage-mount-here":
    case "stage-model":
    case "stage-numbers":
    case "stage-unmount":
      return painter.handle(message);
  }
}

/** A run that started before the page continues: only names can differ. */
function load({ maze, program }: FirstProject): void {
  if (loop === null) {
    loop = new RunLoop(maze, program, now);
    // They load after the first tick.
    loop.updates.awaitDiagnostics(true);
    return;
  }
  loop.editMaze(maze);
  loop.editProgram(program);
}

function saveRun(run: RunLoop, id: number): void {
  const written = run.saveRun();
  const saved: SavedRun = written.ok
    ? { ok: true, text: written.text, ticks: written.run.ticks }
    : written;
  post({ type: "run-saved", id, saved });
}

const judges = new Lazy(() => import("./run-judge.ts"), guarded);

/** Ticks that run before the judge has loaded are judged afterwards. */
function judge(id: number, attempt: Extract<ToWorker, { type: "judge" }>["attempt"]): void {
  judgeId = id;
  loop?.updates.judgeBy(null);
  if (attempt === null) return;
  const { challenge, maze } = attempt;
  judges.use(({ RunJudge }) => {
    if (id === judgeId) loop?.updates.judgeBy(new RunJudge(challenge, maze));
  }, reportFault);
}

/** Diagnostics load once the robot drives; without them runs continue unexplained. */
const diagnostics = new Lazy(() => import("./diagnose-run.ts"), guarded);

function loadDiagnostics(): void {
  if (diagnostics.isRequested) return;
  loop?.updates.awaitDiagnostics(true);
  diagnostics.use(
    (loaded) => {
      loop?.updates.useDiagnostics(loaded);
      postUpdate();
    },
    () => {
      loop?.updates.awaitDiagnostics(false);
      postUpdate();
    },
  );
}

function postUpdate(): void {
  const update = loop?.updates.take();
  if (loop === null || update === undefined) return;
  if (update !== null && update.frame.nowTick > 0) loadDiagnostics();
  if (repository !== null) repository.update();
  else if (update !== null && !loop.isUntouched) void loadRepository().catch(() => undefined);
  if (update !== null) {
    const { frame, truncatedAfter } = update;
    if (truncatedAfter !== null) post({ type: "truncated", after: truncatedAfter });
    painter.add(frame);
    pace.add(frame);
  }
  const frame = pace.take();
  if (frame !== null) {
    if (loop.updates.pastMaze !== pastMaze) {
      pastMaze = loop.updates.pastMaze;
      post({ type: "past-maze", maze: pastMaze });
    }
    const corners = Float64Array.from(frame.corners);
    post({ type: "frame", frame: { ...frame, corners }, timeline: loop.updates.takeTimeline() });
  }
  if (update !== null) {
    for (const event of update.events) post({ type: "event", event });
    const diagnosed = loop.updates.takeDiagnosed();
    if (diagnosed !== null) post({ type: "diagnosed", ...diagnosed });
  }
  const judgement = loop.updates.takeJudgement();
  if (judgement !== null) post({ type: "judgement", id: judgeId, judgement });
  hasUnsentNews ||= update !== null;
  const wait = hasUnsentNews ? RELAY_INTERVAL_MS : RELAY_HEARTBEAT_MS;
  const host = remote.loaded;
  if (host?.isOpen === true && now() - sentToRelayAt >= wait) {
    sentToRelayAt = now();
    hasUnsentNews = false;
    host.sendSnapshot(loop.snapshot(), loop.maze);
  }
}

function holdLock(isWanted: boolean): void {
  if (isWanted === (releaseLock !== null)) return;
  releaseLock?.();
  releaseLock = null;
  if (!isWanted) return;
  const held = new Promise<void>((resolve) => (releaseLock = resolve));
  // Without the Web Locks API (insecure origins) the robot runs all the same, but browsers may
  // freeze it.
  void navigator.locks?.request(LOCK_NAME, { mode: "shared" }, () => held);
}

guarded(() => {
  const project = earlyProject(worker.name);
  if (project === null) return;
  load(project);
  postUpdate();
});
