/**
 * Composition root of the page: the only place that builds the stores and the worker.
 * Components reach them through `useServices`.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { createContext, useContext } from "react";
import { createRemoteStore, type RemoteStore } from "../stores/remote-store.ts";
import { createRunStore, isDue, type RunStore } from "../stores/run-store.ts";
import { createScreenStore, type ScreenStore } from "../stores/screen-store.ts";
import { createWorkspaceStore, type WorkspaceStore } from "../stores/workspace-store.ts";
import { SimulatorClient, type WorkerPort } from "../worker/simulator-client.ts";

export interface Services {
  simulator: SimulatorClient;
  workspace: WorkspaceStore;
  run: RunStore;
  remote: RemoteStore;
  screen: ScreenStore;
}

/** Builds everything and connects it: documents flow to the worker, what it tells flows to the stores. */
export function createServices(
  worker: WorkerPort,
  maze: MazeDocument,
  program: ProgramDocument,
): Services {
  const simulator = new SimulatorClient(worker);
  const workspace = createWorkspaceStore(maze, program);
  const run = createRunStore();
  const remote = createRemoteStore();
  const screen = createScreenStore();

  let shownAt = Number.NEGATIVE_INFINITY;
  simulator.listen((message) => {
    switch (message.type) {
      case "frame": {
        const { snapshot } = message.frame;
        const now = performance.now();
        const isReset = message.frame.trailReset;
        if (!isDue(run.getState().snapshot, snapshot, now - shownAt) && !isReset) return;
        shownAt = now;
        run.setState(isReset ? { snapshot, moment: null } : { snapshot });
        return;
      }
      case "moment":
        run.setState({ moment: message.moment });
        return;
      case "remote":
        remote.setState(message.remote);
        return;
      case "fault":
        run.setState({ fault: message.reason });
        return;
      case "digest":
        return;
    }
  });

  simulator.send({ type: "load", maze, program });
  workspace.subscribe((next, before) => {
    if (next.maze !== before.maze) simulator.send({ type: "edit-maze", maze: next.maze });
    if (next.program !== before.program) {
      simulator.send({ type: "edit-program", program: next.program });
    }
  });
  return { simulator, workspace, run, remote, screen };
}

const ServicesContext = createContext<Services | null>(null);
export const ServicesProvider = ServicesContext.Provider;

export function useServices(): Services {
  const services = useContext(ServicesContext);
  if (services === null) throw new Error("useServices needs a ServicesProvider above it");
  return services;
}
