/** What the screen itself remembers: theme, tool, what is shown, messages. Not part of any document. */
import { createStore } from "zustand/vanilla";

export const tools = ["blocks", "start", "goal", "measure"] as const;
export type Tool = (typeof tools)[number];
/** A tool that changes the maze. */
export type EditTool = Exclude<Tool, "measure">;
export type Theme = "system" | "light" | "dark";
/** more: high contrast even where the system does not ask for it */
export type Contrast = "system" | "more";

/** In the order in which they stand. */
export const sheetTabs = ["drive", "program", "presets"] as const;
export type SheetTab = (typeof sheetTabs)[number];

/** A dismissable message. `text` is already in the reader's language. */
export interface Message {
  id: number;
  tone: "info" | "bad";
  text: string;
  /** information that waits for an answer, however long; by itself it leaves after some seconds */
  stays?: boolean;
  /** it takes back an edit of the open work, and leaves when another work opens */
  isOfWork?: boolean;
  /** how much of what is waited for is done, from 0 to 1 */
  part?: number;
  /** one way to mend or take back, such as Undo */
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
  messages: readonly Message[];
  /** the tab of a phone's sheet; null: where the work is done */
  sheetTab: SheetTab | null;
  /** whether "Try it in other mazes" is open: it stays so when a phone is turned */
  isTryingMazes: boolean;
  /** whether the page opens and what its address asks for is on its way: no other work is shown meanwhile */
  isOpening: boolean;
  /** whether keys without Ctrl drive and open things (WCAG 2.1.4 asks for a switch) */
  singleKeys: boolean;
  /** whether those who listen are told of the run while it goes on */
  speakRun: boolean;
  /** whether the newest edit has reached the device's storage */
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
    isOpening: false,
    singleKeys: true,
    speakRun: true,
    saved: "saved",
  }));
}
export type ScreenStore = ReturnType<typeof createScreenStore>;

let lastMessageId = 0;

/** Messages that stand at once, so that the screen is never covered. */
const MOST_MESSAGES = 4;

/**
 * Shows a message; the newest stands first. One that says the same as before takes its place. Where
 * there are too many the oldest goes that would have left by itself; what stays is not pushed out.
 */
export function tell(store: ScreenStore, message: Omit<Message, "id">): number {
  const id = ++lastMessageId;
  store.setState((state) => {
    const others = state.messages.filter((each) => !isRenewedBy(each, message));
    return { messages: withRoom([{ ...message, id }, ...others]) };
  });
  return id;
}

function withRoom(messages: readonly Message[]): readonly Message[] {
  if (messages.length <= MOST_MESSAGES) return messages;
  const passing = messages.findLastIndex(
    ({ tone, stays = tone === "bad" }, at) => at > 0 && !stays,
  );
  return messages.toSpliced(passing < 0 ? messages.length - 1 : passing, 1);
}

/** Information with an action takes something back, and two of those may say the same of two things. */
function isRenewedBy(shown: Message, next: Omit<Message, "id">): boolean {
  if (shown.text !== next.text || shown.tone !== next.tone) return false;
  return next.tone === "bad" || shown.action === undefined;
}

export function dismiss(store: ScreenStore, id: number): void {
  store.setState((state) => ({ messages: state.messages.filter((each) => each.id !== id) }));
}

/** Another work opens: what takes back an edit of the one before would change this one. */
export function dismissOfWork(store: ScreenStore): void {
  store.setState((state) => ({ messages: state.messages.filter(({ isOfWork }) => !isOfWork) }));
}

/** What a message waits for is so far now, from 0 to 1. */
export function tellPart(store: ScreenStore, id: number, part: number): void {
  store.setState((state) => ({
    messages: state.messages.map((each) => (each.id === id ? { ...each, part } : each)),
  }));
}
