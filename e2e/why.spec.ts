/**
 * The lines say why: what is true though it was not read, how far a manoeuvre is, what bumped, what
 * to mend.
 */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";

/** How much of a line is in sight, from 0 to 1: inside of all that scrolls around it. */
async function shareInSight(line: Locator): Promise<number> {
  return line.evaluate((element) => {
    const { top, bottom, height } = element.getBoundingClientRect();
    let [from, to] = [top, bottom];
    for (let box = element.parentElement; box !== null; box = box.parentElement) {
      if (getComputedStyle(box).overflowY === "visible") continue;
      const around = box.getBoundingClientRect();
      from = Math.max(from, around.top);
      to = Math.min(to, around.bottom);
    }
    return Math.max(0, to - from) / height;
  });
}

test("sees that line 2 is true but was not read", async ({ corridor }) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("right <", "60", "forward");
  await program.addLine("front >", "50", "turn 180");
  await program.addLine("left >", "60", "left 90");
  await expect(program.line(1)).toHaveAttribute("aria-current", "step");
  await expect(program.line(1)).toContainText("50 < 60");
  await expect(program.runningLineNote).toHaveText("not read this time");
  await expect(program.runningLineNote).toBeVisible();
  await expect(program.line(2)).toContainText("250 > 50");
  await expect(program.line(2)).toHaveAccessibleName(
    "Line 2: if front is more than 50, turn 180. Front is 250, true, not read this time.",
  );
  await expect(program.line(3)).toContainText("50 > 60");
  await expect(program.line(3)).toHaveAccessibleName(/Left is 50, false, not read this time\.$/);
});

test("sees a delayed turn count down: the way, the turn and the way out", async ({ corridor }) => {
  const { program } = corridor;
  await corridor.choosePreset("Empty");
  await corridor.speed.selectOption("0.25");
  await program.deleteAllLines();
  await program.addLine("front >", "100", "delayed left 90");
  await corridor.run.click();
  const note = (words: RegExp) => program.line(1).getByText(words);
  await expect(note(/^turns in \d+ cm$/)).toBeVisible();
  const bar = program.line(1).getByRole("progressbar");
  await expect(bar).toHaveAccessibleName(/^turns in \d+ cm$/);
  const left = async () => Number(/\d+/.exec((await bar.getAttribute("aria-label")) ?? "")?.[0]);
  const begun = await left();
  const filled = async () =>
    program.line(1).evaluate((line) => {
      const widths = [...line.querySelectorAll<HTMLElement>("[aria-hidden=true]")];
      return parseFloat(
        widths.find(({ style }) => style.backgroundSize)?.style.backgroundSize ?? "",
      );
    });
  const filledFirst = await filled();
  await expect.poll(left).toBeLessThan(begun);
  await expect.poll(filled).toBeGreaterThan(filledFirst);
  await expect(note(/^\d+ degrees? to go$/)).toBeVisible();
  await expect(note(/^\d+ cm to go$/)).toBeVisible();
});

test("sees the tick of a line stay in its place while its number changes", async ({ corridor }) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("front >", "50", "forward");
  await corridor.run.click();
  const seen = await program.line(1).evaluate(
    (line) =>
      new Promise<{ lengths: number[]; places: number[] }>((resolve) => {
        const number = line.querySelector("[data-is] .live-box > span > span:last-child");
        const tick = line.querySelector("[data-is] svg");
        const [lengths, places] = [new Set<number>(), new Set<number>()];
        const look = (): void => {
          lengths.add(number?.textContent.length ?? 0);
          places.add(tick?.getBoundingClientRect().left ?? 0);
          // As long as the line is true: its letters are lighter when it is not.
          const isSeen = lengths.has(3) && lengths.has(5);
          if (isSeen) resolve({ lengths: [...lengths], places: [...places] });
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
  // "250", "241.7" or so.
  expect(seen.places, `numbers of ${seen.lengths.join(", ")} signs`).toHaveLength(1);
});

test("finds every line in its place, and no words at rest, while one after the other drives", async ({
  corridor,
}) => {
  const { program } = corridor;
  await corridor.run.click();
  await expect(corridor.clock).not.toHaveText("0:00.0");
  const seen = await program.region.evaluate(
    (region) =>
      new Promise<{ drivers: string[]; places: string[]; atRest: string[] }>((resolve) => {
        const [drivers, places, atRest] = [new Set<string>(), new Set<string>(), new Set<string>()];
        const look = (): void => {
          const all = [...region.querySelectorAll("li:not([aria-hidden]), fieldset")];
          places.add(all.map((each) => each.getBoundingClientRect().top).join(" "));
          drivers.add(all.map((each) => each.ariaCurrent ?? "-").join(" "));
          for (const line of all) {
            const words = line.querySelector("progress")?.parentElement;
            if (!words || line.ariaCurrent !== null) continue;
            const isSeen = getComputedStyle(words).visibility === "visible";
            if (isSeen) atRest.add(words.textContent);
          }
          // Line 1, line 2 and otherwise.
          const isOver = drivers.size >= 3;
          if (isOver) resolve({ drivers: [...drivers], places: [...places], atRest: [...atRest] });
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
  expect(seen.places, `while ${seen.drivers.join(", ")} drove`).toHaveLength(1);
  expect(seen.atRest).toEqual([]);
});

test("sees how far the turn of otherwise is", async ({ corridor }) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.otherwise.selectOption("left 90");
  await corridor.speed.selectOption("0.25");
  await corridor.run.click();
  const otherwise = program.region.getByRole("group", { name: "otherwise, running" });
  await expect(otherwise.getByText(/^\d+ degrees? to go$/)).toBeVisible();
});

test("sees which line bumped, and how far it came", async ({ corridor }) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("front <", "50", "delayed left 90");
  await corridor.speed.selectOption("0.25");
  await corridor.run.click();
  await expect(program.line(1).getByText(/^bumped after 2[3-5] of 50 cm$/)).toBeVisible();
  await expect(program.line(1)).toHaveAccessibleName(/^Line 1, bumped: if front is less than 50/);
});

test("takes the advice on a line that can never decide, and takes it back", async ({
  corridor,
}) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("front >", "50", "forward");
  await program.addLine("front >", "100", "delayed left 90");
  const advice = program.line(2).getByText(/^Never decides: /);
  await expect(advice).toHaveText("Never decides: whenever front > 100, line 1 decides first.");
  await expect(program.line(2)).toHaveAccessibleName(
    /Advice: Never decides: whenever front > 100, line 1 decides first\.$/,
  );
  await expect(corridor.announcement).toHaveText(/^Advice for line 2: Never decides: /);
  await program.line(2).getByRole("button", { name: "Delete line 2" }).last().click();
  await expect(program.lines).toHaveCount(1);
  await program.button("Undo").click();
  await expect(program.lines).toHaveCount(2);
  await expect(advice).toBeVisible();

  await program.action(2).selectOption("turn 180");
  await program.button("Move above line 1").click();
  await expect(program.line(1)).toHaveAccessibleName(/if front is more than 100, turn 180\./);
  await expect(program.line(1)).toBeFocused();
  await expect(program.region.getByText(/^Never decides: /)).toHaveCount(0);
  await program.button("Undo").click();
  await expect(program.line(2)).toHaveAccessibleName(/if front is more than 100, turn 180\./);
  await expect(advice).toBeVisible();
});

const mends = [
  {
    what: "a distance that this maze does not have",
    condition: "front >",
    number: "5000",
    action: "turn 180",
    reason: /^front > 5000 is never true here: no sensor sees farther than \d+ cm in this maze\.$/,
    mend: "Change to 50 cm",
    after: /if front is more than 50, turn 180\./,
  },
  {
    what: "a delayed turn just before a wall",
    condition: "front <",
    number: "50",
    action: "delayed left 90",
    reason: /^front < 50 leaves too little room: .* needs 75 cm ahead\.$/,
    mend: "Change to left 90",
    after: /if front is less than 50, left 90\./,
  },
  {
    what: "a delayed turn that asks only about the front",
    condition: "front >",
    number: "60",
    action: "delayed right 90",
    reason: /^This line turns right, but front > 60 does not check/,
    mend: "Change to right > 60",
    after: /if right is more than 60, delayed right 90\./,
  },
  {
    what: "a turn into an opening",
    condition: "right >",
    number: "60",
    action: "right 90",
    reason: /^right > 60 becomes true at the edge of an opening.* drives on for 50 cm first\.$/,
    mend: "Change to delayed right 90",
    after: /if right is more than 60, delayed right 90\./,
  },
] as const;

for (const { what, condition, number, action, reason, mend, after } of mends) {
  test(`is advised on ${what}, and mends it by one press`, async ({ corridor }) => {
    const { program } = corridor;
    await program.deleteAllLines();
    await program.addLine(condition, number, action);
    await expect(program.line(1).getByText(reason)).toBeVisible();
    await program.button(mend).click();
    await expect(program.line(1)).toHaveAccessibleName(after);
    await expect(program.region.getByText(reason)).toHaveCount(0);
    await expect(program.line(1)).toBeFocused();
  });
}

test("runs a program in spite of its advice, hides the advice, and it stays away", async ({
  corridor,
}) => {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("right >", "60", "right 90");
  const advice = program.line(1).getByText(/becomes true at the edge of an opening/);
  await expect(advice).toBeVisible();
  await corridor.run.click();
  await expect(corridor.robotPose).not.toHaveText(/^Robot at 50, 650/);
  await expect(advice).toBeVisible();
  await corridor.pause.click();
  await program.button("Hide this advice").click();
  await expect(advice).toBeHidden();
  await expect(program.line(1)).toBeFocused();

  // Only this line with these words: it comes for another number, and not for the old one.
  await program.number(1).fill("70");
  await expect(advice).toBeVisible();
  await program.number(1).fill("60");
  await expect(advice).toBeHidden();
  await program.addLine("front >", "5000", "turn 180");
  await expect(program.line(2).getByText(/is never true here/)).toBeVisible();
  await expect(advice).toBeHidden();
});

test("reaches otherwise and Add line below a long program, and sees the line that runs", async ({
  corridor,
  page,
}) => {
  const { program } = corridor;
  await page.setViewportSize({ width: 1024, height: 768 });
  await program.deleteAllLines();
  for (let line = 1; line <= 9; line++) await program.button("Add line").click();
  await program.addLine("front >", "50", "forward");
  await expect(program.otherwise).toBeInViewport({ ratio: 1 });
  await expect(program.button("Add line")).toBeInViewport({ ratio: 1 });

  // The running line comes into sight, and the focus stays where it is.
  await program.line(1).focus();
  await program.name.focus();
  await expect.poll(() => shareInSight(program.line(10))).toBe(0);
  await corridor.run.click();
  await expect(program.line(10)).toHaveAttribute("aria-current", "step");
  await expect.poll(() => shareInSight(program.line(10))).toBe(1);
  await expect(corridor.pause).toBeFocused();
  await expect(program.otherwise).toBeInViewport({ ratio: 1 });
});

test("scrolls away from the line that runs, and is left alone", async ({ corridor, page }) => {
  const { program } = corridor;
  await page.setViewportSize({ width: 1024, height: 768 });
  await program.deleteAllLines();
  for (let line = 1; line <= 8; line++) await program.button("Add line").click();
  await program.addLine("front <", "60", "turn 180");
  await program.otherwise.selectOption("forward");
  await program.line(1).scrollIntoViewIfNeeded();
  await expect.poll(() => shareInSight(program.line(9))).toBe(0);
  await corridor.run.click();
  await expect.poll(() => shareInSight(program.line(9))).toBe(1);
  await program.line(9).hover();
  // Meanwhile otherwise drives: there is no running line that could be in sight.
  await expect(program.region.getByRole("group", { name: "otherwise, running" })).toBeVisible();
  await page.mouse.wheel(0, -2000);
  await expect.poll(() => shareInSight(program.line(1))).toBe(1);
  await expect(program.line(9)).toHaveAttribute("aria-current", "step");
  await corridor.waitForFrames(60);
  expect(await shareInSight(program.line(1))).toBe(1);
});

test("sees the line that runs in the sheet of a phone", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await corridor.open();
  const { program } = corridor;
  for (let line = 3; line <= 6; line++) await program.button("Add line").tap();
  await program.addLine("front >", "50", "forward");
  await program.name.scrollIntoViewIfNeeded();
  await corridor.run.tap();
  await expect(program.line(7)).toHaveAttribute("aria-current", "step");
  await expect.poll(() => shareInSight(program.line(7))).toBe(1);
});
