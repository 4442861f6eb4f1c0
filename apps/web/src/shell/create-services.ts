/**
 * Composition root of the page: the only place that creates the stores. Components access them
 * through `useServices`.
 */
import type { i18n } from "i18next";
import { createAdviceStore } from "../model/advice/advice-store.ts";
import { followLanguage } from "../model/projects/follow-language.ts";
import { namedAfterEdit } from "../model/workspace/own-program.ts";
import { createSolvedStore } from "../model/presets/solved-presets.ts";
import { Speech } from "../model/speech/speech.ts";
import { LessonsEntry } from "../model/lessons/lessons-entry.ts";
import type { LessonsPorts } from "../model/lessons/lessons-ports.ts";
import { LessonsStorage } from "../model/lessons/lessons-storage.ts";
import { createCameraStore } from "../model/screen/camera-store.ts";
import {
  createCardDock,
  createCardStore,
  explain,
  truncateCards,
} from "../model/run/card-store.ts";
import { createChallengeStore } from "../model/challenge/challenge-store.ts";
import { createClassStore } from "../model/classes/class-store.ts";
import { createEventThrottle } from "../model/run/event-throttle.ts";
import { DeferredRun } from "../model/run/deferred-run.ts";
import { createRaceStore } from "../model/run/race-store.ts";
import { createRemoteStore } from "../model/remote/remote-store.ts";
import { createRunStore, truncateRun } from "../model/run/run-store.ts";
import { showMessage, type ScreenStore } from "../model/screen/screen-store.ts";
import { TimelineStore } from "../model/run/timeline-store.ts";
import { RunTrace } from "../model/run/run-trace.ts";
import { createWorkspaceStore } from "../model/workspace/workspace-store.ts";
import { SimulatorClient, type WorkerPort } from "../simulator/simulator-client.ts";
import type { RunEvent } from "../simulator/protocol/worker-messages.ts";
import { CurrentProject } from "../model/projects/current-project.ts";
import { firstProject } from "../model/projects/first-visit.ts";
import { RemoteConnection } from "../model/remote/remote-session.ts";
import { RunRestorer } from "../model/run/run-restorer.ts";
import { whenIdle } from "./boot/page-idle.ts";
import type { ProjectReader } from "../model/projects/project-reader.ts";
import type { Services } from "../model/services.ts";
import { sendEdits } from "../model/workspace/send-edits.ts";
import { ProjectService } from "../model/projects/project-service.ts";
import { ProjectStorage } from "../model/projects/project-storage.ts";
import type { KeyValueStorage } from "../model/storage/key-value-storage.ts";
import { newTextId } from "../model/storage/new-text-id.ts";

/** Dependencies from the browser; tests inject others. */
export interface Browser {
  /** runs a task one frame later, whether or not there is anything to draw */
  nextFrame: (work: () => void) => void;
  worker: WorkerPort;
  /** localStorage: per device */
  device: KeyValueStorage;
  /** sessionStorage: per tab */
  tab: KeyValueStorage;
  /** already translated */
  words: Pick<i18n, "t" | "on" | "language" | "loadNamespaces">;
  screen: ScreenStore;
  /** parser of stored projects; already loaded if something is stored */
  reader: ProjectReader;
  /** see `LessonsPorts` */
  own?: LessonsPorts["own"];
}

/** Creates and connects everything: documents flow to the worker, its messages to the stores. */
export function createServices(browser: Browser): Services {
  const { worker, device, tab, words, screen, reader, nextFrame, own } = browser;
  const store = new ProjectStorage(device, () => reader.read);
  const first = firstProject(words);
  const current = new CurrentProject(
    { store, tab, now: Date.now, newId: newTextId },
    first.maze,
    first.program,
  );
  const { maze, program } = current.project;
  const simulator = new SimulatorClient(worker);
  const workspace = createWorkspaceStore(maze, program, (before, after) =>
    namedAfterEdit(before, after, words),
  );
  const run = createRunStore();
  followLanguage({ workspace, run }, words);
  const deferredRun = new DeferredRun(run, nextFrame);
  const cards = createCardStore();
  const cardDock = createCardDock();
  const challenge = createChallengeStore();
  const camera = createCameraStore();
  const remote = createRemoteStore();
  const runTrace = new RunTrace();

  const now = () => performance.now();
  const later = (action: () => void, milliseconds: number) => setTimeout(action, milliseconds);
  const show = (event: RunEvent | null) => run.setState({ event });
  const events = createEventThrottle({ show, now, later });
  const timeline = new TimelineStore();
  simulator.listen((message) => {
    const { type } = message;
    if (type === "frame") {
      const { snapshot, hasEnded, progress, view, nowTick, waited, nowDriver } = message.frame;
      runTrace.add(message.frame);
      const displayed = { snapshot, hasEnded, progress, view, nowTick, waited, nowDriver };
      run.setState({ ...displayed, isCut: false });
      simulator.send({ type: "stage-numbers", snapshot });
      const delta = message.timeline;
      if (delta !== null) deferredRun.with(() => timeline.add(delta));
    } else if (type === "truncated") {
      events.truncate(message.after);
      truncateCards(cards, message.after);
      truncateRun(run, message.after);
    } else if (type === "event") {
      events.push(message.event);
      explain(cards, message.event, workspace.getState().program);
    } else if (type === "diagnosed") {
      // In a challenge, its own card shows the diagnosis.
      if (challenge.getState().lesson !== null) return;
      void import("../features/cards/show-diagnosis.ts").then(
        ({ showDiagnosis }) =>
          showDiagnosis({ screen, workspace, run, timeline, words }, message.diagnosis),
        () => undefined,
      );
    } else if (type === "remote") remote.setState(message.remote);
    else if (type === "past-maze") run.setState({ pastMaze: message.maze });
    else if (type === "fault") run.setState({ fault: message.reason });
  });

  simulator.send({ type: "load", maze, program });
  sendEdits(workspace, simulator);
  const storage = new LessonsStorage(device);
  const projects = new ProjectService({
    store,
    tasks: storage,
    current,
    workspace,
    screen,
    simulator,
    words,
    later,
  });
  const restorer = new RunRestorer({
    simulator,
    workspace,
    tab,
    onNotStored: () => showMessage(screen, { tone: "bad", text: words.t("timeline.notStored") }),
    onLost: () => showMessage(screen, { tone: "bad", text: words.t("timeline.runLost") }),
  });
  const connection = new RemoteConnection({ simulator, remote, run, tab });
  const solved = createSolvedStore({ run, workspace, device });
  // The program of a first visit needs no advice, and the first tick needs the bandwidth.
  const idle = whenIdle(run);
  const load = async () => {
    await idle;
    return import("../model/advice/coach.ts");
  };
  const advice = createAdviceStore({
    workspace,
    load,
    later,
    challenge,
    run,
  });
  const speech = new Speech({ now, later });
  const lessons = new LessonsEntry({
    simulator,
    workspace,
    screen,
    run,
    projects,
    challenge,
    storage,
    device,
    words,
    own,
  });
  return {
    advice,
    camera,
    cards,
    cardDock,
    simulator,
    workspace,
    run,
    deferred: deferredRun.words,
    timeline,
    remote,
    race: createRaceStore(),
    screen,
    runTrace,
    projects,
    restorer,
    solved,
    connection,
    challenge,
    classes: createClassStore(),
    lessons,
    speech,
  };
}
