/** What the page provides to the lessons. */
import type { i18n } from "i18next";
import type { ProjectService } from "../../app/project-service.ts";
import type { ChallengeStore } from "../../stores/challenge-store.ts";
import type { ScreenStore } from "../../stores/screen-store.ts";
import type { WorkspaceStore } from "../../stores/workspace-store.ts";
import type { SimulatorClient } from "../../worker/simulator-client.ts";
import type { LessonsStorage } from "./lessons-storage.ts";

export interface LessonsPorts {
  simulator: Pick<SimulatorClient, "send" | "listen">;
  workspace: WorkspaceStore;
  screen: ScreenStore;
  projects: Pick<
    ProjectService,
    "begin" | "beginNew" | "open" | "backAction" | "list" | "currentId"
  >;
  challenge: ChallengeStore;
  storage: LessonsStorage;
  words: Pick<i18n, "t" | "loadNamespaces">;
}
