/** Ties the list of lines to the follower that keeps the running one in sight. */
import { useEffect, useRef, type RefObject } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { LineFollower } from "./line-follower.ts";
import { decidingLine } from "./line-state.ts";

/** @param list its running line is the one with `aria-current` */
export function useFollowedLine(list: RefObject<HTMLOListElement | null>): void {
  const { run } = useServices();
  const isRunning = useStore(run, ({ snapshot }) => snapshot?.state === "running");
  const deciding = useStore(run, ({ snapshot }) => decidingLine(snapshot));
  const follower = useRef<LineFollower>(null);

  useEffect(() => {
    if (list.current === null) return undefined;
    const made = new LineFollower(list.current);
    follower.current = made;
    return () => made.end();
  }, [list]);

  useEffect(() => {
    if (isRunning) follower.current?.begin();
  }, [isRunning]);

  useEffect(() => {
    const line = list.current?.querySelector<HTMLElement>(":scope > [aria-current]") ?? null;
    follower.current?.show(typeof deciding === "number" ? line : null);
  }, [list, deciding]);
}
