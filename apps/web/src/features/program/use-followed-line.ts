/** Ties the list of lines to the follower that keeps the running one in sight. */
import type { LineRef } from "@corridor/protocol";
import { useEffect, useRef, type RefObject } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { LineFollower } from "./line-follower.ts";

/** @returns the ref of the list; its running line is the one with `aria-current` */
export function useFollowedLine(deciding: LineRef | null): RefObject<HTMLOListElement | null> {
  const { run } = useServices();
  const isRunning = useStore(run, ({ snapshot }) => snapshot?.state === "running");
  const list = useRef<HTMLOListElement>(null);
  const follower = useRef<LineFollower>(null);

  useEffect(() => {
    if (list.current === null) return undefined;
    const made = new LineFollower(list.current);
    follower.current = made;
    return () => made.end();
  }, []);

  useEffect(() => {
    if (isRunning) follower.current?.begin();
  }, [isRunning]);

  useEffect(() => {
    const line = list.current?.querySelector<HTMLElement>(":scope > [aria-current]") ?? null;
    follower.current?.show(typeof deciding === "number" ? line : null);
  }, [deciding]);

  return list;
}
