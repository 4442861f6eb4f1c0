/**
 * This page's robot at the relay: when to connect, and the session with which a reload retains the
 * robot's address. The session contains keys, so it is stored in sessionStorage.
 */
import type { RemoteStore } from "./remote-store.ts";
import type { RunStore } from "../run/run-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const SESSION_KEY = "corridor.remote";
/** Stored while Remote drives and is connected, so that a reload resumes both. */
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
  /** the simulation started with this page: no command of a session is still running */
  #isFresh = true;
  /** requested, without a report from the worker yet */
  #isOpening = false;
  /** Remote drove when the page was reloaded */
  #resumes: boolean;

  /** Connects whenever the driver becomes remote and nothing is connected. */
  constructor(ports: RemotePorts) {
    this.#ports = ports;
    const { run, remote, tab } = ports;
    this.#resumes = tab.getItem(DRIVING_KEY) !== null && readSession(tab) !== null;
    run.subscribe(({ nowDriver: driver }, before) => {
      if (driver === null || driver === before.nowDriver) return;
      if (driver === "me") this.#resumes = false;
      if (this.#resumes) return;
      if (driver !== "remote") return tab.removeItem(DRIVING_KEY);
      if (remote.getState().status.kind === "off" && !this.#isOpening) this.connect();
      else store(tab, DRIVING_KEY, "yes");
    });
    remote.subscribe(({ session, status }, before) => {
      if (status.kind !== "off") this.#isOpening = false;
      if (status.kind === "over") tab.removeItem(SESSION_KEY);
      else if (session !== null && session !== before.session) {
        store(tab, SESSION_KEY, JSON.stringify(session));
      }
    });
  }

  /**
   * Lets Remote drive again if it drove before a reload. Called once the previous run is restored:
   * a restored run ends with another driver, and no run is restored while somebody drives.
   */
  resume(): void {
    if (!this.#resumes) return;
    this.#resumes = false;
    this.connect();
  }

  /** Opens this tab's robot again or requests a new one. The driver stays. */
  open(): void {
    const { simulator, tab } = this.#ports;
    this.#isOpening = true;
    simulator.send({ type: "remote-open", session: readSession(tab), fresh: this.#isFresh });
    this.#isFresh = false;
  }

  /** Lets Remote drive, and opens the robot. */
  connect(): void {
    const { simulator, run, tab } = this.#ports;
    store(tab, DRIVING_KEY, "yes");
    this.open();
    // Commands are rejected while another driver has the robot.
    if (run.getState().nowDriver !== "remote") {
      simulator.send({ type: "driver", driver: "remote" });
    }
  }

  /** The device is online again: reconnects a robot whose connection was lost. */
  reconnect(): void {
    const { remote, run } = this.#ports;
    const isLost = remote.getState().status.kind === "lost";
    if (isLost && run.getState().nowDriver === "remote") this.connect();
  }

  /** Closes the connection; the address remains this tab's own and works again after connecting. */
  disconnect(): void {
    const { simulator, tab } = this.#ports;
    this.#isOpening = false;
    tab.removeItem(DRIVING_KEY);
    simulator.send({ type: "remote-close" });
  }
}

/** The session of this tab; null if it is missing or unreadable. */
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

function store(tab: KeyValueStorage, key: string, text: string): void {
  try {
    tab.setItem(key, text);
  } catch {
    // A reload then requests a new address; until then this one works.
  }
}

function isText(value: unknown): value is string {
  return typeof value === "string" && value !== "" && value.length <= MAX_TEXT_LENGTH;
}
