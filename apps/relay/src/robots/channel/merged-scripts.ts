/** Merges the presence of a robot's scripts at several relays. */
import { MAX_SCRIPTS, type AliveDriver, type ScriptView } from "@corridor/protocol";
import type { Scripts } from "../../bus/bus.ts";
import { MAX_REPORTED } from "../presence/presence.ts";

/** The same scripts after a time. */
export function older({ silentMs, alive, scripts, ...rest }: Scripts, ms: number): Scripts {
  return {
    ...rest,
    scripts: scripts.map((each) => ({
      ...each,
      silentMs: each.silentMs === null ? null : each.silentMs + ms,
    })),
    silentMs: silentMs === null ? null : silentMs + ms,
    alive: alive.map((each) => ({
      ...each,
      silentMs: each.silentMs + ms,
      connectionMs: each.connectionMs === null ? null : each.connectionMs + ms,
    })),
  };
}

/** The scripts of two relays. */
export function together(a: Scripts, b: Scripts): Scripts {
  const newest = (a.silentMs ?? Infinity) <= (b.silentMs ?? Infinity) ? a : b;
  const alive = new Map<string, AliveDriver>();
  for (const each of [...a.alive, ...b.alive].toSorted((c, d) => d.silentMs - c.silentMs)) {
    const connections = [each.connectionMs, alive.get(each.driver)?.connectionMs].filter(
      (ms) => typeof ms === "number",
    );
    alive.set(each.driver, {
      ...each,
      connectionMs: connections.length > 0 ? Math.min(...connections) : null,
    });
  }
  const { client, silentMs } = newest;
  const connected = a.connected + b.connected;
  const scripts = mergedScripts([a.scripts, b.scripts]);
  return { connected, client, silentMs, scripts, alive: [...alive.values()].slice(-MAX_REPORTED) };
}

/** Merges the scripts of several relays. A script may have connections at each of them. */
function mergedScripts(lists: readonly ScriptView[][]): ScriptView[] {
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
  const isNewer = (a.lastProblem?.at ?? "") >= (b.lastProblem?.at ?? "");
  const times = [a.silentMs, b.silentMs].filter((ms) => ms !== null);
  const silentMs = times.length > 0 ? Math.min(...times) : null;
  return {
    ...a,
    connections: a.connections + b.connections,
    silentMs,
    last,
    lastProblem: isNewer ? a.lastProblem : b.lastProblem,
    isBlocked: a.isBlocked || b.isBlocked,
  };
}

function byActivity(a: ScriptView, b: ScriptView): number {
  return (a.silentMs ?? Infinity) - (b.silentMs ?? Infinity);
}
