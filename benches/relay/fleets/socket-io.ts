/** A fleet at socket.io, with the client of socket.io. */
import { io, type Socket } from "socket.io-client";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, snapshotText } from "./messages.ts";

interface SnapshotMessage {
  snapshot: { seq: number };
}

export async function openSocketIo(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, viewers, listener } = options;
  const command: unknown = JSON.parse(commandText(1));
  const answer: unknown = JSON.parse(answerText(1));
  const all = await openAll(robots, async (robot) => {
    const page = await open(pages, { robot: String(robot), role: "page" });
    page.on("command", () => page.emit("answer", answer));
    const reader = await open(readers, { robot: String(robot), role: "reader" });
    reader.on("snapshot", ({ snapshot }: SnapshotMessage) =>
      listener.onSnapshot(robot, snapshot.seq),
    );
    reader.on("answer", () => listener.onAnswer(robot));
    const viewerSockets = await openAll(viewers, () =>
      open(readers, { robot: String(robot), role: "viewer" }),
    );
    return {
      page,
      reader,
      viewerSockets,
      message: JSON.parse(snapshotText(1, 1)) as SnapshotMessage,
    };
  });
  return {
    sendSnapshot: (robot, n) => {
      const at = all[robot];
      if (at === undefined) return;
      at.message.snapshot.seq = n;
      at.page.emit("snapshot", at.message);
    },
    sendCommand: (robot) => all[robot]?.reader.emit("command", command),
    whenProcessed: null,
    reset: null,
    close: async () => {
      for (const { page, reader, viewerSockets } of all) {
        for (const socket of [page, reader, ...viewerSockets]) socket.disconnect();
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
