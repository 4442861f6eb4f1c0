import { describe, expect, it } from "vitest";
import { HandDriving } from "./hand-driving.ts";

describe("a student", () => {
  it("drives by hand from the choice of the driver on, also while the robot stands still", () => {
    const hand = new HandDriving();
    expect(hand.isOn).toBe(false);
    expect(hand.follow("me", 0)).toBe(true);
    expect(hand.follow("me", 40)).toBe(false);
    expect(hand.isOn).toBe(true);
  });

  it("writes after an edit, until the robot drives by hand again", () => {
    const hand = new HandDriving();
    hand.follow("me", 40);
    hand.edited();
    expect(hand.isOn).toBe(false);
    hand.follow("me", 40);
    expect(hand.isOn).toBe(false);
    hand.follow("me", 41);
    expect(hand.isOn).toBe(true);
  });

  it("drives by hand after an edit and a reset", () => {
    const hand = new HandDriving();
    hand.follow("me", 40);
    hand.edited();
    hand.follow("me", 0);
    expect(hand.isOn).toBe(false);
    hand.follow("me", 1);
    expect(hand.isOn).toBe(true);
  });

  it("does not drive by hand while the program drives", () => {
    const hand = new HandDriving();
    hand.follow("me", 40);
    expect(hand.follow("program", 40)).toBe(true);
    expect(hand.isOn).toBe(false);
  });
});
