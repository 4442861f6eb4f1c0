/** The stores and services of the page. `shell/create-services.ts` creates and connects them. */
import type { SimulatorClient } from "../simulator/simulator-client.ts";
import type { AdviceStore } from "./advice/advice-store.ts";
import type { SolvedStore } from "./presets/solved-storage.ts";
import type { Speech } from "./speech/speech.ts";
import type { LessonsEntry } from "./lessons/lessons-entry.ts";
import type { CameraStore } from "./screen/camera-store.ts";
import type { CardDock, CardStore } from "./run/card-store.ts";
import type { ChallengeStore } from "./challenge/challenge-store.ts";
import type { ClassStore } from "./classes/class-store.ts";
import type { RaceStore } from "./run/race-store.ts";
import type { RemoteStore } from "./remote/remote-store.ts";
import type { RunStore } from "./run/run-store.ts";
import type { ScreenStore } from "./screen/screen-store.ts";
import type { TimelineStore } from "./run/timeline-store.ts";
import type { RunTrace } from "./run/run-trace.ts";
import type { WorkspaceStore } from "./workspace/workspace-store.ts";
import type { RemoteConnection } from "./remote/remote-session.ts";
import type { RunRestorer } from "./run/run-restorer.ts";
import type { ProjectService } from "./projects/project-service.ts";

export interface Services {
  simulator: SimulatorClient;
  workspace: WorkspaceStore;
  run: RunStore;
  /** the run for output without readings, one frame later: see deferred-run.ts */
  deferred: RunStore;
  /** explanations of the run */
  cards: CardStore;
  cardDock: CardDock;
  timeline: TimelineStore;
  remote: RemoteStore;
  race: RaceStore;
  screen: ScreenStore;
  /** the displayed run with its trail */
  runTrace: RunTrace;
  projects: ProjectService;
  /** restores the run after a reload */
  restorer: RunRestorer;
  /** presets that were solved on this device */
  solved: SolvedStore;
  /** advice of the coach for the program's lines */
  advice: AdviceStore;
  connection: RemoteConnection;
  /** the open challenge, if any */
  challenge: ChallengeStore;
  /** the class that this tab has joined, if any */
  classes: ClassStore;
  lessons: LessonsEntry;
  /** camera of the stage */
  camera: CameraStore;
  /** the live region for screen readers */
  speech: Speech;
}
