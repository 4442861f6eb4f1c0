/**
 * The scripts of one robot by name, with what each did last: those that were heard not long ago, those
 * with an open line, and those that are away. How many are kept is bounded, whatever names they give.
 */
import { MAX_SCRIPTS, type CommandRecord, type ScriptView } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { keyId } from "../keys.ts";
import type { StoredScript } from "../store/session-store.ts";

/** A script without a line is not shown any more once it was silent for so long. */
const SHOWN_MS = 120_000;

interface Trace {
  script: StoredScript;
  connections: number;
  heardAt: number;
  /** requests that wait for their answer */
  waiting: number;
  last: ScriptView["last"];
}

export class ScriptList {
  readonly #clock: Clock;
  /** by id, the one that was heard last at the end */
  readonly #traces = new Map<string, Trace>();
  /** the one at the end: most are heard many times in a row */
  #newest: Trace | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** A script was heard, and waits for nothing. */
  spoke(script: StoredScript, now: number): void {
    this.#traceOf(script, now);
  }

  /** A script was heard. @returns to be called once its request is answered */
  heard(script: StoredScript): () => void {
    const trace = this.#traceOf(script);
    trace.waiting += 1;
    return () => {
      trace.waiting -= 1;
      trace.heardAt = this.#clock.now();
    };
  }

  /** A line of a script was opened. @returns to be called when it is closed */
  connected(script: StoredScript): () => void {
    const trace = this.#traceOf(script);
    trace.connections += 1;
    return () => {
      trace.connections -= 1;
    };
  }

  /** A script's command was taken. */
  sent(script: StoredScript, { seq, action }: CommandRecord): void {
    this.#traceOf(script).last = { seq, action };
  }

  /** @param away those that the owner has sent away; told first, however long ago that was */
  told(away: readonly StoredScript[]): ScriptView[] {
    const now = this.#clock.now();
    const isBlocked = (id: string): boolean => away.some((script) => script.id === id);
    const here = [...this.#traces.values()]
      .filter(({ script, connections, waiting, heardAt }) => {
        const isHere = connections > 0 || waiting > 0 || now - heardAt < SHOWN_MS;
        return isHere && !isBlocked(script.id);
      })
      .slice(-MAX_SCRIPTS)
      .map((trace) => ({
        ...view(trace.script),
        connections: trace.connections,
        silentMs: trace.waiting > 0 ? 0 : Math.max(0, now - trace.heardAt),
        last: trace.last,
        isBlocked: false,
      }));
    const gone = away.map((script) => ({
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
    const trace = known ?? { script, connections: 0, heardAt: 0, waiting: 0, last: null };
    trace.heardAt = now;
    if (trace === this.#newest) return trace;
    this.#newest = trace;
    this.#traces.delete(script.id);
    this.#traces.set(script.id, trace);
    if (known === undefined) this.#forgetOldest();
    return trace;
  }

  /** Scripts that give ever new names must not fill the memory. */
  #forgetOldest(): void {
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

/** The scripts of several relays as one list: the same one may have connections at each. */
export function mergedScripts(lists: readonly ScriptView[][]): ScriptView[] {
  const byId = new Map<string, ScriptView>();
  for (const script of lists.flat()) {
    const other = byId.get(script.id);
    byId.set(script.id, other === undefined ? script : merged(other, script));
  }
  const all = [...byId.values()];
  const here = all.filter(({ isBlocked }) => !isBlocked).toSorted(byHeard);
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

function byHeard(a: ScriptView, b: ScriptView): number {
  return (a.silentMs ?? Infinity) - (b.silentMs ?? Infinity);
}
