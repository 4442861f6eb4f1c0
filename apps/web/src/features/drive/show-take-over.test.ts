import { describe, expect, it } from "vitest";
import { createScreenStore, showMessage } from "../../stores/screen-store.ts";
import { tellTakeOver } from "./show-take-over.ts";

const words = {
  t: (key: string) => key,
  loadNamespaces: async () => {},
} as unknown as Parameters<typeof tellTakeOver>[1];

describe("a hand that takes over", () => {
  it("is told so by one message, also where another driver had the robot before", async () => {
    const screen = createScreenStore();
    showMessage(screen, { tone: "info", text: "something else" });
    await tellTakeOver(screen, words, "remote");
    await tellTakeOver(screen, words, "program");
    expect(screen.getState().messages.map(({ text }) => text)).toEqual([
      "runDetails:hand.fromProgram",
      "something else",
    ]);
  });
});
