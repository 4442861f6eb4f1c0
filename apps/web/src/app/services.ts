/**
 * Composition root of the page: the only place that builds the stores and the worker.
 * Components reach them through `useServices`.
 */
import type { i18n } from "i18next";
import { createContext, useContext } from "react";
import { createAdviceStore, type AdviceStore } from "../features/program/advice-store.ts";
import { followLanguage } from "../features/program/follow-language.ts";
import { namedAfterEdit } from "../features/program/own-program.ts";
import { createSolvedStore, type SolvedStore } from "../features/presets/solved-presets.ts";
import { Speech } from "../features/speech/speech.ts";
import { LessonsGate } from "../features/lessons/lessons-gate.ts";
import { LessonsStorage } from "../features/lessons/lessons-storage.ts";
import { createCameraStore, type CameraStore } from "../stores/camera-store.ts";
import {
  createCardDock,
  createCardStore,
  explain,
  truncateCards,
  type CardDock,
  type CardStore,
} from "../stores/card-store.ts";
import { createChallengeStore, type ChallengeStore } from "../stores/challenge-store.ts";
import { createEventThrottle } from "../stores/event-throttle.ts";
import { DeferredRun } from "../stores/deferred-run.ts";
import { createRaceStore, type RaceStore } from "../stores/race-store.ts";
import { createRemoteStore, type RemoteStore } from "../stores/remote-store.ts";
import { createRunStore, type RunStore } from "../stores/run-store.ts";
import { showMessage, type ScreenStore } from "../stores/screen-store.ts";
import { TimelineStore } from "../stores/timeline-store.ts";
import { RunTrace } from "../stores/run-trace.ts";
import { createWorkspaceStore, type WorkspaceStore } from "../stores/workspace-store.ts";
import { SimulatorClient, type WorkerPort } from "../worker/simulator-client.ts";
import type { RunEvent } from "../worker/worker-messages.ts";
import { CurrentWork } from "./current-work.ts";
import { firstWork } from "./first-visit.ts";
import { RemoteConnection } from "./remote-session.ts";
import { RunKeeper } from "./run-keeper.ts";
import { whenSettled } from "./settled.ts";
import type { WorkReader } from "./work-reader.ts";
import { sendEdits } from "./send-edits.ts";
import { WorksService } from "./works-service.ts";
import { WorkShelf, type KeyValueStorage } from "./works.ts";

/** What the page is given by the browser; tests give other ones. */
export interface Browser {
  /** does something one frame later, whether or not there is anything to draw until then */
  nextFrame: (work: () => void) => void;
  worker: WorkerPort;
  /** localStorage: what stays on the device */
  device: KeyValueStorage;
  /** sessionStorage: what stays in this tab */
  tab: KeyValueStorage;
  /** already in the reader's language */
  words: Pick<i18n, "t" | "on" | "language" | "loadNamespaces">;
  screen: ScreenStore;
  /** reads stored works; loaded already where something is stored */
  reader: WorkReader;
}

export interface Services {
  simulator: SimulatorClient;
  workspace: WorkspaceStore;
  run: RunStore;
  /** the run for what is not urgent and has no numbers: see late-run.ts */
  lateRun: RunStore;
  /** what there is to explain of the run */
  cards: CardStore;
  cardDock: CardDock;
  timeline: TimelineStore;
  remote: RemoteStore;
  race: RaceStore;
  screen: ScreenStore;
  /** the run as the screen shows it, with its trail */
  shownRun: RunTrace;
  works: WorksService;
  /** keeps the run over a reload */
  runKeeper: RunKeeper;
  /** ready-made mazes that were solved on this device */
  solved: SolvedStore;
  /** what the coach says about the program's lines */
  advice: AdviceStore;
  connection: RemoteConnection;
  /** the challenge that is open, if any */
  challenge: ChallengeStore;
  lessons: LessonsGate;
  /** how the stage looks at the maze */
  camera: CameraStore;
  /** the one voice for those who listen */
  speech: Speech;
}

/** Builds everything and connects it: documents flow to the worker, what it tells flows to the stores. */
export function createServices(browser: Browser): Services {
  const { worker, device, tab, words, screen, reader, nextFrame } = browser;
  const shelf = new WorkShelf(device, () => reader.read);
  const first = firstWork(words);
  const current = new CurrentWork(
    { shelf, tab, now: Date.now, newId: newTextId },
    first.maze,
    first.program,
  );
  const { maze, program } = current.work;
  const simulator = new SimulatorClient(worker);
  const workspace = createWorkspaceStore(maze, program, (before, after) =>
    namedAfterEdit(before, after, words),
  );
  const run = createRunStore();
  followLanguage({ workspace, run }, words);
  const late = new DeferredRun(run, nextFrame);
  const cards = createCardStore();
  const cardDock = createCardDock();
  const challenge = createChallengeStore();
  const camera = createCameraStore();
  const remote = createRemoteStore();
  const shownRun = new RunTrace();

  const now = () => performance.now();
  const later = (action: () => void, milliseconds: number) => setTimeout(action, milliseconds);
  const show = (event: RunEvent | null) => run.setState({ event });
  const moments = createEventThrottle({ show, now, later });
  const timeline = new TimelineStore();
  simulator.listen((message) => {
    switch (message.type) {
      case "frame": {
        const { snapshot, progress, view, nowTick, waited, nowDriver } = message.frame;
        shownRun.add(message.frame);
        run.setState({ snapshot, progress, view, nowTick, waited, nowDriver });
        simulator.send({ type: "stage-numbers", snapshot });
        const news = message.timeline;
        if (news !== null) late.with(() => timeline.add(news));
        return;
      }
      case "forgotten":
        moments.truncate(message.after);
        truncateCards(cards, message.after);
        return;
      case "event":
        moments.push(message.event);
        explain(cards, message.event, workspace.getState().program);
        return;
      case "diagnosed":
        // In a challenge its own card says it.
        if (challenge.getState().challenge !== null) return;
        void import("../features/cards/tell-diagnosis.ts").then(
          ({ tellDiagnosis }) =>
            tellDiagnosis({ screen, workspace, run, timeline, words }, message.diagnosis),
          () => undefined,
        );
        return;
      case "remote":
        remote.setState(message.remote);
        return;
      case "shown-maze":
        run.setState({ pastMaze: message.maze });
        return;
      case "fault":
        run.setState({ fault: message.reason });
        return;
      case "digest":
      case "judgement":
      case "picture":
      case "stage-scroll-to":
      case "run-key":
      case "run-saved":
      case "run-loading":
      case "ghost-added":
      case "run-loaded":
        return;
    }
  });

  simulator.send({ type: "load", maze, program });
  sendEdits(workspace, simulator);
  const works = new WorksService({
    shelf,
    current,
    workspace,
    screen,
    simulator,
    words,
    later,
  });
  const runKeeper = new RunKeeper({
    simulator,
    workspace,
    tab,
    onNotStored: () => showMessage(screen, { tone: "bad", text: words.t("timeline.notStored") }),
    onLost: () => showMessage(screen, { tone: "bad", text: words.t("timeline.notKept") }),
  });
  const connection = new RemoteConnection({ simulator, remote, run, tab });
  const solved = createSolvedStore({ run, workspace, device });
  // The program of a first visit needs no advice, and the first tick needs the line.
  const settled = whenSettled(run);
  const load = async () => {
    await settled;
    return import("../features/program/coach.ts");
  };
  const advice = createAdviceStore({
    workspace,
    load,
    later,
    challenge,
    run,
  });
  const speech = new Speech({ now, later });
  const storage = new LessonsStorage(device);
  const lessons = new LessonsGate({
    simulator,
    workspace,
    screen,
    works,
    challenge,
    storage,
    words,
  });
  return {
    advice,
    camera,
    cards,
    cardDock,
    simulator,
    workspace,
    run,
    lateRun: late.words,
    timeline,
    remote,
    race: createRaceStore(),
    screen,
    shownRun,
    works,
    runKeeper,
    solved,
    connection,
    challenge,
    lessons,
    speech,
  };
}

/** A random id. Not crypto.randomUUID: pages that are not secure do not have it. */
function newTextId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

const ServicesContext = createContext<Services | null>(null);
export const ServicesProvider = ServicesContext.Provider;

export function useServices(): Services {
  const services = useContext(ServicesContext);
  if (services === null) throw new Error("useServices needs a ServicesProvider above it");
  return services;
}
