/**
 * Scripts of one robot by name, with their last command: recently active, connected and blocked
 * ones. The number of scripts is bounded, whatever names they send.
 */
import { MAX_SCRIPTS, type CommandRecord, type ScriptView } from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import { keyId } from "../../platform/keys.ts";
import type { StoredScript } from "../../store/port.ts";

/** A disconnected script is no longer listed after this much silence. */
const SHOWN_MS = 120_000;

interface Trace {
  script: StoredScript;
  connections: number;
  lastActiveAt: number;
  /** requests that wait for their response */
  waiting: number;
  last: ScriptView["last"];
}

export class ScriptList {
  readonly #clock: Clock;
  /** by id, least recently active first */
  readonly #traces = new Map<string, Trace>();
  /** the most recently active one; most scripts send many messages in a row */
  #newest: Trace | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Records a message of a script that waits for no response. */
  spoke(script: StoredScript, now: number): void {
    this.#traceOf(script, now);
  }

  /** Records a request of a script. @returns function to call once the request is answered */
  received(script: StoredScript): () => void {
    const trace = this.#traceOf(script);
    trace.waiting += 1;
    return () => {
      trace.waiting -= 1;
      trace.lastActiveAt = this.#clock.now();
    };
  }

  /** Records an opened connection of a script. @returns function to call when it closes */
  connected(script: StoredScript): () => void {
    const trace = this.#traceOf(script);
    trace.connections += 1;
    return () => {
      trace.connections -= 1;
    };
  }

  /** Records an accepted command of a script. */
  sent(script: StoredScript, { seq, action }: CommandRecord): void {
    this.#traceOf(script).last = { seq, action };
  }

  /** @param blocked blocked scripts; listed first, whenever they were active */
  report(blocked: readonly StoredScript[]): ScriptView[] {
    const now = this.#clock.now();
    const isBlocked = (id: string): boolean => blocked.some((script) => script.id === id);
    const here = [...this.#traces.values()]
      .filter(({ script, connections, waiting, lastActiveAt }) => {
        const isHere = connections > 0 || waiting > 0 || now - lastActiveAt < SHOWN_MS;
        return isHere && !isBlocked(script.id);
      })
      .slice(-MAX_SCRIPTS)
      .map((trace) => ({
        ...view(trace.script),
        connections: trace.connections,
        silentMs: trace.waiting > 0 ? 0 : Math.max(0, now - trace.lastActiveAt),
        last: trace.last,
        isBlocked: false,
      }));
    const gone = blocked.map((script) => ({
      ...view(script),
      connections: 0,
      silentMs: null,
      last: this.#traces.get(script.id)?.last ?? null,
      isBlocked: true,
    }));
    return [...gone, ...here];
  }

  #traceOf(script: StoredScript, now = this.#clock.now()): Trace {
    const known = this.#traces.get(script.id);
    const trace = known ?? { script, connections: 0, lastActiveAt: 0, waiting: 0, last: null };
    trace.lastActiveAt = now;
    if (trace === this.#newest) return trace;
    this.#newest = trace;
    this.#traces.delete(script.id);
    this.#traces.set(script.id, trace);
    if (known === undefined) this.#deleteOldest();
    return trace;
  }

  /** Bounds the memory for scripts that send ever new names. */
  #deleteOldest(): void {
    if (this.#traces.size <= 2 * MAX_SCRIPTS) return;
    for (const [id, { connections, waiting }] of this.#traces) {
      if (connections > 0 || waiting > 0) continue;
      this.#traces.delete(id);
      return;
    }
  }
}

function view({ id, driver, name, client }: StoredScript) {
  return { id, driver: keyId(driver), name, client };
}

/** Merges the scripts of several relays. A script may have connections at each of them. */
export function mergedScripts(lists: readonly ScriptView[][]): ScriptView[] {
  const byId = new Map<string, ScriptView>();
  for (const script of lists.flat()) {
    const other = byId.get(script.id);
    byId.set(script.id, other === undefined ? script : merged(other, script));
  }
  const all = [...byId.values()];
  const here = all.filter(({ isBlocked }) => !isBlocked).toSorted(byActivity);
  return [...all.filter(({ isBlocked }) => isBlocked), ...here.slice(0, MAX_SCRIPTS)];
}

function merged(a: ScriptView, b: ScriptView): ScriptView {
  const last = (a.last?.seq ?? 0) >= (b.last?.seq ?? 0) ? a.last : b.last;
  const times = [a.silentMs, b.silentMs].filter((ms) => ms !== null);
  const silentMs = times.length > 0 ? Math.min(...times) : null;
  return {
    ...a,
    connections: a.connections + b.connections,
    silentMs,
    last,
    isBlocked: a.isBlocked || b.isBlocked,
  };
}

function byActivity(a: ScriptView, b: ScriptView): number {
  return (a.silentMs ?? Infinity) - (b.silentMs ?? Infinity);
}
