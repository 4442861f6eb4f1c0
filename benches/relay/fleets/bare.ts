/** A fleet at the bare forwarder: the page answers each command itself. */
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, numberIn, snapshotText } from "./messages.ts";
import { TextWire } from "./text-wire.ts";

export async function openBare(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, onlookers, ears } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const end = (port: string, role: string, hear: (text: string) => void): Promise<TextWire> =>
      TextWire.open({ port: Number(port), path: `/${robot}/${role}`, headers: {}, hear });
    const page: TextWire = await end(pages, "page", () => page.send(answerText(1)));
    const reader = await end(readers, "reader", (text) => {
      if (text.startsWith('{"type":"snapshot"')) ears.snapshot(robot, numberIn(text));
      else ears.answered(robot);
    });
    const more = await openAll(onlookers, (n) => end(readers, `onlooker${n}`, () => undefined));
    return [page, reader, ...more] as const;
  });
  return {
    report: (robot, n) => all[robot]?.[0].send(snapshotText(n, 1)),
    command: (robot) => all[robot]?.[1].send(commandText(commands++)),
    taken: null,
    rest: null,
    close: async () => {
      for (const wire of all.flat()) wire.close();
    },
  };
}
