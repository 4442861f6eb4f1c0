/**
 * Marks the line that drives the robot with `aria-current`, which controls its look. Shows below it
 * that the others were not read, unless the run has ended, and keeps the line in sight. Writes directly to the DOM: React
 * would render two lines again at every turn of the robot.
 */
import type { LineRef } from "@corridor/protocol";
import { useLayoutEffect, useRef, type RefObject } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { lineElementId } from "../../model/workspace/focus-line.ts";
import type { LineFollower } from "./line-follower.ts";
import { decidingLine } from "../../model/run/line-state.ts";

/** @param otherwise the element of "otherwise" */
export function useRunningLine(
  list: RefObject<HTMLOListElement | null>,
  otherwise: RefObject<HTMLElement | null>,
): void {
  const { run, deferred, workspace } = useServices();
  // A new list of ids triggers a new mark. The elements exist by then.
  const lineIds = useStore(workspace, (state) => state.lineIds);
  const follower = useRef<Promise<LineFollower> | null>(null);
  const wasRunning = useRef(false);

  useLayoutEffect(() => {
    const elementOf = (deciding: LineRef | null): HTMLElement | null =>
      deciding === "default"
        ? otherwise.current
        : document.getElementById(lineElementId(lineIds[deciding ?? -1] ?? -1));

    let marked: HTMLElement | null = null;
    let markedAs = "";
    const mark = (line: HTMLElement | null, as: "step" | "true"): void => {
      if (line === marked && as === markedAs) return;
      if (line !== marked) marked?.removeAttribute("aria-current");
      line?.setAttribute("aria-current", as);
      marked = line;
      markedAs = as;
    };
    const lookAtOnce = ({ snapshot, hasEnded }: RunState): void =>
      mark(elementOf(decidingLine(snapshot)), hasEnded ? "true" : "step");

    let followed: HTMLElement | null = null;
    let noted: HTMLElement | null = null;
    const moveNote = (line: HTMLElement | null): void => {
      if (line === noted) return;
      toggleNoteBelow(noted, false);
      toggleNoteBelow(line, true);
      noted = line;
    };
    const look = ({ snapshot, hasEnded }: RunState): void => {
      const deciding = decidingLine(snapshot);
      const line = elementOf(deciding);
      const isFollowed = line === followed;
      followed = line;
      moveNote(hasEnded ? null : line);
      const isRunning = snapshot?.state === "running" && snapshot.tick > 0;
      const begins = isRunning && !wasRunning.current;
      wasRunning.current = isRunning;
      if (begins) follower.current ??= load(list);
      if (isFollowed && !begins) return;
      follower.current?.then(
        (it) => {
          it.show(deciding === "default" ? null : line);
          if (begins) it.begin();
        },
        // If the file fails to load, the lines stay where the student scrolled them.
        () => undefined,
      );
    };
    lookAtOnce(run.getState());
    look(deferred.getState());
    const ends = [run.subscribe(lookAtOnce), deferred.subscribe(look)];
    return () => {
      for (const end of ends) end();
      mark(null, "step");
      moveNote(null);
    };
  }, [run, deferred, lineIds, list, otherwise]);

  useLayoutEffect(
    () => () => {
      follower.current?.then(
        (it) => it.end(),
        () => undefined,
      );
      follower.current = null;
    },
    [],
  );
}

/** Loads the follower from its own file once the robot has started. */
async function load(list: RefObject<HTMLOListElement | null>): Promise<LineFollower> {
  const { LineFollower: Follower } = await import("./line-follower.ts");
  if (list.current === null) throw new Error("the lines are gone");
  return new Follower(list.current);
}

/**
 * Marks the row between two lines that shows "not read". Below the last line there is no such row.
 */
function toggleNoteBelow(line: HTMLElement | null, isShown: boolean): void {
  const below = line?.nextElementSibling;
  if (below?.tagName === "LI") below.toggleAttribute("data-displayed", isShown);
}
