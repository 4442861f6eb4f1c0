/**
 * The displayed tick with its description. It updates once a second while the robot runs, for
 * screen readers, and otherwise at once. A store, so that each component subscribes only to what it
 * displays.
 */
import { useLayoutEffect, useState } from "react";
import { createStore, type StoreApi } from "zustand";
import { useServices } from "./use-services.ts";
import { describeTick, type TickDescription } from "./run/tick-description.ts";
import { timelineOf } from "./run/timeline-of.ts";

const SECOND = 60;

export function useDisplayedTick(): StoreApi<TickDescription> {
  const { run, timeline } = useServices();
  const [store] = useState(() => createStore<TickDescription>(() => BEGINNING));
  useLayoutEffect(() => {
    let shown: TickDescription | null = null;
    const look = () => {
      const { snapshot } = run.getState();
      const tick = snapshot?.tick ?? 0;
      const isRunning = snapshot?.state === "running";
      if (shown !== null && isRunning && isSameSecond(tick, shown.tick)) return;
      const next = describeTick(timelineOf(timeline), tick, snapshot);
      if (shown !== null && isSame(shown, next)) return;
      shown = next;
      store.setState(next, true);
    };
    look();
    const ends = [run.subscribe(look), timeline.listen(look)];
    return () => {
      for (const end of ends) end();
    };
  }, [run, timeline, store]);
  return store;
}

const BEGINNING: TickDescription = { tick: 0, waited: 0, who: null, command: null, event: null };

function isSameSecond(one: number, other: number): boolean {
  return Math.floor(one / SECOND) === Math.floor(other / SECOND);
}

function isSame(one: TickDescription, other: TickDescription): boolean {
  return (
    one.tick === other.tick &&
    one.waited === other.waited &&
    one.who === other.who &&
    one.command?.seq === other.command?.seq &&
    one.command?.ending === other.command?.ending &&
    one.event?.kind === other.event?.kind &&
    one.event?.tick === other.event?.tick
  );
}
