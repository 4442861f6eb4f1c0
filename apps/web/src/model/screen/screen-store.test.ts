import { describe, expect, it } from "vitest";
import { createScreenStore, showMessage, type Message } from "./screen-store.ts";

type NewMessage = Omit<Message, "id">;
const undo = () => ({ label: "Undo", run: () => undefined });
const here: NewMessage = { tone: "info", text: "The robot stands here." };
const start: NewMessage = { tone: "info", text: "This is the start." };
const broken: NewMessage = { tone: "bad", text: "This link is cut off." };

describe("messages", () => {
  it.each([
    { name: "a text appears once, as the newest message", shown: [here, start, here] },
    { name: "so does an error with an action", shown: [broken, { ...broken, action: undo() }] },
  ])("$name", ({ shown }) => {
    const screen = createScreenStore();
    const ids = shown.map((message) => showMessage(screen, message));
    const { messages } = screen.getState();
    expect(messages[0]).toEqual({ ...shown.at(-1), id: ids.at(-1) });
    expect(messages).toHaveLength(new Set(shown.map(({ text }) => text)).size);
  });

  it("with different Undo actions both stay, although their texts are equal", () => {
    const screen = createScreenStore();
    showMessage(screen, { tone: "info", text: "“Maze” deleted.", action: undo() });
    showMessage(screen, { tone: "info", text: "“Maze” deleted.", action: undo() });
    expect(screen.getState().messages).toHaveLength(2);
  });

  it("are at most four", () => {
    const screen = createScreenStore();
    for (let n = 0; n < 9; n++) showMessage(screen, { tone: "info", text: `Message ${n}` });
    expect(screen.getState().messages).toHaveLength(4);
  });

  it("that stay are not evicted by those that disappear by themselves", () => {
    const screen = createScreenStore();
    showMessage(screen, { tone: "info", text: "A new version is ready.", stays: true });
    showMessage(screen, { tone: "bad", text: "Not saved." });
    for (let n = 0; n < 9; n++) showMessage(screen, { tone: "info", text: `Message ${n}` });
    const texts = screen.getState().messages.map(({ text }) => text);
    expect(texts).toEqual(["Message 8", "Message 7", "Not saved.", "A new version is ready."]);
  });
});
