/** Tool `sense`: the newest snapshot in words and numbers. */
import { noArguments, snapshotResult } from "./arguments.ts";
import { describeSnapshot } from "./snapshot-words.ts";
import { newestOf, readArguments, textResult, type Tool } from "./tool.ts";

export const senseTool: Tool = {
  name: "sense",
  description:
    "Reads the robot's sensors: free distance in cm in front, at the right, behind and at the left, position, heading, bumps, and whether a goal is reached.",
  input: noArguments,
  output: snapshotResult,
  drives: false,
  async run({ port }, args) {
    readArguments(noArguments, args);
    const snapshot = newestOf(port);
    return textResult(describeSnapshot(snapshot), { snapshot });
  },
};
