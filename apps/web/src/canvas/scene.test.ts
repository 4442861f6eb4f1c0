import { describe, expect, it } from "vitest";
import { sceneChanges, type Scene } from "./scene.ts";

const scene = { startWord: "Start", showBeams: true, ghost: null } as Scene;

describe("what of a scene is sent", () => {
  it.each([
    { name: "all of the first", before: null, next: scene, changes: scene },
    { name: "nothing of the same again", before: scene, next: { ...scene }, changes: null },
    {
      name: "only what differs",
      before: scene,
      next: { ...scene, showBeams: false },
      changes: { showBeams: false },
    },
  ])("$name", ({ before, next, changes }) => {
    expect(sceneChanges(before, next)).toEqual(changes);
  });
});
