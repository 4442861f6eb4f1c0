/**
 * Programs as code, run as separate processes, drive the robot of a page.
 * tests/integration/web/code-export.test.ts compares all languages, without a page.
 */
import { readFile } from "node:fs/promises";
import { encodeLink } from "@corridor/link";
import { paperPrograms } from "@corridor/program/testing";
import { ProgramScript, thesisMazes } from "../tests/support/code-export/program-script.ts";
import { GOAL, runScript, runtimes } from "../tests/support/code-export/script-run.ts";
import { expect, test } from "./fixtures.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test("scripts drive the robot of a page on the paths of the programs of the thesis", async ({
  page,
}) => {
  test.setTimeout(400_000);
  await page.setViewportSize(smallWindow.viewport);
  const { tree } = thesisMazes;
  const link = encodeLink({ maze: tree });
  if (!link.ok) throw new Error(link.code);
  await page.goto(`/#${link.text}`);
  await setSpeed(page, "max");
  const address = await copyAddress(page);
  const sentences: (string | null)[] = [];
  let cuts = 0;
  for (const { figure, program } of paperPrograms) {
    const script = await ProgramScript.write("python", address, program);
    const { difference, sentence } = await script.compareIn(tree);
    await script.close();
    expect(difference, `figure ${figure}`).toBeNull();
    sentences.push(sentence);
    cuts += script.cuts;
  }
  expect(sentences).toContain(GOAL);
  expect(cuts).toBeGreaterThan(5);
});

test("the panel shows the program as code, follows each edit, and copies a file that drives", async ({
  corridor,
  page,
}) => {
  const { program } = corridor;
  await program.button("Show as code").click();
  const code = program.region.getByRole("textbox", { name: "The program as code" });
  await expect(code).toHaveValue(/ {4}if right > 60:\n {8}drive\("line 1", "delayed right 90"\)/);
  // The robot's address is there, but a projector does not show its key.
  await expect(code).toHaveValue(/ROBOT = "http:[^"]+\/r\/[\w-]{22}#•••• •••• [\w-]{4}"/);
  await program.number(1).fill("61.5");
  await expect(code).toHaveValue(/if right > 61\.5:[^]+"right > 61\.5 or front < 50"/);
  await program.region.getByRole("radio", { name: "C#" }).check({ force: true });
  await expect(code).toHaveValue(/if \(right > 61\.5\) \{/);
  await program.region.getByRole("radio", { name: "Python" }).check({ force: true });

  await program.button("Copy").click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const download = page.waitForEvent("download");
  await program.button("Save rules.py").click();
  const saved = await download;
  expect(saved.suggestedFilename()).toBe("rules.py");
  expect(await readFile(await saved.path(), "utf8")).toBe(copied);

  await setSpeed(page, "max");
  await page.getByRole("radio", { name: "Remote" }).click();
  const { lines, end } = await runScript([...(await runtimes.python.start("-c")), copied]);
  expect(lines.length).toBeGreaterThan(0);
  expect(end === null || end.sentence === GOAL, end?.sentence).toBe(true);
});

test("shows the code in sight on a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  await phone.program.button("Show as code").tap();
  await expect(phone.program.button("Save rules.py")).toBeInViewport();
  await expect(
    phone.program.region.getByRole("textbox", { name: "The program as code" }),
  ).toBeInViewport();
});
