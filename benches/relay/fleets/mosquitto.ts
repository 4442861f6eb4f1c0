/** A fleet at an MQTT broker, everything with QoS 1: what is said is kept until the other side has said that it came. */
import { connectAsync } from "mqtt";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, numberIn, snapshotText } from "./messages.ts";

const QOS = { qos: 1 } as const;

export async function openMosquitto(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, ears } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const page = await connectAsync(`mqtt://127.0.0.1:${pages}`, { reconnectPeriod: 0 });
    page.on("message", () => page.publish(`${robot}/answer`, answerText(1), QOS));
    await page.subscribeAsync(`${robot}/command`, QOS);
    const reader = await connectAsync(`mqtt://127.0.0.1:${readers}`, { reconnectPeriod: 0 });
    reader.on("message", (topic, payload) => {
      if (topic.endsWith("/snapshot")) ears.snapshot(robot, numberIn(payload.toString("latin1")));
      else ears.answered(robot);
    });
    await reader.subscribeAsync([`${robot}/snapshot`, `${robot}/answer`], QOS);
    return { page, reader };
  });
  return {
    report: (robot, n) =>
      void all[robot]?.page.publish(`${robot}/snapshot`, snapshotText(n, 1), QOS),
    command: (robot) =>
      void all[robot]?.reader.publish(`${robot}/command`, commandText(commands++), QOS),
    taken: null,
    rest: null,
    close: async () => {
      for (const { page, reader } of all) {
        page.end(true);
        reader.end(true);
      }
    },
  };
}
