/** A fleet at the baseline server. The page answers each command itself. */
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, parseSeq, snapshotText } from "./messages.ts";
import { TextSocket } from "./text-socket.ts";

export async function openBare(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, viewers, listener } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const connect = (
      port: string,
      role: string,
      onMessage: (text: string) => void,
    ): Promise<TextSocket> =>
      TextSocket.open({ port: Number(port), path: `/${robot}/${role}`, headers: {}, onMessage });
    const page: TextSocket = await connect(pages, "page", () => page.send(answerText(1)));
    const reader = await connect(readers, "reader", (text) => {
      if (text.startsWith('{"type":"snapshot"')) listener.onSnapshot(robot, parseSeq(text));
      else listener.onAnswer(robot);
    });
    const more = await openAll(viewers, (n) => connect(readers, `viewer${n}`, () => undefined));
    return [page, reader, ...more] as const;
  });
  return {
    sendSnapshot: (robot, n) => all[robot]?.[0].send(snapshotText(n, 1)),
    sendCommand: (robot) => all[robot]?.[1].send(commandText(commands++)),
    whenProcessed: null,
    reset: null,
    close: async () => {
      for (const socket of all.flat()) socket.close();
    },
  };
}
