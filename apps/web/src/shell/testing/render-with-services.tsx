/**
 * Renders a component of the page with the page's own stores and services, for tests in a browser.
 * Only the worker is replaced: the test receives what the page sends to it, and answers in its place.
 */
import "../../ui/base.css";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import type { ReactNode } from "react";
import { I18nextProvider } from "react-i18next";
import { onTestFinished } from "vitest";
import { render } from "vitest-browser-react";
import { openProject } from "../../model/workspace/workspace-store.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import type { WorkerPort } from "../../simulator/simulator-client.ts";
import { frameOf } from "../../stage/testing/frame-of.ts";
import type { Frame } from "../../stage/drawing/frame.ts";
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import { ProjectReader } from "../../model/projects/project-reader.ts";
import type { Services } from "../../model/services.ts";
import { ServicesProvider } from "../../model/use-services.ts";
import { createServices } from "../create-services.ts";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";

export interface RenderedPart extends Services {
  /** messages to the worker since the component was rendered, except the numbers for the stage */
  sent: ToWorker[];
  /** a message of the worker */
  receive: (message: FromWorker) => void;
  /** the robot's state at the displayed tick; without changes it stands at tick 0 */
  show: (snapshot?: Partial<Snapshot>, frame?: Partial<Frame>) => void;
}

interface Project {
  maze?: MazeDocument;
  program?: ProgramDocument;
}

/** Renders with an empty storage, the maze of a first visit and its program, unless others are given. */
export async function renderWithServices(
  ui: ReactNode,
  { maze, program }: Project = {},
): Promise<RenderedPart> {
  const sent: ToWorker[] = [];
  const worker: WorkerPort = {
    postMessage: (message) => {
      // The answer to each frame, for the stage.
      if (message.type !== "stage-numbers") sent.push(message);
    },
    onmessage: null,
  };
  const words = createI18n(en);
  const services = createServices({
    worker,
    device: new MemoryStorage(),
    tab: new MemoryStorage(),
    words,
    screen: createScreenStore(),
    reader: new ProjectReader(),
    nextFrame: (task) => task(),
  });
  const { workspace } = services;
  const first = workspace.getState();
  openProject(workspace, maze ?? first.maze, program ?? first.program);
  const receive = (data: FromWorker): void => worker.onmessage?.({ data } as MessageEvent);
  await render(
    <I18nextProvider i18n={words}>
      <ServicesProvider value={services}>{ui}</ServicesProvider>
    </I18nextProvider>,
  );
  onTestFinished(() => services.projects.autosave.flush());
  sent.length = 0;
  return {
    ...services,
    sent,
    receive,
    show: (change, frame) => {
      const snapshot = snapshotOf({ tick: 0, state: "paused", driver: "program", ...change });
      receive({ type: "frame", frame: frameOf({ snapshot, ...frame }), timeline: null });
    },
  };
}
