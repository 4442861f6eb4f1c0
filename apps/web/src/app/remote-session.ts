/**
 * This page's robot at the relay: when to connect, and the session that lets a reload keep the
 * robot's address. The session holds keys, so it stays in the tab's own storage.
 */
import type { RemoteStore } from "../stores/remote-store.ts";
import type { RunStore } from "../stores/run-store.ts";
import type { SimulatorClient } from "../worker/simulator-client.ts";
import type { RemoteSession } from "../worker/worker-messages.ts";
import type { KeyValueStorage } from "./works.ts";

const SESSION_KEY = "corridor.remote";
/** There while Remote drives and is connected, so that a reload goes on with both. */
const DRIVING_KEY = "corridor.remote.driving";
const MAX_TEXT_LENGTH = 512;

export interface RemotePorts {
  simulator: Pick<SimulatorClient, "send">;
  remote: RemoteStore;
  run: RunStore;
  /** sessionStorage */
  tab: KeyValueStorage;
}

export class RemoteConnection {
  readonly #ports: RemotePorts;
  /** the simulation began with this page: nothing that a session knows of is still running */
  #isFresh = true;
  /** asked for, and no word from the worker yet */
  #isOpening = false;
  /** Remote drove when the page was reloaded */
  #goesOn: boolean;

  /** Connects by itself whenever the driver becomes remote and nothing is connected. */
  constructor(ports: RemotePorts) {
    this.#ports = ports;
    const { run, remote, tab } = ports;
    this.#goesOn = tab.getItem(DRIVING_KEY) !== null && readSession(tab) !== null;
    run.subscribe(({ nowDriver: driver }, before) => {
      if (driver === null || driver === before.nowDriver) return;
      if (driver === "me") this.#goesOn = false;
      if (this.#goesOn) return;
      if (driver !== "remote") return tab.removeItem(DRIVING_KEY);
      keep(tab, DRIVING_KEY, "yes");
      if (remote.getState().status.kind === "off" && !this.#isOpening) this.connect();
    });
    remote.subscribe(({ session, status }, before) => {
      if (status.kind !== "off") this.#isOpening = false;
      if (status.kind === "over") tab.removeItem(SESSION_KEY);
      else if (session !== null && session !== before.session) {
        keep(tab, SESSION_KEY, JSON.stringify(session));
      }
    });
  }

  /**
   * Lets Remote drive again where it drove before a reload. Called once the run of before is back: one that
   * is opened ends with another driver, and is not opened at all where somebody drives already.
   */
  goOn(): void {
    if (!this.#goesOn) return;
    this.#goesOn = false;
    this.connect();
  }

  /** Lets Remote drive, and opens the robot of this tab again or asks for a new one. */
  connect(): void {
    const { simulator, run, tab } = this.#ports;
    this.#isOpening = true;
    simulator.send({ type: "remote-open", session: readSession(tab), fresh: this.#isFresh });
    this.#isFresh = false;
    // Commands are refused while another driver has the robot.
    if (run.getState().nowDriver !== "remote") {
      simulator.send({ type: "driver", driver: "remote" });
    }
  }

  /** The device has a network again: a robot that was lost without one is brought back by itself. */
  networkIsBack(): void {
    const { remote, run } = this.#ports;
    const isLost = remote.getState().status.kind === "lost";
    if (isLost && run.getState().nowDriver === "remote") this.connect();
  }

  /** Ends the connection; the address stays this tab's own and works again after connecting. */
  disconnect(): void {
    const { simulator, tab } = this.#ports;
    this.#isOpening = false;
    tab.removeItem(DRIVING_KEY);
    simulator.send({ type: "remote-close" });
  }
}

/** The session of this tab; null when there is none or it cannot be read. */
export function readSession(tab: KeyValueStorage): RemoteSession | null {
  const text = tab.getItem(SESSION_KEY);
  if (text === null) return null;
  let input: unknown;
  try {
    input = JSON.parse(text);
  } catch {
    return null;
  }
  if (typeof input !== "object" || input === null) return null;
  const { id, ownerKey, driverKey, address, lastApplied } = input as Record<string, unknown>;
  if (!isText(id) || !isText(ownerKey) || !isText(driverKey) || !isText(address)) return null;
  if (typeof lastApplied !== "number" || !Number.isSafeInteger(lastApplied)) return null;
  return lastApplied < 0 ? null : { id, ownerKey, driverKey, address, lastApplied };
}

function keep(tab: KeyValueStorage, key: string, text: string): void {
  try {
    tab.setItem(key, text);
  } catch {
    // A reload then asks for a new address; until then this one works.
  }
}

function isText(value: unknown): value is string {
  return typeof value === "string" && value !== "" && value.length <= MAX_TEXT_LENGTH;
}
