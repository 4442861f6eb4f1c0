/**
 * Entry of the simulator worker: simulation, program and relay connection run here, so that they
 * continue while the page is hidden. A thin shell that handles the messages of the page; the logic
 * is in `run-loop.ts`, and in parts that load on first use.
 */
import { loadRaceGhosts } from "../../stage/layers/lazy-race-ghosts.ts";
import type { ClassSession } from "../protocol/class-messages.ts";
import { earlyProject, VOLATILE, type FirstProject } from "../protocol/first-project.ts";
import type { FromWorker, RemoteView, ToWorker } from "../protocol/worker-messages.ts";
import { afterMessages } from "./after-messages.ts";
import { describeFault } from "./describe-fault.ts";
import { Lazy } from "./lazy.ts";
import { PageFeed } from "./page-feed.ts";
import { startPulse } from "./pulse.ts";
import type { Race } from "./race.ts";
import { RecordedRuns } from "./recorded-runs.ts";
import type { RemoteHost } from "./remote-host.ts";
import { RunEvaluation } from "./run-evaluation.ts";
import { RunLoop } from "./run-loop.ts";
import { SimulationLock } from "./simulation-lock.ts";
import { StoredWorld } from "./stored-world.ts";
import { StagePainter } from "../../stage/stage-painter.ts";

/** Least milliseconds between two catch-ups before drawing. */
const RECENT_MS = 2;
/** Milliseconds until a part that did not load is loaded again. */
const RETRY_MS = 2_000;

/** The relay connection did not load. */
const unreachable: RemoteView = {
  status: { kind: "lost", reason: "connectionLost" },
  session: null,
  commands: [],
  scripts: [],
  isPaused: false,
  mayReset: true,
};

/** The same for the class. */
const unreachableClass: ClassSession = { status: { kind: "lost" }, student: null };

/** A message for the run, after the documents. */
type RunMessage = Exclude<
  ToWorker,
  { type: "load" | "digest" | "load-run" | "restore-run" | "run-key-noted" }
>;

const worker = self as unknown as DedicatedWorkerGlobalScope;
const post = (message: FromWorker): void => worker.postMessage(message);
const now = (): number => performance.now();

/** null before the documents have arrived */
let loop: RunLoop | null = null;
let advancedAt = Number.NEGATIVE_INFINITY;

const lock = new SimulationLock();
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

const feed = new PageFeed({
  post,
  draw: (frame) => painter.add({ ...frame, marks: relay.loaded?.marks }),
  now,
});
const evaluation = new RunEvaluation({
  post,
  guarded,
  later: (work) => setTimeout(() => guarded(work), RETRY_MS),
  onDiagnostics: postUpdate,
});

const relay = new Lazy(async () => {
  const { RelayConnection } = await import("./relay-connection.ts");
  return new RelayConnection({
    run: loadedRun(),
    now,
    origin: worker.location.origin,
    onView: (remote) => post({ type: "remote", remote }),
    save: () => world.save(),
    restored: () => world.restored,
  });
}, guarded);

const studentClass = new Lazy(
  async () =>
    (await import("./class-part.ts")).openClassPart(
      loadedRun,
      worker.location.origin,
      post,
      guarded,
    ),
  guarded,
);

const world = new StoredWorld({
  run: loadedRun,
  journal: () => relay.loaded?.journal ?? null,
  onClaimed: () => relay.loaded?.host.worldClaimed(),
  sendKey: (key) => post({ type: "run-key", key }),
  now,
});
const recorded = new RecordedRuns({
  run: loadedRun,
  world,
  post,
  guarded,
  onSlice: postUpdate,
  now,
});

const race = new Lazy(async () => {
  const [{ Race: Ghosts }] = await Promise.all([import("./race.ts"), loadRaceGhosts()]);
  const ghosts: Race = new Ghosts({
    now,
    later: afterMessages(() => guarded(() => ghosts.next())),
    post,
    onChange: () => {
      loop?.updates.raceWith(ghosts);
      postUpdate();
    },
  });
  return ghosts;
}, guarded);

const digests = new Lazy(() => import("./digest.ts"), guarded);

const postSoon = afterMessages(() => guarded(postUpdate));

worker.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  try {
    handle(data);
    // Of several requested ticks, only the newest is displayed: the others arrived before this
    // message.
    if (data.type === "seek") postSoon();
    else takeTurn();
  } catch (error) {
    reportFault(error);
  }
};

const takeTurn = startPulse(() => {
  guarded(() => {
    advance();
    lock.hold(loop?.isRunning === true);
  });
  return loop?.isRunning === true || (relay.loaded ?? studentClass.loaded) !== null;
});

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

function handle(message: ToWorker): void {
  if (message.type === "load") return load(message);
  if (message.type === "load-run") return recorded.open(message);
  if (message.type === "restore-run") return recorded.restore(message);
  if (message.type === "run-key-noted") return world.keyNoted(message.ok);
  if (message.type === "digest") {
    return digests.use(
      ({ digestOf }) => post({ type: "digest", digest: digestOf(message) }),
      reportFault,
    );
  }
  if (loop !== null) control(loop, message);
}

function control(run: RunLoop, message: RunMessage): void {
  switch (message.type) {
    case "edit-maze":
      return run.editMaze(message.maze);
    case "edit-program":
      return run.editProgram(message.program);
    case "run":
    case "run-here":
      return run.run();
    case "pause":
      return run.pause();
    case "step":
      return run.step(message.length);
    case "reset":
      recorded.cancel();
      return run.reset();
    case "judge":
      return evaluation.judge(run.updates, message);
    case "speed":
      return run.setSpeed(message.speed);
    case "driver":
      return run.setDriver(message.driver);
    case "offer-driver":
      return run.offerDriver(message.driver);
    case "hold":
      return run.hold(message.key);
    case "seek":
      return run.seek(message.tick);
    case "seek-step":
      return run.seekStep(message.by);
    case "play":
      return run.play();
    case "now":
      return run.now();
    case "save-run":
      return recorded.save(message.id);
    case "add-ghost":
      return race.use(
        (ghosts) => ghosts.add(message),
        () => post({ type: "ghost-added", id: message.id, added: { ok: false, problems: [] } }),
      );
    case "remove-ghost":
      return race.use((ghosts) => ghosts.remove(message.id));
    case "cancel-load":
      return recorded.cancel(message.id);
    case "class":
      return studentClass.use(
        (host) => host.handle(message.request),
        () => post({ type: "class", session: unreachableClass }),
      );
    case "class-pause":
      return run.suspend(message.isPaused);
    case "remote-open":
      return withHost((host) => host.open(message.session, message.fresh));
    case "remote-close":
      return withHost((host) => host.close());
    case "remote-clear":
      return withHost((host) => host.clearCommands());
    case "hide-marks":
      return relay.use((connection) => connection.hideMarks(message.isHidden));
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
    loop = new RunLoop(maze, program, () => performance.timeOrigin + now());
    // They load after the first tick.
    loop.updates.awaitDiagnostics(true);
    return;
  }
  loop.editMaze(maze);
  loop.editProgram(program);
}

/** @throws before the documents have arrived */
function loadedRun(): RunLoop {
  if (loop === null) throw new Error("a message came before the documents");
  return loop;
}

function withHost(use: (host: RemoteHost) => void): void {
  relay.use(
    ({ host }) => use(host),
    () => post({ type: "remote", remote: unreachable }),
  );
}

function postUpdate(): void {
  if (loop === null) return;
  const { updates } = loop;
  const update = updates.take();
  const hasChanged = update !== null;
  if (hasChanged && update.frame.nowTick > 0) evaluation.loadDiagnostics(updates);
  if (worker.name !== VOLATILE) world.update(hasChanged);
  feed.send(updates, update);
  evaluation.post(updates);
  relay.loaded?.update(hasChanged);
  studentClass.loaded?.update(hasChanged);
}

guarded(() => {
  const project = earlyProject(worker.name);
  if (project === null) return;
  load(project);
  postUpdate();
});
