import { describe, expect, it } from "vitest";
import { createScreenStore, tell, type Message } from "./screen-store.ts";

type Told = Omit<Message, "id">;
const undo = () => ({ label: "Undo", run: () => undefined });
const here: Told = { tone: "info", text: "The robot stands here." };
const start: Told = { tone: "info", text: "This is the start." };
const broken: Told = { tone: "bad", text: "This link is cut off." };

describe("messages", () => {
  it.each([
    { name: "the same words stand once, as the newest", told: [here, start, here] },
    { name: "so do words with a way to mend", told: [broken, { ...broken, action: undo() }] },
  ])("$name", ({ told }) => {
    const screen = createScreenStore();
    const ids = told.map((message) => tell(screen, message));
    const { messages } = screen.getState();
    expect(messages[0]).toEqual({ ...told.at(-1), id: ids.at(-1) });
    expect(messages).toHaveLength(new Set(told.map(({ text }) => text)).size);
  });

  it("that take back different things both stay, though they say the same", () => {
    const screen = createScreenStore();
    tell(screen, { tone: "info", text: "“Maze” deleted.", action: undo() });
    tell(screen, { tone: "info", text: "“Maze” deleted.", action: undo() });
    expect(screen.getState().messages).toHaveLength(2);
  });

  it("are at most four", () => {
    const screen = createScreenStore();
    for (let n = 0; n < 9; n++) tell(screen, { tone: "info", text: `Message ${n}` });
    expect(screen.getState().messages).toHaveLength(4);
  });

  it("that stay are not pushed out by those that leave by themselves", () => {
    const screen = createScreenStore();
    tell(screen, { tone: "info", text: "A new version is ready.", stays: true });
    tell(screen, { tone: "bad", text: "Not saved." });
    for (let n = 0; n < 9; n++) tell(screen, { tone: "info", text: `Message ${n}` });
    const texts = screen.getState().messages.map(({ text }) => text);
    expect(texts).toEqual(["Message 8", "Message 7", "Not saved.", "A new version is ready."]);
  });
});
