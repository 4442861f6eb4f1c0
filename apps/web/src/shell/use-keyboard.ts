/**
 * The page's keys: driving while one is held, Run, Step, Undo, Describe, help, Escape. One listener
 * on the window; `shortcuts.ts` maps presses to shortcuts.
 */
import type { i18n } from "i18next";
import { useEffect, useEffectEvent, useState } from "react";
import { useTranslation } from "react-i18next";
import { handAction } from "../features/drive/hand-control.ts";
import { createHoldStore, type HoldStore } from "../features/drive/hold-store.ts";
import { describeRobot } from "../model/speech/describe-later.ts";
import { isProgramRefused, runButton, runOrPause, stepOn } from "../model/run/run-button.ts";
import { redo, undo } from "../model/workspace/workspace-store.ts";
import type { DriveKey } from "../simulator/protocol/worker-messages.ts";
import { useServices } from "../model/use-services.ts";
import type { Services } from "../model/services.ts";
import { shortcutOf, type Place, type Shortcut } from "./shortcuts.ts";

/**
 * @param openHelp opens the list of keys
 * @returns the held drive keys, also for the buttons on the screen
 */
export function useKeyboard(openHelp: () => void): HoldStore {
  const services = useServices();
  const { i18n } = useTranslation();
  const [hold] = useState(() =>
    createHoldStore(
      (key) => services.simulator.send({ type: "hold", key }),
      (key) => canPress(services, i18n, key),
    ),
  );
  // Subscribing again would release held keys, so it must not happen with each new `openHelp`.
  const help = useEffectEvent(openHelp);
  useEffect(() => listen(services, hold, i18n, () => help()), [services, hold, i18n]);
  return hold;
}

function listen(
  services: Services,
  hold: HoldStore,
  words: i18n,
  openHelp: () => void,
): () => void {
  const end = new AbortController();
  const { signal } = end;
  const { run, screen, challenge, camera } = services;

  // Arrows move between radio buttons that were focused by Tab; after a click they drive.
  let isFocusedByPointer = false;
  window.addEventListener("pointerdown", () => (isFocusedByPointer = true), { signal });
  // A focused select would treat letters and arrows as choices until something else is clicked.
  window.addEventListener(
    "change",
    ({ target }) => {
      if (isFocusedByPointer && target instanceof HTMLSelectElement) target.blur();
    },
    { signal },
  );

  window.addEventListener(
    "keydown",
    (event) => {
      if (event.key === "Tab") isFocusedByPointer = false;
      if (event.defaultPrevented || event.isComposing) return;
      const isCovered = document.querySelector("dialog:modal, :popover-open, [inert]") !== null;
      const shortcut = shortcutOf(
        {
          key: event.key,
          code: event.code,
          command: event.ctrlKey || event.metaKey,
          shift: event.shiftKey,
          alt: event.altKey,
        },
        placeOf(event.target, isFocusedByPointer),
        screen.getState().singleKeys,
      );
      // A dialog on top of the page receives all keys; Escape closes it. In a paused class, no key
      // drives.
      if (shortcut === null || isCovered) return;
      if (shortcut.kind === "drive") {
        const { rights } = challenge.getState();
        if (handAction(shortcut.key, run.getState(), rights) === "none") return;
        event.preventDefault();
        // A key that is still held when another driver takes over does not take the robot back.
        if (!event.repeat) hold.press(event.code, shortcut.key);
        return;
      }
      if (shortcut.kind !== "escape") event.preventDefault();
      if (shortcut.kind === "zoom") return camera.getState().zoom(shortcut.by, null);
      if (event.repeat) return;
      if (shortcut.kind === "describe") void describeRobot(services, words);
      else execute(services, hold, shortcut.kind, openHelp);
    },
    { signal },
  );
  window.addEventListener("keyup", (event) => hold.release(event.code), { signal });

  // Wherever a release could be missed, the robot stops.
  const stop = () => hold.releaseAll();
  window.addEventListener("blur", stop, { signal });
  document.addEventListener("visibilitychange", stop, { signal });
  document.addEventListener(
    "focusin",
    (event) => {
      if (["text", "choice", "grid"].includes(placeOf(event.target))) stop();
    },
    { signal },
  );
  const unsubscribe = run.subscribe(({ snapshot, event }, before) => {
    if (before.snapshot?.driver === "me" && snapshot?.driver !== "me") hold.clear();
    if (event !== before.event && event?.kind === "goal" && event.driver === "me") hold.arrive();
  });
  return () => {
    end.abort();
    unsubscribe();
    stop();
  };
}

/** Whether a press drives; shows a message if the user takes over with it, or must not. */
function canPress(services: Services, words: i18n, key: DriveKey): boolean {
  const { simulator, run, challenge, screen } = services;
  const action = handAction(key, run.getState(), challenge.getState().rights);
  if (action === "pause") simulator.send({ type: "pause" });
  if (action === "take-over" || action === "refuse") {
    const driver = run.getState().snapshot?.driver ?? "program";
    void import("../features/drive/show-take-over.ts").then(
      ({ showTakeOver }) => showTakeOver(screen, words, action === "refuse" ? null : driver),
      // Without the file there is no message; "Who drives?" shows it anyway.
      () => undefined,
    );
  }
  return action === "drive" || action === "take-over";
}

function execute(
  { simulator, workspace, run, challenge }: Services,
  hold: HoldStore,
  kind: Exclude<Shortcut["kind"], "drive" | "describe" | "zoom">,
  openHelp: () => void,
): void {
  const now = run.getState();
  const isRefused = isProgramRefused(challenge.getState().rights);
  switch (kind) {
    case "run-or-pause":
      if (isRefused && runButton(now) !== "pause") return;
      return simulator.send(runOrPause(now));
    case "step":
      if (isRefused && now.view === "now") return;
      return simulator.send(stepOn(now));
    case "undo":
      return undo(workspace);
    case "redo":
      return redo(workspace);
    case "help":
      return openHelp();
    case "escape":
      hold.releaseAll();
      if (run.getState().snapshot?.state === "running") simulator.send({ type: "pause" });
  }
}

/** Kind of the element that an event came from. */
function placeOf(target: EventTarget | null, isFocusedByPointer = false): Place {
  if (!(target instanceof Element)) return "page";
  if (target.closest("[role=grid]") !== null) return "grid";
  if (target.closest("select, [role=listbox]") !== null) return "choice";
  if (target.closest("[type=radio], [role=tablist]") !== null) {
    return isFocusedByPointer ? "button" : "radio";
  }
  if (target instanceof HTMLInputElement) {
    if (target.type === "range") return "slider";
    return target.type === "checkbox" ? "button" : "text";
  }
  if (target.closest("textarea, [contenteditable]") !== null) return "text";
  return target.closest("button, a, summary") === null ? "page" : "button";
}
