import { describe, expect, it } from "vitest";
import { placePopover } from "./popover-position.ts";

const view = { width: 1000, height: 800 };
const size = { width: 300, height: 200 };

describe("placePopover", () => {
  it.each([
    {
      name: "opens below, left edges together",
      button: { left: 100, top: 10, right: 200, bottom: 50 },
      align: "left" as const,
      place: { left: 100, top: 56 },
    },
    {
      name: "opens below, right edges together",
      button: { left: 600, top: 10, right: 700, bottom: 50 },
      align: "right" as const,
      place: { left: 400, top: 56 },
    },
    {
      name: "stays inside the window's right edge",
      button: { left: 900, top: 10, right: 980, bottom: 50 },
      align: "left" as const,
      place: { left: 692, top: 56 },
    },
    {
      name: "stays inside the window's left edge",
      button: { left: 10, top: 10, right: 90, bottom: 50 },
      align: "right" as const,
      place: { left: 8, top: 56 },
    },
    {
      name: "opens above a button near the bottom",
      button: { left: 100, top: 740, right: 200, bottom: 780 },
      align: "left" as const,
      place: { left: 100, top: 534 },
    },
  ])("$name", ({ button, align, place }) => {
    expect(placePopover(button, size, view, align)).toEqual(place);
  });

  it("shows its end if it fits neither above nor below", () => {
    const button = { left: 100, top: 300, right: 200, bottom: 340 };
    const tall = { width: 300, height: 700 };
    expect(placePopover(button, tall, view, "left").top).toBe(92);
  });

  it("shows its top if it is higher than the window", () => {
    const button = { left: 100, top: 300, right: 200, bottom: 340 };
    const tall = { width: 300, height: 810 };
    expect(placePopover(button, tall, view, "left").top).toBe(8);
  });
});
