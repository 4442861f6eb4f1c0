import { expect, it } from "vitest";
import { missionHash, missionOfHash } from "./mission-address.ts";

it("the address of a mission is a fragment that names it", () => {
  expect(missionHash("side-opening")).toBe("#mission/side-opening");
  expect(missionOfHash("#mission/side-opening")).toBe("side-opening");
  expect(missionOfHash("#1AbC")).toBeNull();
  expect(missionOfHash("")).toBeNull();
});
