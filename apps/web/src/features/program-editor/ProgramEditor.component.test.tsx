import { rightsOf, type ChallengeDocument } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import type { SensorReadings } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { page, userEvent, type Locator } from "vitest/browser";
import { expectAccessible } from "../../shell/testing/expect-accessible.ts";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { runEventAt } from "../../simulator/worker/testing/run-event-at.ts";
import { messageIn } from "../../shell/testing/message-in.ts";
import { ProgramEditor } from "./ProgramEditor.tsx";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};
const right = /if right is more than 60, delayed right 90\./;
const front = /if front is less than 50, left 90\./;

async function renderEditor() {
  return renderWithServices(<ProgramEditor />, { program });
}

const lines = page.getByRole("listitem", { name: /^Line / });
const line = (number: number): Locator => lines.nth(number - 1);
const condition = (number: number) =>
  page.getByRole("combobox", { name: `Line ${number}, condition` });
const number = (at: number) => page.getByRole("textbox", { name: `Line ${at}, distance in cm` });
const action = (at: number) => page.getByRole("combobox", { name: `Line ${at}, action` });
const button = (name: string) => page.getByRole("button", { name });
const readings = (changes: Partial<SensorReadings>): SensorReadings => ({
  front: 250,
  right: 50,
  back: 50,
  left: 50,
  ...changes,
});

/** Line 1 began a delayed turn too late, and hit the wall after 24 of 50 cm. */
const lateTurn: RunEvent = {
  ...runEventAt("bump", 40),
  program,
  cause: {
    decidedAt: 20,
    startedAt: 20,
    action: "delayed right 90",
    readings: readings({ front: 49 }),
    part: 0,
    parts: 3,
    side: "front",
    reading: 49,
    driven: 24,
    needed: 50,
  },
  diagnosis: {
    event: { kind: "late", tick: 40 },
    cause: {
      kind: "delayed",
      side: "right",
      needs: 75,
      moment: {
        tick: 20,
        line: 0,
        when: null,
        action: "delayed right 90",
        readings: readings({ front: 49 }),
      },
    },
    fixes: [],
  },
};

async function press(target: Locator, keys: string): Promise<void> {
  const element = target.element();
  if (element instanceof HTMLElement) element.focus();
  await userEvent.keyboard(keys);
}

describe("a line", () => {
  it("is named by its sentence, and by whether it is true, with the number", async () => {
    const { show } = await renderEditor();
    show({ sensors: readings({ right: 250.5, front: 250 }) });
    await expect
      .element(line(1))
      .toHaveAccessibleName(
        "Line 1: if right is more than 60, delayed right 90. Right is 250.5, true.",
      );
    await expect
      .element(line(2))
      .toHaveAccessibleName("Line 2: if front is less than 50, left 90. Front is 250, false.");
    await expectAccessible();
  });

  it("shows a tick or a cross with both numbers, which follow the readings", async () => {
    const { show } = await renderEditor();
    show({ sensors: readings({ right: 250 }) });
    await expect.element(line(1).getByText("true:")).toBeInTheDocument();
    await expect.element(line(1)).toMatchTextContent(/true:250\s*> 60/);
    show({ sensors: readings({ right: 60 }) });
    await expect.element(line(1).getByText("false:")).toBeInTheDocument();
    await expect.element(line(1)).toMatchTextContent(/false:60\s*> 60/);
  });

  it("without a condition is skipped, and has no number", async () => {
    const { show } = await renderEditor();
    show();
    await condition(1).selectOptions("choose a condition");
    await expect
      .element(line(1))
      .toHaveAccessibleName("Line 1: choose a condition. Skipped until then.");
    await expect.element(line(1).getByText("skipped", { exact: true })).toBeVisible();
    await expect.element(number(1)).not.toBeInTheDocument();
    // A condition that is chosen again gets its number back.
    await condition(1).selectOptions("left > right +");
    await expect.element(number(1)).toHaveValue("60");
    await expect.element(line(1)).toHaveAccessibleName(/if left is more than right plus 60/);
  });
});

describe("while the program drives", () => {
  it("the line that decides is the current one, and the lines below were not read", async () => {
    const { show } = await renderEditor();
    show({
      state: "running",
      tick: 30,
      line: 0,
      sensors: readings({ right: 250, front: 40 }),
    });
    await expect.element(line(1)).toHaveAttribute("aria-current", "step");
    await expect.element(line(1)).toHaveAccessibleName(/^Line 1, running: .*true\.$/);
    await expect.element(line(2)).not.toHaveAttribute("aria-current");
    await expect.element(line(2)).toHaveAccessibleName(/true, not read this time\.$/);
    await expect.element(page.getByText("not read this time")).toBeVisible();
  });

  it("“otherwise” is the current one where no line is true", async () => {
    const { show } = await renderEditor();
    show({ state: "running", tick: 30, line: "default", sensors: readings({}) });
    await expect.element(page.getByRole("group", { name: "otherwise, running" })).toBeVisible();
    await expect
      .element(lines.and(page.getByRole("listitem", { name: /running/ })))
      .toHaveLength(0);
  });

  it("no line is the current one while the student drives", async () => {
    const { show } = await renderEditor();
    show({ state: "running", tick: 30, driver: "me", line: null, sensors: readings({}) });
    await expect.element(line(1)).toHaveAccessibleName(/^Line 1: /);
    await expect.element(line(1)).not.toHaveAttribute("aria-current");
  });

  it("no line animates a progress bar while it rests", async () => {
    await renderEditor();
    await expect.element(line(1)).toBeVisible();
    const bars = [...document.querySelectorAll("progress")];
    // A bar without a value has the position -1, and Chromium animates it even while it is hidden.
    expect(bars.map(({ position }) => position)).toEqual([0, 0, 0]);
  });

  it("a manoeuvre shows how far it still is, and a bump which line to look at", async () => {
    const { show, receive } = await renderEditor();
    const driving = {
      state: "running",
      tick: 30,
      line: 0,
      sensors: readings({ right: 250 }),
    } as const;
    const progress = {
      action: "delayed right 90",
      part: 0,
      parts: 3,
      kind: "drive",
      direction: 1,
      left: 36,
      of: 50,
    } as const;
    show(driving, { progress });
    await expect
      .element(page.getByRole("progressbar", { name: "turns in 36 cm" }))
      .toHaveAttribute("value", "14");
    receive({ type: "event", event: lateTurn });
    show({ ...driving, state: "paused", tick: 40, bumping: true, bumps: 1 });
    await expect.element(line(1)).toHaveAccessibleName(/^Line 1, look here: /);
    await expect.element(line(1).getByText("bumped after 24 of 50 cm")).toBeVisible();
  });
});

describe("dropdowns and numbers", () => {
  it("change the sentence with the mouse", async () => {
    const { workspace } = await renderEditor();
    await condition(1).selectOptions("front <");
    await number(1).fill("72.5");
    await action(1).selectOptions("turn 180");
    await page.getByRole("combobox", { name: "action", exact: true }).selectOptions("left 90");
    await expect.element(line(1)).toHaveAccessibleName(/if front is less than 72\.5, turn 180\./);
    expect(workspace.getState().program).toMatchObject({
      default: "left 90",
      rules: [{ when: { sensor: "front", is: "<", than: 72.5 }, do: "turn 180" }, program.rules[1]],
    });
  });

  it("build a new line by keyboard alone: its condition has the focus, and typing chooses", async () => {
    await renderEditor();
    await press(button("Add line"), "{Enter}");
    await expect.element(condition(3)).toHaveFocus();
    // One letter: between two, the browser waits only a second, which a slow machine may exceed.
    await userEvent.keyboard("b{Tab}");
    await expect.element(number(3)).toHaveFocus();
    await userEvent.keyboard("{Control>}a{/Control}30{Tab}t");
    await expect
      .element(line(3))
      .toHaveAccessibleName(/if back is (?:less|more) than 30, turn 180\./);
  });

  it("explain an invalid number, and bring the last valid one back", async () => {
    await renderEditor();
    for (const text of ["", "sixty", "-1", "100001"]) {
      await number(1).fill(text);
      await expect.element(number(1)).toHaveAttribute("aria-invalid", "true");
      await expect
        .element(number(1))
        .toHaveAccessibleDescription("Type a distance from 0 to 100000 cm.");
      await expect.element(line(1)).toHaveAccessibleName(right);
    }
    await userEvent.keyboard("{Tab}");
    await expect.element(number(1)).toHaveValue("60");
    await expect.element(number(1)).toHaveAttribute("aria-invalid", "false");
    await expect.element(page.getByText(/^Type a distance/)).not.toBeInTheDocument();
  });

  it("are one step of undo for all digits that were typed", async () => {
    const { workspace } = await renderEditor();
    await press(number(1), "{Control>}a{/Control}125{Tab}");
    await expect.element(line(1)).toHaveAccessibleName(/more than 125/);
    expect(workspace.temporal.getState().pastStates).toHaveLength(1);
  });
});

describe("moving and deleting lines", () => {
  it("by button keeps the focus on the line, or on the button that is still enabled", async () => {
    await renderEditor();
    await press(button("Move line 2 up"), "{Enter}");
    await expect.element(line(1)).toHaveAccessibleName(front);
    await expect.element(button("Move line 1 down")).toHaveFocus();
    await userEvent.keyboard("{Enter}");
    await expect.element(line(2)).toHaveAccessibleName(front);
    await expect.element(button("Move line 2 up")).toHaveFocus();
    await expect.element(button("Move line 1 up")).toBeDisabled();
    await expect.element(button("Move line 2 down")).toBeDisabled();
  });

  it("by Alt and an arrow key keeps the focus on the line or its field", async () => {
    await renderEditor();
    await press(line(2), "{Alt>}{ArrowUp}{/Alt}");
    await expect.element(line(1)).toHaveAccessibleName(front);
    await expect.element(line(1)).toHaveFocus();
    await press(number(1), "{Alt>}{ArrowDown}{/Alt}");
    await expect.element(line(2)).toHaveAccessibleName(front);
    await expect.element(number(2)).toHaveFocus();
  });

  it("by Delete removes the line with the focus, but in a field only a digit", async () => {
    await renderEditor();
    await press(number(1), "{Home}{Delete}");
    await expect.element(number(1)).toHaveValue("0");
    await expect.element(lines).toHaveLength(2);
    await press(line(1), "{Delete}");
    await expect.element(lines).toHaveLength(1);
    await expect.element(line(1)).toHaveAccessibleName(front);
    await expect.element(line(1)).toHaveFocus();
  });

  it("can be taken back from the message", async () => {
    const { screen } = await renderEditor();
    await button("Delete line 1").click();
    await expect.element(lines).toHaveLength(1);
    const { text, action } = messageIn(screen);
    expect([text, action?.label]).toEqual(["Line 1 deleted.", "Undo"]);
    action?.run();
    await expect.element(lines).toHaveLength(2);
    await expect.element(line(1)).toHaveAccessibleName(right);
  });
});

describe("in a challenge", () => {
  const allowed: ChallengeDocument["allowed"] = {
    drivers: ["program"],
    lines: 2,
    conditions: null,
    actions: null,
    edits: ["action"],
    maze: false,
  };

  it("what is fixed is disabled with the reason, and the rest can be changed", async () => {
    const { challenge } = await renderEditor();
    challenge.setState({ rights: rightsOf({ allowed }) });
    for (const field of [condition(1), number(1)]) {
      await expect.element(field).toBeDisabled();
      await expect.element(field).toHaveAccessibleDescription("You cannot change this part here.");
    }
    await expect.element(button("Delete line 1")).not.toBeInTheDocument();
    await press(line(1), "{Delete}{Alt>}{ArrowDown}{/Alt}");
    await expect.element(line(1)).toHaveAccessibleName(right);
    await action(1).selectOptions("turn 180");
    await expect.element(line(1)).toHaveAccessibleName(/turn 180/);
  });

  it("the lines are counted where they are limited, and the limit says what counts", async () => {
    const { challenge } = await renderEditor();
    await expect.element(button("Add line")).not.toHaveAccessibleDescription(/Lines/);
    challenge.setState({
      rights: rightsOf({ allowed: { ...allowed, lines: 4, edits: ["lines"] } }),
    });
    await expect.element(button("Add line")).toHaveAccessibleDescription("Lines: 2 of 4");
    await button("Add line").click();
    await expect.element(page.getByText("Lines: 3 of 4")).toBeVisible();
    await button("Add line").click();
    await expect.element(button("Add line")).toBeDisabled();
    await expect
      .element(button("Add line"))
      .toHaveAccessibleDescription("You can use 4 lines here. “Otherwise” does not count.");
  });
});
