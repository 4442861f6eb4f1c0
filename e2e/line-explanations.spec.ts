/**
 * Lines explain the robot's behaviour: true but not read, progress of a manoeuvre, bumps, and
 * fixes.
 */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/** Visible fraction of a line, from 0 to 1, inside all its scroll containers. */
async function visibleFraction(line: Locator): Promise<number> {
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

async function showsLineNotRead(corridor: CorridorPage): Promise<void> {
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
}

async function countsDownTurns(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.otherwise.selectOption("left 90");
  await corridor.speed.selectOption("0.25");
  await corridor.run.click();
  const otherwise = program.region.getByRole("group", { name: "otherwise, running" });
  await expect(otherwise.getByText(/^\d+ degrees? to go$/)).toBeVisible();

  await corridor.choosePreset("Empty");
  await program.deleteAllLines();
  await program.addLine("front >", "100", "delayed left 90");
  await corridor.run.click();
  const note = (text: RegExp) => program.line(1).getByText(text);
  await expect(note(/^turns in \d+ cm$/)).toBeVisible();
  const bar = program.line(1).getByRole("progressbar");
  await expect(bar).toHaveAccessibleName(/^turns in \d+ cm$/);
  const remaining = async () =>
    Number(/\d+/.exec((await bar.getAttribute("aria-label")) ?? "")?.[0]);
  const first = await remaining();
  const filled = async () =>
    program.line(1).evaluate((line) => {
      const widths = [...line.querySelectorAll<HTMLElement>("[aria-hidden=true]")];
      return parseFloat(
        widths.find(({ style }) => style.backgroundSize)?.style.backgroundSize ?? "",
      );
    });
  const filledFirst = await filled();
  await expect.poll(remaining).toBeLessThan(first);
  await expect.poll(filled).toBeGreaterThan(filledFirst);
  await expect(note(/^\d+ degrees? to go$/)).toBeVisible();
  await expect(note(/^\d+ cm to go$/)).toBeVisible();
}

async function keepsTickMarkInPlace(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("front >", "50", "forward");
  // A slow machine must see the robot before it reaches the wall.
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  const seen = await program.line(1).evaluate(
    (line) =>
      new Promise<{ lengths: number[]; positions: number[] }>((resolve) => {
        const number = line.querySelector("[data-is] .live-box > span > span:last-child");
        const tick = line.querySelector("[data-is] svg");
        const [lengths, positions] = [new Set<number>(), new Set<number>()];
        const recordFrame = (): void => {
          lengths.add(number?.textContent.length ?? 0);
          positions.add(tick?.getBoundingClientRect().left ?? 0);
          // Two lengths occur while the line is true. A false line has a lighter font weight.
          if (lengths.size > 1) resolve({ lengths: [...lengths], positions: [...positions] });
          else requestAnimationFrame(recordFrame);
        };
        recordFrame();
      }),
  );
  // Such as "250" and "241.7", or "103.4" and "98.1" on a machine that shows few frames.
  expect(seen.positions, `numbers of ${seen.lengths.join(", ")} characters`).toHaveLength(1);
}

async function keepsLinesInPlace(corridor: CorridorPage): Promise<void> {
  const { page, program } = corridor;
  // All lines are in sight: a line that drives for long would be scrolled into view.
  await page.setViewportSize({ ...smallWindow.viewport, height: 900 });
  await expect.poll(() => visibleFraction(program.line(2))).toBe(1);
  // At this speed, a busy page also displays that line 2 drives, which takes half a second.
  await corridor.speed.selectOption("1×");
  await corridor.run.click();
  const seen = await program.region.evaluate(
    (region) =>
      new Promise<{ drivers: string[]; positions: string[]; idleNotes: string[] }>((resolve) => {
        const [drivers, positions, idleNotes] = [
          new Set<string>(),
          new Set<string>(),
          new Set<string>(),
        ];
        const recordFrame = (): void => {
          const all = [...region.querySelectorAll("li:not([aria-hidden]), fieldset")];
          positions.add(all.map((each) => each.getBoundingClientRect().top).join(" "));
          drivers.add(all.map((each) => each.ariaCurrent ?? "-").join(" "));
          for (const line of all) {
            const note = line.querySelector("progress")?.parentElement;
            if (!note || line.ariaCurrent !== null) continue;
            const isNoteVisible = getComputedStyle(note).visibility === "visible";
            if (isNoteVisible) idleNotes.add(note.textContent);
          }
          // Line 1, line 2 and otherwise.
          const isComplete = drivers.size >= 3;
          if (isComplete)
            resolve({
              drivers: [...drivers],
              positions: [...positions],
              idleNotes: [...idleNotes],
            });
          else requestAnimationFrame(recordFrame);
        };
        recordFrame();
      }),
  );
  expect(seen.positions, `while ${seen.drivers.join(", ")} drove`).toHaveLength(1);
  expect(seen.idleNotes).toEqual([]);
  await page.setViewportSize(smallWindow.viewport);
}

async function showsBumpedLine(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.deleteAllLines();
  await program.addLine("front <", "50", "delayed left 90");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(program.line(1).getByText(/^bumped after 2[3-5] of 50 cm$/)).toBeVisible();
  await expect(program.line(1)).toHaveAccessibleName(
    /^Line 1, look here: if front is less than 50/,
  );
}

async function appliesAdvice(corridor: CorridorPage): Promise<void> {
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
}

const advices = [
  {
    problem: "a distance that this maze does not have",
    condition: "front >",
    number: "5000",
    action: "turn 180",
    reason: /^front > 5000 is never true here: no sensor sees farther than \d+ cm in this maze\.$/,
    fix: "Change to 50 cm",
    after: /if front is more than 50, turn 180\./,
  },
  {
    problem: "a delayed turn right in front of a wall",
    condition: "front <",
    number: "50",
    action: "delayed left 90",
    reason: /^front < 50 leaves too little room: .* needs 75 cm ahead\.$/,
    fix: "Change to left 90",
    after: /if front is less than 50, left 90\./,
  },
  {
    problem: "a delayed turn with a condition only on the front",
    condition: "front >",
    number: "60",
    action: "delayed right 90",
    reason: /^This line turns right, but front > 60 does not check/,
    fix: "Change to right > 60",
    after: /if right is more than 60, delayed right 90\./,
  },
  {
    problem: "a turn into an opening",
    condition: "right >",
    number: "60",
    action: "right 90",
    reason: /^right > 60 becomes true at the edge of an opening.* drives on for 50 cm first\.$/,
    fix: "Change to delayed right 90",
    after: /if right is more than 60, delayed right 90\./,
  },
] as const;

async function fixesWithOnePress(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  for (const { problem, condition, number, action, reason, fix, after } of advices) {
    await test.step(problem, async () => {
      await program.deleteAllLines();
      await program.addLine(condition, number, action);
      await expect(program.line(1).getByText(reason)).toBeVisible();
      await program.button(fix).click();
      await expect(program.line(1)).toHaveAccessibleName(after);
      await expect(program.region.getByText(reason)).toHaveCount(0);
      await expect(program.line(1)).toBeFocused();
    });
  }
}

async function keepsDismissedAdviceHidden(corridor: CorridorPage): Promise<void> {
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

  // Dismissal applies to this line with this text: another number shows the advice again.
  await program.number(1).fill("70");
  await expect(advice).toBeVisible();
  await program.number(1).fill("60");
  await expect(advice).toBeHidden();
  await program.addLine("front >", "5000", "turn 180");
  await expect(program.line(2).getByText(/is never true here/)).toBeVisible();
  await expect(advice).toBeHidden();
}

async function scrollsToRunningLine(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  await page.setViewportSize({ width: 1024, height: 768 });
  await program.deleteAllLines();
  for (let line = 1; line <= 9; line++) await program.button("Add line").click();
  await program.addLine("front >", "50", "forward");
  await expect(program.otherwise).toBeInViewport({ ratio: 1 });
  await expect(program.button("Add line")).toBeInViewport({ ratio: 1 });

  // The running line scrolls into view, and the focus does not move.
  await program.line(1).focus();
  await program.name.focus();
  await expect.poll(() => visibleFraction(program.line(10))).toBe(0);
  await corridor.run.click();
  await expect(program.line(10)).toHaveAttribute("aria-current", "step");
  await expect.poll(() => visibleFraction(program.line(10))).toBe(1);
  await expect(corridor.pause).toBeFocused();
  await expect(program.otherwise).toBeInViewport({ ratio: 1 });

  await corridor.reset.click();
  await program.condition(10).selectOption("front <");
  await program.number(10).fill("60");
  await program.action(10).selectOption("turn 180");
  await program.otherwise.selectOption("forward");
  await program.line(1).scrollIntoViewIfNeeded();
  await expect.poll(() => visibleFraction(program.line(10))).toBe(0);
  await corridor.run.click();
  await expect.poll(() => visibleFraction(program.line(10))).toBe(1);
  await program.line(10).hover();
  // While otherwise drives, there is no running line to scroll to.
  await expect(program.region.getByRole("group", { name: "otherwise, running" })).toBeVisible();
  await page.mouse.wheel(0, -2000);
  await expect.poll(() => visibleFraction(program.line(1))).toBe(1);
  await expect(program.line(10)).toHaveAttribute("aria-current", "step");
  await corridor.waitForFrames(60);
  expect(await visibleFraction(program.line(1))).toBe(1);
}

// One page: each step writes its own program, after the first, which drives the given one.
test("explains on its lines what the robot does, and gives advice", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await corridor.reset.click();
      await expect(corridor.clock).toHaveText("Time 0:00.0");
      await corridor.speed.selectOption("1");
    });
  await step(
    "keeps every line in place, without notes on idle lines, while lines drive in turn",
    keepsLinesInPlace,
  );
  await step("shows that line 2 is true but was not read", showsLineNotRead);
  await step(
    "keeps the tick mark of a line in place while its number changes",
    keepsTickMarkInPlace,
  );
  await step("shows which line bumped, and after what distance", showsBumpedLine);
  await step("applies the advice on a line that can never decide, and undoes it", appliesAdvice);
  await step("shows advice on a line, and fixes it with one press", fixesWithOnePress);
  await step(
    "runs a program despite its advice, and keeps dismissed advice hidden",
    keepsDismissedAdviceHidden,
  );
  await step(
    "keeps otherwise and Add line visible below a long program, and scrolls to the running line until the user scrolls away",
    scrollsToRunningLine,
  );
  await step(
    "counts down a turn of otherwise, and a delayed turn: the distance before it, the turn and the distance after it",
    countsDownTurns,
  );
});

test("scrolls to the running line in the sheet of a phone", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await corridor.open();
  const { program } = corridor;
  for (let line = 3; line <= 6; line++) await program.button("Add line").tap();
  await program.addLine("front >", "50", "forward");
  await program.name.scrollIntoViewIfNeeded();
  await corridor.run.tap();
  await expect(program.line(7)).toHaveAttribute("aria-current", "step");
  await expect.poll(() => visibleFraction(program.line(7))).toBe(1);
});
