import { describe, expect, it } from "vitest";
import { modelChanges, type StageModel } from "./stage-model.ts";

const model = { startWord: "Start", showBeams: true, preview: null } as StageModel;

describe("the changes of a stage model", () => {
  it.each([
    { name: "all of the first", before: null, next: model, changes: model },
    { name: "nothing of the same again", before: model, next: { ...model }, changes: null },
    {
      name: "only what differs",
      before: model,
      next: { ...model, showBeams: false },
      changes: { showBeams: false },
    },
  ])("$name", ({ before, next, changes }) => {
    expect(modelChanges(before, next)).toEqual(changes);
  });
});
