/**
 * A fleet over Redis streams. Page and reader append to one stream and block on the other, with one
 * connection for each.
 */
import { createClient } from "@redis/client";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, parseSeq, snapshotText } from "./messages.ts";

/** Approximate maximum length of a stream. */
const MAX_ENTRIES = 16;

export async function openRedis(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, listener } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const page = await open(pages);
    const reader = await open(readers);
    const closers = [
      await follow(pages, `{${robot}}down`, () => append(page, `{${robot}}up`, answerText(1))),
      await follow(readers, `{${robot}}up`, (text) => {
        if (text.startsWith('{"type":"snapshot"')) listener.onSnapshot(robot, parseSeq(text));
        else listener.onAnswer(robot);
      }),
    ];
    const close = (): void => {
      for (const each of closers) each();
      page.destroy();
      reader.destroy();
    };
    return { page, reader, close };
  });
  return {
    sendSnapshot: (robot, n) => {
      const page = all[robot]?.page;
      if (page !== undefined) append(page, `{${robot}}up`, snapshotText(n, 1));
    },
    sendCommand: (robot) => {
      const reader = all[robot]?.reader;
      if (reader !== undefined) append(reader, `{${robot}}down`, commandText(commands++));
    },
    whenProcessed: null,
    reset: null,
    close: async () => {
      for (const { close } of all) close();
    },
  };
}

/**
 * The reply of XREAD: for each stream, entries with an id, and alternating field names and values.
 */
type ReadReply = [string, [string, [string, string]][]][] | null;

type Client = Awaited<ReturnType<typeof open>>;

async function open(port: string) {
  const client = createClient({ url: `redis://127.0.0.1:${port}`, RESP: 2 });
  client.on("error", () => undefined);
  await client.connect();
  return client;
}

function append(client: Client, stream: string, text: string): void {
  const args = ["XADD", stream, "MAXLEN", "~", String(MAX_ENTRIES), "*", "text", text];
  client.sendCommand(args).catch(() => undefined);
}

/**
 * Reads a stream and calls `onEntry` with each entry.
 * @returns a function that closes the connection
 */
async function follow(
  port: string,
  stream: string,
  onEntry: (text: string) => void,
): Promise<() => void> {
  const client = await open(port);
  let lastId = "0";
  const readEntries = async (): Promise<never> => {
    for (;;) {
      const args = ["XREAD", "COUNT", "100", "BLOCK", "0", "STREAMS", stream, lastId];
      const reply = (await client.sendCommand(args)) as unknown as ReadReply;
      for (const [id, [, text]] of reply?.[0]?.[1] ?? []) {
        lastId = id;
        onEntry(text);
      }
    }
  };
  // Ends when the connection is closed.
  readEntries().catch(() => undefined);
  return () => client.destroy();
}
