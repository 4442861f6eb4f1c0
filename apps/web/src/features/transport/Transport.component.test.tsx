import { rightsOf } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { page, userEvent } from "vitest/browser";
import { expectAccessible } from "../../shell/testing/expect-accessible.ts";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import { RunControls } from "../../shell/RunControls.tsx";

const button = (name: string) => page.getByRole("button", { name });
const speed = page.getByRole("combobox", { name: "Speed" });
const driving = { state: "running", driver: "program", tick: 90 } as const;

describe("before a run", () => {
  it("offers Run, Step and Reset, says how to start, and offers no step back", async () => {
    const { show } = await renderWithServices(<RunControls />);
    show();
    for (const name of ["Run", "Step", "Reset"]) await expect.element(button(name)).toBeEnabled();
    await expect.element(button("One decision back")).not.toBeInTheDocument();
    await expect
      .element(page.getByText("Run starts the program. Step takes one decision."))
      .toBeVisible();
    await expectAccessible();
  });

  it("starts the program with a click, with Enter and with Space", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show();
    await button("Run").click();
    button("Run").element().focus();
    await userEvent.keyboard("{Enter}");
    await userEvent.keyboard(" ");
    expect(sent).toEqual(Array.from({ length: 3 }, () => ({ type: "run" })));
  });
});

describe("while the program drives", () => {
  it("offers Pause in the place of Run, and shows time and bumps", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show({ ...driving, bumps: 2 });
    await expect.element(button("Run")).not.toBeInTheDocument();
    await expect.element(button("One decision back")).not.toBeInTheDocument();
    await expect.element(page.getByText("0:01.5")).toBeVisible();
    await expect.element(page.getByText("2 bumps")).toBeVisible();
    await button("Pause").click();
    expect(sent).toContainEqual({ type: "pause" });
    await expectAccessible();
  });

  it("keeps the focus on the button when Run becomes Pause", async () => {
    const { show } = await renderWithServices(<RunControls />);
    show();
    button("Run").element().focus();
    await userEvent.keyboard("{Enter}");
    show(driving);
    await expect.element(button("Pause")).toHaveFocus();
  });

  it("puts the robot back to its start with Reset", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show(driving);
    await button("Reset").click();
    expect(sent).toContainEqual({ type: "reset" });
  });
});

describe("after a pause", () => {
  it("steps to the next decision, and with Shift by one tick", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show({ tick: 90 });
    await button("Step").click();
    await button("Step").click({ modifiers: ["Shift"] });
    expect(sent).toContainEqual({ type: "step", length: "decision" });
    expect(sent).toContainEqual({ type: "step", length: "tick" });
  });

  it("steps back by one decision, and with Shift by one tick", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show({ tick: 90 });
    await button("One decision back").click();
    await button("One decision back").click({ modifiers: ["Shift"] });
    expect(sent).toContainEqual({ type: "seek-step", by: -1 });
    expect(sent).toContainEqual({ type: "seek", tick: 89 });
  });

  it("offers to run from the moment that is shown, and says so beside the clock", async () => {
    const { show, sent } = await renderWithServices(<RunControls />);
    show({ tick: 90 }, { view: "past", nowTick: 300 });
    await expect.element(page.getByText("in the past", { exact: true })).toBeVisible();
    await button("Run from here").click();
    await button("Step").click();
    expect(sent).toContainEqual({ type: "run-here" });
    expect(sent).toContainEqual({ type: "seek-step", by: 1 });
  });
});

describe("the speed", () => {
  it("is chosen by keyboard, and reaches the robot", async () => {
    const { sent } = await renderWithServices(<RunControls />);
    await expect.element(speed).toHaveDisplayValue("1×");
    speed.element().focus();
    await userEvent.keyboard("m");
    await expect.element(speed).toHaveDisplayValue("max");
    expect(sent).toContainEqual({ type: "speed", speed: "max" });
  });
});

describe("where the program must not drive", () => {
  it("disables Run and Step with the reason, but not Reset", async () => {
    const { show, challenge } = await renderWithServices(<RunControls />);
    show({ driver: "me" });
    challenge.setState({
      rights: rightsOf({
        allowed: {
          drivers: ["me"],
          lines: 0,
          conditions: null,
          actions: null,
          edits: [],
          maze: false,
        },
      }),
    });
    for (const name of ["Run", "Step"]) {
      await expect.element(button(name)).toBeDisabled();
      await expect
        .element(button(name))
        .toHaveAccessibleDescription("You drive here. Hold a drive key.");
    }
    await expect.element(button("Reset")).toBeEnabled();
  });

  it("disables Run after the simulator stopped for good", async () => {
    const { show, receive } = await renderWithServices(<RunControls />);
    show();
    receive({ type: "fault", reason: "out of memory" });
    await expect.element(button("Run")).toBeDisabled();
  });
});
