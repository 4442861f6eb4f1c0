/** Describes the robot on demand. The implementation loads from a separate file. */
import type { i18n } from "i18next";
import type { DescribePorts } from "./describe-robot.ts";

export async function describeRobot(ports: DescribePorts, words: i18n): Promise<void> {
  const { describeRobot: describe } = await import("./describe-robot.ts");
  await describe(ports, words);
}
