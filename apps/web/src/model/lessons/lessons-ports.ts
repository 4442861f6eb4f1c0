/** What the page provides to the lessons. */
import type { i18n } from "i18next";
import type { ProjectService } from "../projects/project-service.ts";
import type { ChallengeStore } from "../challenge/challenge-store.ts";
import type { RunStore } from "../run/run-store.ts";
import type { ScreenStore } from "../screen/screen-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import type { AddressBar } from "../address/lesson-address.ts";
import type { LessonsStorage } from "./lessons-storage.ts";

export interface LessonsPorts {
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone">;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  run: Pick<RunStore, "getState" | "setState">;
  projects: Pick<
    ProjectService,
    "begin" | "beginNew" | "open" | "backAction" | "list" | "currentId" | "opened"
  >;
  challenge: ChallengeStore;
  storage: LessonsStorage;
  /** localStorage, for the lessons of several tasks */
  device: KeyValueStorage;
  words: Pick<i18n, "t" | "loadNamespaces">;
  /** in place of the page's own, for a student's page inside another one */
  own?: { pool: WorkerPool; bar: AddressBar } | undefined;
}
