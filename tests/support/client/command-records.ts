import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";

/** All records of a robot's commands after one of them, from every page of the log. */
export async function recordsAfter(address: string, seq: number): Promise<CommandRecord[]> {
  const { origin, pathname, hash } = new URL(address);
  const commands = `${origin}/api/v1/robots/${pathname.slice("/r/".length)}/commands`;
  const headers = { authorization: `Bearer ${hash.slice(1)}` };
  const all: CommandRecord[] = [];
  for (;;) {
    const answer = await fetch(`${commands}?after=${all.at(-1)?.seq ?? seq}`, { headers });
    const page = (await answer.json()) as { commands: unknown };
    const records = commandRecordSchema.array().parse(page.commands);
    if (records.length === 0) return all;
    all.push(...records);
  }
}
