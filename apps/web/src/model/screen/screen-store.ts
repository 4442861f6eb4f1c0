/** State of the screen itself: theme, tool, visible layers, messages. Not part of any document. */
import type { MazeDocument, WallFollowerMiss } from "@corridor/maze";
import { createStore } from "zustand/vanilla";

export const tools = ["blocks", "start", "goal", "measure"] as const;
export type Tool = (typeof tools)[number];
/** A tool that changes the maze. */
export type EditTool = Exclude<Tool, "measure">;
export type Theme = "system" | "light" | "dark";
/** more: high contrast even if the system does not request it */
export type Contrast = "system" | "more";

/** In display order. */
export const sheetTabs = ["drive", "program", "presets"] as const;
export type SheetTab = (typeof sheetTabs)[number];

/** Why a wall follower misses the goal of a maze. */
export interface WallMarks extends WallFollowerMiss {
  /** the maze that the marks belong to */
  maze: MazeDocument;
}

/** A dismissible message. `text` is already translated. */
export interface Message {
  id: number;
  tone: "info" | "bad";
  text: string;
  /** whether information stays until it is dismissed; otherwise it disappears after some seconds */
  stays?: boolean;
  /**
   * whether it offers to undo an edit of the open project, or to leave it; it disappears when another
   * project opens
   */
  isOfProject?: boolean;
  /** progress from 0 to 1 of the task that the message is about */
  part?: number;
  /** one action that fixes or undoes, such as Undo */
  action?: { label: string; run: () => void } | undefined;
}

export interface ScreenState {
  theme: Theme;
  contrast: Contrast;
  tool: Tool;
  /** what the stage shows besides maze and robot */
  showBeams: boolean;
  showTrail: boolean;
  showRulers: boolean;
  /** false: marks of scripts over the maze are hidden */
  showMarks?: boolean;
  messages: readonly Message[];
  /** the open tab of a phone's sheet; null: the tab that fits the current task */
  sheetTab: SheetTab | null;
  /** whether "Try it in other mazes" is open; stays set when a phone is rotated */
  isTryingMazes: boolean;
  /** whether the share dialog is open */
  isSharing: boolean;
  /**
   * whether the document of the page's address is still loading; no other project is displayed
   * meanwhile
   */
  isOpening: boolean;
  /** set in a frame of another site, where nothing leads to projects of the visitor */
  isEmbedded?: boolean;
  /** the marks over a maze that wall followers cannot solve; absent or null without them */
  wallMarks?: WallMarks | null;
  /** whether single-key shortcuts are enabled (WCAG 2.1.4 requires a switch) */
  singleKeys: boolean;
  /** whether screen readers receive messages about the run while it continues */
  speakRun: boolean;
  /** whether the newest edit is stored on the device */
  saved: "saved" | "saving" | "blocked";
}

export function createScreenStore() {
  return createStore<ScreenState>()(() => ({
    theme: "system",
    contrast: "system",
    tool: "blocks",
    showBeams: true,
    showTrail: true,
    showRulers: true,
    messages: [],
    sheetTab: null,
    isTryingMazes: false,
    isSharing: false,
    isOpening: false,
    singleKeys: true,
    speakRun: true,
    saved: "saved",
  }));
}
export type ScreenStore = ReturnType<typeof createScreenStore>;

let lastMessageId = 0;

/** Largest number of messages at a time, so that the screen is never covered. */
const MAX_MESSAGES = 4;

/**
 * Shows a message above the others. It replaces one with the same text. If there are too many, the
 * oldest that would disappear by itself is removed; messages that stay are removed last.
 */
export function showMessage(store: ScreenStore, message: Omit<Message, "id">): number {
  const id = ++lastMessageId;
  store.setState((state) => {
    const others = state.messages.filter((each) => !isReplacedBy(each, message));
    return { messages: limited([{ ...message, id }, ...others]) };
  });
  return id;
}

function limited(messages: readonly Message[]): readonly Message[] {
  if (messages.length <= MAX_MESSAGES) return messages;
  const evicted = messages.findLastIndex(
    ({ tone, stays = tone === "bad" }, at) => at > 0 && !stays,
  );
  return messages.toSpliced(evicted < 0 ? messages.length - 1 : evicted, 1);
}

/** Information with an action undoes something, and two such messages may have the same text. */
function isReplacedBy(shown: Message, next: Omit<Message, "id">): boolean {
  if (shown.text !== next.text || shown.tone !== next.tone) return false;
  return next.tone === "bad" || shown.action === undefined;
}

export function dismiss(store: ScreenStore, id: number): void {
  store.setState((state) => ({ messages: state.messages.filter((each) => each.id !== id) }));
}

/** Removes messages whose action would change the project that was open before. */
export function dismissOfProject(store: ScreenStore): void {
  store.setState((state) => ({
    messages: state.messages.filter(({ isOfProject: isOfWork }) => !isOfWork),
  }));
}

/** Updates the progress of a message, from 0 to 1. */
export function setMessageProgress(store: ScreenStore, id: number, part: number): void {
  store.setState((state) => ({
    messages: state.messages.map((each) => (each.id === id ? { ...each, part } : each)),
  }));
}
