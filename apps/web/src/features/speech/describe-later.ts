/** Describes the robot on demand. The implementation loads from a separate file. */
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";

export async function describeRobot(services: Services, words: i18n): Promise<void> {
  const { describeRobot: describe } = await import("./describe-robot.ts");
  await describe(services, words);
}
