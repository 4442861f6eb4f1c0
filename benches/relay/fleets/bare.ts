/** A fleet at the bare forwarder: the page answers each command itself. */
import { openAll, type Fleet, type FleetOptions } from "./fleet.ts";
import { answerText, commandText, numberIn, snapshotText } from "./messages.ts";
import { TextWire } from "./text-wire.ts";

export async function openBare(options: FleetOptions): Promise<Fleet> {
  const { pages, readers, robots, ears } = options;
  let commands = 0;
  const all = await openAll(robots, async (robot) => {
    const end = (port: string, role: string, hear: (text: string) => void): Promise<TextWire> =>
      TextWire.open({ port: Number(port), path: `/${robot}/${role}`, headers: {}, hear });
    const page: TextWire = await end(pages, "page", () => page.send(answerText(1)));
    const reader = await end(readers, "reader", (text) => {
      if (text.startsWith('{"type":"snapshot"')) ears.snapshot(robot, numberIn(text));
      else ears.answered(robot);
    });
    return { page, reader };
  });
  return {
    report: (robot, n) => all[robot]?.page.send(snapshotText(n, 1)),
    command: (robot) => all[robot]?.reader.send(commandText(commands++)),
    taken: null,
    close: async () => {
      for (const { page, reader } of all) {
        page.close();
        reader.close();
      }
    },
  };
}
