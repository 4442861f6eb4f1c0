/** Describe, whose words come in a file of their own when they are asked for. */
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";

export async function describeRobot(services: Services, words: i18n): Promise<void> {
  const { describeRobot: describe } = await import("./describe-robot.ts");
  await describe(services, words);
}
