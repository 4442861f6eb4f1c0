import { describe, expect, it } from "vitest";
import { createScreenStore, showMessage } from "../../model/screen/screen-store.ts";
import { showTakeOver } from "./show-take-over.ts";

const words = {
  t: (key: string) => key,
  loadNamespaces: async () => {},
} as unknown as Parameters<typeof showTakeOver>[1];

describe("a user who takes over by hand", () => {
  it("sees one message, even after an earlier take-over from another driver", async () => {
    const screen = createScreenStore();
    showMessage(screen, { tone: "info", text: "something else" });
    await showTakeOver(screen, words, "remote");
    await showTakeOver(screen, words, "program");
    expect(screen.getState().messages.map(({ text }) => text)).toEqual([
      "runDetails:hand.fromProgram",
      "something else",
    ]);
  });
});
