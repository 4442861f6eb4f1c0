/** A fleet at socket.io, by its own client. */
import { io, type Socket } from "socket.io-client";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, snapshotText } from "./messages.ts";

interface Said {
  snapshot: { seq: number };
}

export async function openSocketIo(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, onlookers, ears } = options;
  const command: unknown = JSON.parse(commandText(1));
  const answer: unknown = JSON.parse(answerText(1));
  const all = await openAll(robots, async (robot) => {
    const page = await open(pages, { robot: String(robot), role: "page" });
    page.on("command", () => page.emit("answer", answer));
    const reader = await open(readers, { robot: String(robot), role: "reader" });
    reader.on("snapshot", ({ snapshot }: Said) => ears.snapshot(robot, snapshot.seq));
    reader.on("answer", () => ears.answered(robot));
    const more = await openAll(onlookers, () =>
      open(readers, { robot: String(robot), role: "onlooker" }),
    );
    return { page, reader, more, said: JSON.parse(snapshotText(1, 1)) as Said };
  });
  return {
    report: (robot, n) => {
      const at = all[robot];
      if (at === undefined) return;
      at.said.snapshot.seq = n;
      at.page.emit("snapshot", at.said);
    },
    command: (robot) => all[robot]?.reader.emit("command", command),
    taken: null,
    rest: null,
    close: async () => {
      for (const { page, reader, more } of all) {
        for (const socket of [page, reader, ...more]) socket.disconnect();
      }
    },
  };
}

async function open(port: string, auth: Record<string, string>): Promise<Socket> {
  const socket = io(`http://127.0.0.1:${port}`, {
    transports: ["websocket"],
    forceNew: true,
    reconnection: false,
    auth,
  });
  await new Promise<void>((resolve, reject) => {
    socket.once("connect", resolve);
    socket.once("connect_error", reject);
  });
  return socket;
}
