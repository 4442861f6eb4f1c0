/**
 * A fleet at an MQTT broker. All messages have QoS 1: they are stored until the receiver
 * acknowledges them.
 */
import { connectAsync } from "mqtt";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, parseSeq, snapshotText } from "./messages.ts";

const QOS = { qos: 1 } as const;

export async function openMosquitto(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, listener } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const page = await connectAsync(`mqtt://127.0.0.1:${pages}`, { reconnectPeriod: 0 });
    page.on("message", () => page.publish(`${robot}/answer`, answerText(1), QOS));
    await page.subscribeAsync(`${robot}/command`, QOS);
    const reader = await connectAsync(`mqtt://127.0.0.1:${readers}`, { reconnectPeriod: 0 });
    reader.on("message", (topic, payload) => {
      if (topic.endsWith("/snapshot")) {
        listener.onSnapshot(robot, parseSeq(payload.toString("latin1")));
      } else listener.onAnswer(robot);
    });
    await reader.subscribeAsync([`${robot}/snapshot`, `${robot}/answer`], QOS);
    return { page, reader };
  });
  return {
    sendSnapshot: (robot, n) =>
      void all[robot]?.page.publish(`${robot}/snapshot`, snapshotText(n, 1), QOS),
    sendCommand: (robot) =>
      void all[robot]?.reader.publish(`${robot}/command`, commandText(commands++), QOS),
    whenProcessed: null,
    reset: null,
    close: async () => {
      for (const { page, reader } of all) {
        page.end(true);
        reader.end(true);
      }
    },
  };
}
