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

  /** Connects by itself whenever the driver becomes remote and nothing is connected. */
  constructor(ports: RemotePorts) {
    this.#ports = ports;
    const { run, remote, tab } = ports;
    run.subscribe(({ snapshot }, before) => {
      if (snapshot?.driver !== "remote" || before.snapshot?.driver === "remote") return;
      if (remote.getState().status.kind === "off") this.connect();
    });
    remote.subscribe(({ session, status }, before) => {
      if (status.kind === "over") forgetSession(tab);
      else if (session !== null && session !== before.session) keepSession(tab, session);
    });
  }

  /** Opens the robot of this tab again, or asks for a new one. */
  connect(): void {
    const { simulator, tab } = this.#ports;
    simulator.send({ type: "remote-open", session: readSession(tab), fresh: this.#isFresh });
    this.#isFresh = false;
  }

  /** Ends the connection; the address stays this tab's own and works again after connecting. */
  disconnect(): void {
    this.#ports.simulator.send({ type: "remote-close" });
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

function keepSession(tab: KeyValueStorage, session: RemoteSession): void {
  try {
    tab.setItem(SESSION_KEY, JSON.stringify(session));
  } catch {
    // A reload then asks for a new address; until then this one works.
  }
}

function forgetSession(tab: KeyValueStorage): void {
  tab.removeItem(SESSION_KEY);
}

function isText(value: unknown): value is string {
  return typeof value === "string" && value !== "" && value.length <= MAX_TEXT_LENGTH;
}
