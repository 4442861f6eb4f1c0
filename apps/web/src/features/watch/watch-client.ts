/** The client of the worker on a viewer's page. */
import type { StageLink } from "../../stage/page/stage-screen.ts";
import type { StageToWorker } from "../../stage/stage-messages.ts";
import type {
  FromWatcher,
  ToWatcher,
  WatchedRobot,
} from "../../simulator/protocol/watch-messages.ts";
import { seeSnapshot, type WatchStore } from "./watch-store.ts";

/** The part of Worker that is used here. */
interface WatchPort {
  postMessage(message: ToWatcher, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromWatcher>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

export class WatchClient implements StageLink {
  readonly #port: WatchPort;
  readonly #store: WatchStore;
  readonly #listeners = new Set<Parameters<StageLink["listen"]>[0]>();

  /** @param store receives the state of the robot */
  constructor(port: WatchPort, store: WatchStore) {
    this.#port = port;
    this.#store = store;
    port.onmessage = ({ data }) => {
      switch (data.type) {
        case "watch-status":
          return store.setState(({ line: { isAgain } }) => {
            const { status } = data;
            const isLine = status.kind === "connected" || status.kind === "lost";
            return { line: { ...status, isAgain: isAgain || isLine } };
          });
        case "watch-snapshot":
          store.setState((state) => seeSnapshot(state, data.snapshot));
          port.postMessage({ type: "stage-numbers", snapshot: data.snapshot }, []);
          return;
        case "watch-marks":
          return store.setState({ hasMarks: true });
        case "watch-maze":
          return store.setState({ maze: data.maze });
        case "picture":
        case "stage-scroll-to":
          for (const listener of this.#listeners) listener(data);
      }
    };
    port.onerror = () => store.setState({ isBroken: true });
  }

  watch(robot: WatchedRobot): void {
    this.#port.postMessage({ type: "watch", robot }, []);
  }

  /** Stops watching. */
  stop(): void {
    this.#port.postMessage({ type: "watch", robot: null }, []);
  }

  showMarks(showsMarks: boolean): void {
    this.#store.setState({ showsMarks });
    this.#port.postMessage({ type: "hide-marks", isHidden: !showsMarks }, []);
  }

  /** Reconnects now, because the device is online again. */
  tryAgain(): void {
    this.#port.postMessage({ type: "watch-again" }, []);
  }

  send(message: StageToWorker, transfer: Transferable[] = []): void {
    this.#port.postMessage(message, transfer);
  }

  listen(listener: Parameters<StageLink["listen"]>[0]): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
