/** A fleet over Redis streams: each end appends to one and waits at the other, by a connection for each. */
import { createClient } from "@redis/client";
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, numberIn, snapshotText } from "./messages.ts";

/** A robot's stream is no archive. */
const KEEP = 16;

export async function openRedis(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, ears } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const page = await open(pages);
    const reader = await open(readers);
    const closers = [
      await follow(pages, `{${robot}}down`, () => append(page, `{${robot}}up`, answerText(1))),
      await follow(readers, `{${robot}}up`, (text) => {
        if (text.startsWith('{"type":"snapshot"')) ears.snapshot(robot, numberIn(text));
        else ears.answered(robot);
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
    report: (robot, n) => {
      const page = all[robot]?.page;
      if (page !== undefined) append(page, `{${robot}}up`, snapshotText(n, 1));
    },
    command: (robot) => {
      const reader = all[robot]?.reader;
      if (reader !== undefined) append(reader, `{${robot}}down`, commandText(commands++));
    },
    taken: null,
    rest: null,
    close: async () => {
      for (const { close } of all) close();
    },
  };
}

/** By stream, what was appended: its id, and names and values one after the other. */
type Found = [string, [string, [string, string]][]][] | null;

type Client = Awaited<ReturnType<typeof open>>;

async function open(port: string) {
  const client = createClient({ url: `redis://127.0.0.1:${port}`, RESP: 2 });
  client.on("error", () => undefined);
  await client.connect();
  return client;
}

function append(client: Client, stream: string, text: string): void {
  const words = ["XADD", stream, "MAXLEN", "~", String(KEEP), "*", "text", text];
  client.sendCommand(words).catch(() => undefined);
}

/** Waits at a stream for all that comes. @returns what ends it */
async function follow(
  port: string,
  stream: string,
  hear: (text: string) => void,
): Promise<() => void> {
  const client = await open(port);
  let from = "0";
  const listen = async (): Promise<never> => {
    for (;;) {
      const words = ["XREAD", "COUNT", "100", "BLOCK", "0", "STREAMS", stream, from];
      const found = (await client.sendCommand(words)) as unknown as Found;
      for (const [id, [, text]] of found?.[0]?.[1] ?? []) {
        from = id;
        hear(text);
      }
    }
  };
  // Ends when the connection is closed.
  listen().catch(() => undefined);
  return () => client.destroy();
}
