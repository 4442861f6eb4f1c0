import { describe, expect, it } from "vitest";
import { StudentDriving } from "./student-driving.ts";

describe("a student", () => {
  it.each(["me", "remote"] as const)(
    "drives from the choice of the driver %s on, also while the robot stands still",
    (driver) => {
      const driving = new StudentDriving();
      expect(driving.isOn).toBe(false);
      expect(driving.follow(driver, 0)).toBe(true);
      expect(driving.follow(driver, 40)).toBe(false);
      expect(driving.isOn).toBe(true);
    },
  );

  it("writes after an edit, until the robot drives by hand again", () => {
    const driving = new StudentDriving();
    driving.follow("me", 40);
    driving.edited();
    expect(driving.isOn).toBe(false);
    driving.follow("me", 40);
    expect(driving.isOn).toBe(false);
    driving.follow("me", 41);
    expect(driving.isOn).toBe(true);
  });

  it("drives by hand after an edit and a reset", () => {
    const driving = new StudentDriving();
    driving.follow("me", 40);
    driving.edited();
    driving.follow("me", 0);
    expect(driving.isOn).toBe(false);
    driving.follow("me", 1);
    expect(driving.isOn).toBe(true);
  });

  it("does not drive by hand while the program drives", () => {
    const driving = new StudentDriving();
    driving.follow("me", 40);
    expect(driving.follow("program", 40)).toBe(true);
    expect(driving.isOn).toBe(false);
  });
});
