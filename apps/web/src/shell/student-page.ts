/**
 * A student's page inside the page for teachers: its own simulator, and storages that last as long as
 * it does. Nothing of it reaches the projects on this device, or the address.
 */
import type { i18n } from "i18next";
import type { AddressBar } from "../model/address/lesson-address.ts";
import { storeSwitches } from "../model/preferences/stored-switches.ts";
import { ProjectReader } from "../model/projects/project-reader.ts";
import { createScreenStore, type ScreenStore } from "../model/screen/screen-store.ts";
import type { Services } from "../model/services.ts";
import type { KeyValueStorage } from "../model/storage/key-value-storage.ts";
import { VolatileStorage } from "../model/storage/volatile-storage.ts";
import { createWorkerPool } from "../simulator/worker-pool.ts";
import { newVolatileSimulator, onSimulatorFailure } from "./boot/simulator-start.ts";
import { createServices } from "./create-services.ts";

/** A little more than a sixtieth of a second: the next frame has begun then. */
const FRAME_MS = 17;

/** What the page around it provides. */
export interface SurroundingPage {
  words: i18n;
  /** its theme is that of both pages */
  screen: ScreenStore;
  /** localStorage, for the user's switches */
  device: KeyValueStorage;
}

/** The address belongs to the page around it. */
const noAddressBar: AddressBar = {
  location: { pathname: "/", search: "", hash: "" },
  history: { pushState: () => undefined, replaceState: () => undefined, state: null },
  onMove: () => undefined,
};

export interface StudentPage {
  services: Services;
  /** Terminates the workers. */
  end: () => void;
}

export function openStudentPage({ words, screen: around, device }: SurroundingPage): StudentPage {
  const worker = newVolatileSimulator();
  const screen = screenLike(around);
  storeSwitches(screen, device);
  const pool = createWorkerPool();
  const services = createServices({
    worker,
    device: new VolatileStorage(),
    tab: new VolatileStorage(),
    words,
    screen,
    reader: new ProjectReader(),
    nextFrame: (task) => setTimeout(task, FRAME_MS),
    own: { pool, bar: noAddressBar },
  });
  onSimulatorFailure(worker, (reason) => {
    services.simulator.fail(reason || words.t("shell.failure.notLoaded"));
  });
  return {
    services,
    end: () => {
      worker.terminate();
      pool.close();
    },
  };
}

/** A screen of its own, whose theme is also that of the page around it. */
function screenLike(around: ScreenStore): ScreenStore {
  const screen = createScreenStore();
  const { theme, contrast } = around.getState();
  screen.setState({ theme, contrast });
  screen.subscribe((next, before) => {
    if (next.theme === before.theme && next.contrast === before.contrast) return;
    around.setState({ theme: next.theme, contrast: next.contrast });
  });
  return screen;
}
