/** The commands of /docs/classes, run as they are shown, with the placeholders replaced. */
import { execFile } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import { classViewSchema, createdClassSchema, joinedClassSchema } from "@corridor/protocol";
import { expect, it } from "vitest";
import { lesson } from "../../../apps/relay/src/platform/testing/sample-documents.ts";
import { startTestRelay, testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

const page = readFileSync(
  join(import.meta.dirname, "../../../apps/relay/src/site/docs/pages/classes.md"),
  "utf8",
);
const [create = "", use = "", listen = ""] = [...page.matchAll(/```sh\n([^]*?)```/g)].map(
  ([, commands = ""]) => commands,
);

it("creates a class, lets a student join, and ends it with the commands of its page", async () => {
  const { origin } = await startTestRelay();
  const cwd = testFolder();
  writeFileSync(join(cwd, "lesson.json"), JSON.stringify(lesson));
  const replaced: [string, string][] = [["http://HOST", origin]];
  const run = async (commands: string): Promise<string> => {
    let script = commands;
    for (const [name, value] of replaced) script = script.replaceAll(name, value);
    return (await promisify(execFile)("sh", ["-c", script], { cwd })).stdout;
  };
  const created = createdClassSchema.parse(JSON.parse(await run(create)));
  replaced.push(
    ["classes/ID", `classes/${created.id}`],
    ["TEACHER_KEY", created.teacherKey],
    [`"CODE"`, `"${created.code}"`],
  );
  const lines = use.trim().split("\n");
  const settings = lines.filter((line) => /^[A-Z]+=/.test(line)).join("\n");
  const [joinClass = "", read = "", pause = "", end = "", ...more] = lines
    .filter((line) => line.startsWith("curl"))
    .map((line) => `${settings}\n${line}`);
  expect(more).toEqual([]);
  const student = joinedClassSchema.parse(JSON.parse(await run(joinClass)));
  const view = classViewSchema.parse(JSON.parse(await run(read)));
  expect(view.students).toMatchObject([{ student: student.student, name: student.name }]);
  expect(await run(pause)).toBe("");

  const [connect = "", fetchMessages = ""] = listen.trim().split("\n");
  const { key } = JSON.parse(await run(`${settings}\n${connect}`)) as { key: string };
  replaced.push(["CONNECTION_KEY", key]);
  const messages = await run(`${settings}\n${fetchMessages}`);
  expect(JSON.parse(messages)).toMatchObject({
    first: 1,
    messages: [
      { type: "welcome", settings: { pauseEndsInMs: expect.any(Number) } },
      { type: "tiles" },
    ],
  });

  expect(await run(end)).toBe("");
  expect(await run(read)).toContain("/problems/no-class");
});
