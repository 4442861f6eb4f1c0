import { describe, expect, it } from "vitest";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { guardLeaving } from "./guard-leaving.ts";

describe("leaving the page", () => {
  it("asks only while the newest edits are not stored", () => {
    const screen = createScreenStore();
    const page = new EventTarget();
    guardLeaving(screen, page);
    const isAsked = () => !page.dispatchEvent(new Event("beforeunload", { cancelable: true }));
    expect(isAsked()).toBe(false);
    screen.setState({ saved: "saving" });
    expect(isAsked()).toBe(false);
    screen.setState({ saved: "blocked" });
    expect(isAsked()).toBe(true);
    screen.setState({ saved: "saved" });
    expect(isAsked()).toBe(false);
  });
});
