/** A model test: steps that succeed, throw or fail in groups have the same effect as one by one. */
import { setImmediate as turn } from "node:timers/promises";
import fc from "fast-check";
import { expect, it } from "vitest";
import { LOST, NOTHING, withJournal } from "../../cases/failing-journal.ts";

interface Doing {
  what: "memory" | "rows" | "alone" | "turn" | "lost" | "compact";
  /** entries that the step adds */
  entries: number;
  throws: "no" | "first" | "midway";
}

const doings = fc.array(
  fc.record<Doing>({
    what: fc.constantFrom(
      ...(["memory", "memory", "memory", "memory", "rows", "alone"] as const),
      ...(["turn", "turn", "turn", "lost", "compact"] as const),
    ),
    entries: fc.constantFrom(0, 1, 1, 2),
    throws: fc.constantFrom("no", "no", "no", "no", "first", "midway"),
  }),
  { minLength: 5, maxLength: 60 },
);

it("each step is answered with the state that the previous ones left, whichever of them fail or are lost", async () => {
  const all = withJournal();
  const { db, append, hasRow, names, onDisk, parts } = all;
  await fc.assert(
    fc.asyncProperty(doings, async (asked) => {
      const { journal, commits } = all.anew();
      db.exec("DELETE FROM journal; DELETE FROM rows");
      parts.due = null;
      let leftToAnswer = 0;
      const ask = ({ what, entries, throws }: Doing, name: string) => {
        const work = (): string[] => {
          if (what === "rows") db.prepare("INSERT INTO rows VALUES (?)").run(name);
          if (throws === "first") throw new Error("its own");
          for (let each = 0; each < entries; each++) append(name, commits);
          if (throws === "midway") throw new Error("its own");
          return [...names()];
        };
        leftToAnswer += 1;
        return commits
          .run(work, what === "rows" ? "rows" : "memory")
          .then(
            (seen) => ({ seen, onDisk: onDisk().filter((each) => each === name).length }),
            (error: Error) => error.message,
          )
          .finally(() => (leftToAnswer -= 1));
      };
      const steps: { doing: Doing; name: string; answer: ReturnType<typeof ask> }[] = [];
      for (const [n, doing] of asked.entries()) {
        const name = String(n);
        if (doing.what === "turn") await turn();
        else if (doing.what === "lost") journal.fails = { lost: LOST };
        else if (doing.what === "compact") parts.due = parts.due === null ? NOTHING : null;
        else if (doing.what === "alone")
          void commits.alone(() => {
            if (db.isTransaction) throw new Error("not alone");
          });
        else steps.push({ doing, name, answer: ask(doing, name) });
      }
      commits.close();
      await turn();
      expect(leftToAnswer).toBe(0);
      const lost = new Set(journal.lostNames);
      const left: string[] = [];
      const rows: string[] = [];
      for (const { doing, name, answer } of steps) {
        const { what, entries, throws } = doing;
        const got = await answer;
        // A step without entries may still be in a group that fails.
        const isLost = lost.has(name) || (entries === 0 && got === LOST.message);
        const isStored = !isLost && throws === "no";
        if (isStored) for (let each = 0; each < entries; each++) left.push(name);
        if (isStored && what === "rows") rows.push(name);
        const stored = { seen: [...left], onDisk: entries };
        expect(got).toEqual(isStored ? stored : isLost ? LOST.message : "its own");
      }
      expect(onDisk()).toEqual(left);
      expect(names()).toEqual(left);
      expect(hasRow().toSorted()).toEqual(rows.toSorted());
    }),
    { numRuns: 300 },
  );
});
