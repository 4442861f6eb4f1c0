/**
 * Entry of the simulator worker: the simulation, the program and the relay link live here, so that
 * they keep going while the page is hidden. A thin shell; the logic is in `run-loop.ts` and
 * `remote-host.ts`.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Race } from "./race.ts";
import { loadRaceGhosts } from "../canvas/layers/lazy-race-ghosts.ts";
import { describeFault } from "./describe-fault.ts";
import { earlyWork, type FirstProject } from "./first-project.ts";
import { FramePace } from "./frame-pace.ts";
import type { RemoteHost } from "./remote-host.ts";
import type { RestoredJournal } from "./restored-world.ts";
import type { RunLoader } from "./run-loader.ts";
import { RunLoop } from "./run-loop.ts";
import { StagePainter } from "./stage-painter.ts";
import type {
  AddGhost,
  FromWorker,
  LoadedRun,
  RestoreRun,
  SavedRun,
  ToWorker,
} from "./worker-messages.ts";
import type { WorldKeeper } from "./world-keeper.ts";

/** Twice as often as a screen repaints, so that no frame waits for a whole interval. */
const INTERVAL_MS = 8;
/** Snapshots to the relay: at most this often while the robot moves, and so often while it stands. */
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
let shownMaze: MazeDocument | null = null;
/** of the newest challenge that the page asked to judge by */
let judgeId = 0;

/** The relay link comes in a file of its own when Remote is opened for the first time. */
let remote: RemoteHost | null = null;
let remoteLoading: Promise<RemoteHost> | null = null;

/** Does something with the relay link, in the order of the calls. */
function withRemote(use: (host: RemoteHost) => void): void {
  remoteLoading ??= loadRemote();
  void remoteLoading.then(
    (host) => guarded(() => use(host)),
    () => {
      // The file did not come: that is a lost line, and the next try asks for it again.
      remoteLoading = null;
      const status = { kind: "lost", reason: "lineLost" } as const;
      post({
        type: "remote",
        remote: { status, session: null, commands: [], scripts: [], isPaused: false },
      });
    },
  );
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
    takeBack: (seq, reason) => loop?.remote?.cancelOne(seq, reason),
    giveBack: () => loop?.remote?.reset(),
    hear: (alive) => loop?.remote?.renew(alive),
    save: saveWorld,
    restored: () => restored,
    fetch: (url, request) => fetch(url, request),
  });
  loop?.connect((robot) => new RemoteDriver(host, robot, now));
  remote = host;
  return host;
}

/** What stores the world comes in a file of its own once there is something to store. */
let keeper: WorldKeeper | null = null;
let keeperLoading: Promise<WorldKeeper> | null = null;
/** of the world that this tab had before a reload, if it was restored */
let restored: RestoredJournal | null = null;
const keyNotes: ((isNoted: boolean) => void)[] = [];

function noteKey(key: string | null): Promise<boolean> {
  post({ type: "run-key", key });
  return new Promise((resolve) => keyNotes.push(resolve));
}

function loadKeeper(): Promise<WorldKeeper> {
  keeperLoading ??= startKeeper();
  return keeperLoading;
}

async function startKeeper(): Promise<WorldKeeper> {
  try {
    const [{ WorldKeeper: Keeper }, { openWorldStore }] = await Promise.all([
      import("./world-keeper.ts"),
      import("./world-store.ts"),
    ]);
    keeper = new Keeper({
      openStore: () => openWorldStore(Date.now),
      recording: () => {
        if (loop === null) throw new Error("a world is stored before the documents came");
        return loop.recording;
      },
      journal: () => {
        const journal = remote?.journal ?? null;
        return journal === null ? restored : { ...journal, running: loop?.remote?.running ?? null };
      },
      noteKey,
      onClaimed: () => remote?.worldClaimed(),
      newId: () => crypto.getRandomValues(new Uint32Array(4)).join("-"),
      now,
      after: (milliseconds, call) => {
        const timer = setTimeout(call, milliseconds);
        return () => clearTimeout(timer);
      },
    });
    return keeper;
  } catch (error) {
    // Its file did not come: a reload restores nothing.
    await noteKey(null);
    throw error;
  }
}

/** Before an ending is sent. */
async function saveWorld(): Promise<void> {
  const loaded = await loadKeeper().catch(() => null);
  await loaded?.save();
}

async function restoreRun(message: RestoreRun): Promise<void> {
  const [storage, { restoreWorld }] = await Promise.all([
    loadKeeper(),
    import("./restored-world.ts"),
  ]);
  await restoreWorld(message, {
    keeper: storage,
    run: () => loop,
    load: (run, open) =>
      withLoader(
        (runs) => runs.load({ id: message.id, run }, open),
        () => failedLoad(message.id),
      ),
    answer: (loaded) => runLoaded(message.id, loaded),
    restored: (journal) => (restored = journal),
  });
}

function runLoaded(id: number, loaded: LoadedRun): void {
  keeper?.claimed();
  post({ type: "run-loaded", id, loaded });
}

const failedLoad = (id: number): void => runLoaded(id, { ok: false, reason: "fault" });

/** A run that was brought up to now so recently is not once more before it is drawn, in milliseconds. */
const RECENT_MS = 2;
let advancedAt = Number.NEGATIVE_INFINITY;

const pace = new FramePace(now);
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

/** Comes back after the messages that wait already. */
const afterMessages = new MessageChannel();
afterMessages.port1.onmessage = () => guarded(tellNews);

/** The same for the slices of a run that is opened. */
const afterSlice = new MessageChannel();
afterSlice.port1.onmessage = () =>
  guarded(() => {
    loader?.goOn();
    tellNews();
  });

/** What opens recorded runs comes in a file of its own with the first of them. */
let loader: RunLoader | null = null;
let loaderLoading: Promise<RunLoader> | null = null;

function withLoader(use: (runs: RunLoader) => void, orElse: () => void): void {
  loaderLoading ??= loadLoader();
  void loaderLoading.then(
    (runs) => guarded(() => use(runs)),
    () => {
      loaderLoading = null;
      orElse();
    },
  );
}

async function loadLoader(): Promise<RunLoader> {
  const { RunLoader: Loader } = await import("./run-loader.ts");
  loader = new Loader({
    now,
    later: () => afterSlice.port2.postMessage(null),
    tellPart: (id, part) => post({ type: "run-loading", id, part }),
    answer: runLoaded,
  });
  return loader;
}

/** The ghosts of a race come in a file of its own with the first of them. */
let raceLoading: Promise<Race> | null = null;

function withRace(use: (race: Race) => void, orElse: () => void): void {
  raceLoading ??= loadRace();
  void raceLoading.then(
    (race) => guarded(() => use(race)),
    () => {
      raceLoading = null;
      orElse();
    },
  );
}

async function loadRace(): Promise<Race> {
  const [{ Race: Ghosts }] = await Promise.all([import("./race.ts"), loadRaceGhosts()]);
  const slices = new MessageChannel();
  const race = new Ghosts({
    now,
    later: () => slices.port2.postMessage(null),
    post,
    onChange: () => {
      loop?.raceWith(race);
      tellNews();
    },
  });
  slices.port1.onmessage = () => guarded(() => race.goOn());
  return race;
}

function addGhost(message: AddGhost): void {
  withRace(
    (race) => race.add(message),
    () => post({ type: "ghost-added", id: message.id, added: { ok: false, problems: [] } }),
  );
}

worker.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  try {
    handle(data);
    // Of several moments that are asked for, only the newest is gone to: the others came before this.
    if (data.type === "seek") afterMessages.port2.postMessage(null);
    else advance();
  } catch (error) {
    post({ type: "fault", reason: describeFault(error) });
  }
};

setInterval(() => {
  guarded(() => {
    advance();
    holdLock(loop?.isRunning === true);
  });
}, INTERVAL_MS);

/** Brings the run up to now, and tells what came of it. */
function advance(): void {
  loop?.advance();
  advancedAt = now();
  tellNews();
}

/** What goes wrong pauses the robot and is told, instead of happening again on every turn. */
function guarded(work: () => void): void {
  try {
    work();
  } catch (error) {
    loop?.pause();
    post({ type: "fault", reason: describeFault(error) });
  }
}

function handle(message: ToWorker): void {
  if (message.type === "load") return load(message);
  if (message.type === "digest") {
    import("./digest.ts").then(
      ({ digestOf }) => guarded(() => post({ type: "digest", digest: digestOf(message) })),
      (error: unknown) => post({ type: "fault", reason: describeFault(error) }),
    );
    return;
  }
  if (message.type === "load-run") {
    return withLoader(
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
      if (loaderLoading !== null)
        withLoader(
          (runs) => runs.cancel(),
          () => undefined,
        );
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
      return withRace(
        (race) => race.remove(message.id),
        () => undefined,
      );
    case "cancel-load":
      return withLoader(
        (runs) => runs.cancel(message.id),
        () => undefined,
      );
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

/** A run that began before the page was there goes on: nothing but names can be new to it. */
function load({ maze, program }: FirstProject): void {
  if (loop === null) {
    loop = new RunLoop(maze, program, now);
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

/** The ticks that run until the judge is there are judged when it is. */
function judge(id: number, attempt: Extract<ToWorker, { type: "judge" }>["attempt"]): void {
  judgeId = id;
  loop?.judgeBy(null);
  if (attempt === null) return;
  const { challenge, maze } = attempt;
  void import("./run-judge.ts").then(
    ({ RunJudge }) => guarded(() => id === judgeId && loop?.judgeBy(new RunJudge(challenge, maze))),
    (error: unknown) => post({ type: "fault", reason: describeFault(error) }),
  );
}

/** What says why a run failed comes in a file of its own once the robot drives; without it runs go on unexplained. */
let hasAskedForDiagnostics = false;

function loadDiagnostics(): void {
  if (hasAskedForDiagnostics) return;
  hasAskedForDiagnostics = true;
  import("./diagnose-run.ts").then(
    (diagnostics) =>
      guarded(() => {
        loop?.useDiagnostics(diagnostics);
        tellNews();
      }),
    () => (hasAskedForDiagnostics = false),
  );
}

function tellNews(): void {
  const news = loop?.takeNews();
  if (loop === null || news === undefined) return;
  if (news !== null && news.frame.nowTick > 0) loadDiagnostics();
  if (keeper !== null) keeper.follow();
  else if (news !== null && !loop.isUntouched) void loadKeeper().catch(() => undefined);
  if (news !== null) {
    const { frame, forgottenAfter } = news;
    if (forgottenAfter !== null) post({ type: "truncated", after: forgottenAfter });
    painter.add(frame);
    pace.add(frame);
  }
  const frame = pace.take();
  if (frame !== null) {
    if (loop.shownMaze !== shownMaze) {
      shownMaze = loop.shownMaze;
      post({ type: "shown-maze", maze: shownMaze });
    }
    const corners = Float64Array.from(frame.corners);
    post({ type: "frame", frame: { ...frame, corners }, timeline: loop.takeTimeline() });
  }
  if (news !== null) {
    for (const event of news.moments) post({ type: "event", event });
    const diagnosed = loop.takeDiagnosed();
    if (diagnosed !== null) post({ type: "diagnosed", ...diagnosed });
  }
  const judgement = loop.takeJudgement();
  if (judgement !== null) post({ type: "judgement", id: judgeId, judgement });
  hasUnsentNews ||= news !== null;
  const wait = hasUnsentNews ? RELAY_INTERVAL_MS : RELAY_HEARTBEAT_MS;
  if (remote?.isOpen === true && now() - sentToRelayAt >= wait) {
    sentToRelayAt = now();
    hasUnsentNews = false;
    remote.sendSnapshot(loop.snapshot(), loop.maze);
  }
}

function holdLock(isWanted: boolean): void {
  if (isWanted === (releaseLock !== null)) return;
  releaseLock?.();
  releaseLock = null;
  if (!isWanted) return;
  const held = new Promise<void>((resolve) => (releaseLock = resolve));
  // Without the Web Locks API (insecure origins) the robot runs all the same, only less protected.
  void navigator.locks?.request(LOCK_NAME, { mode: "shared" }, () => held);
}

guarded(() => {
  const work = earlyWork(worker.name);
  if (work === null) return;
  load(work);
  tellNews();
});
