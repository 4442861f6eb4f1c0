import { describe, expect, it } from "vitest";
import { page, userEvent } from "vitest/browser";
import { useState } from "react";
import { setProgram } from "../model/workspace/workspace-store.ts";
import { RunControls } from "./RunControls.tsx";
import { ShortcutsDialog } from "./ShortcutsDialog.tsx";
import { renderWithServices } from "./testing/render-with-services.tsx";
import { useKeyboard } from "./use-keyboard.ts";

/** The page's keys, with the transport, a field and the list of keys. */
function Keys() {
  const [isOpen, setIsOpen] = useState(false);
  useKeyboard(() => setIsOpen(true));
  return (
    <>
      <RunControls />
      <input aria-label="Name" />
      <ShortcutsDialog isOpen={isOpen} onClose={() => setIsOpen(false)} />
    </>
  );
}

const driving = { state: "running", driver: "program", tick: 90 } as const;
const name = page.getByRole("textbox", { name: "Name" });
const help = page.getByRole("dialog", { name: "Keyboard shortcuts" });

describe("the keys of a run", () => {
  it("run with Ctrl+Enter, pause with it while the program drives, and step with Shift", async () => {
    const { show, sent } = await renderWithServices(<Keys />);
    show();
    await userEvent.keyboard("{Control>}{Enter}{/Control}");
    show(driving);
    await userEvent.keyboard("{Control>}{Enter}{/Control}");
    show({ tick: 95 });
    await userEvent.keyboard("{Control>}{Shift>}{Enter}{/Shift}{/Control}");
    const types = sent.map(({ type }) => type).filter((type) => /^(run|pause|step)$/.test(type));
    expect(types).toEqual(["run", "pause", "step"]);
  });

  it("stop a driving robot with Escape", async () => {
    const { show, sent } = await renderWithServices(<Keys />);
    show(driving);
    await userEvent.keyboard("{Escape}");
    expect(sent).toContainEqual({ type: "pause" });
  });

  it("drive while an arrow key is held, and stop on release", async () => {
    const { show, sent } = await renderWithServices(<Keys />);
    show({ driver: "me" });
    await userEvent.keyboard("{ArrowUp>}");
    expect(sent).toContainEqual({ type: "hold", key: "forward" });
    await userEvent.keyboard("{/ArrowUp}");
    expect(sent.at(-1)).toEqual({ type: "hold", key: "stop" });
  });

  it("undo and redo an edit with Ctrl+Z and Ctrl+Shift+Z", async () => {
    const { workspace } = await renderWithServices(<Keys />);
    const { program } = workspace.getState();
    setProgram(workspace, { ...program, rules: [] });
    await userEvent.keyboard("{Control>}z{/Control}");
    expect(workspace.getState().program.rules).toEqual(program.rules);
    await userEvent.keyboard("{Control>}{Shift>}Z{/Shift}{/Control}");
    expect(workspace.getState().program.rules).toEqual([]);
  });
});

describe("keys that belong to something else", () => {
  it("type letters into a field, and neither drive nor open the list of keys", async () => {
    const { show, sent } = await renderWithServices(<Keys />);
    show({ driver: "me" });
    await name.click();
    await userEvent.keyboard("was?");
    await expect.element(name).toHaveValue("was?");
    await expect.element(help).not.toBeInTheDocument();
    expect(sent.filter(({ type }) => type === "hold")).toEqual([]);
  });

  it("close the open list of keys with Escape, and let the robot drive on", async () => {
    const { show, sent } = await renderWithServices(<Keys />);
    show(driving);
    await userEvent.keyboard("?");
    await expect.element(help).toBeVisible();
    await userEvent.keyboard("{Control>}{Enter}{/Control}");
    await userEvent.keyboard("{Escape}");
    await expect.element(help).not.toBeInTheDocument();
    expect(sent.filter(({ type }) => type === "pause" || type === "run")).toEqual([]);
  });

  it("do nothing without Ctrl where single keys are switched off", async () => {
    const { show, sent, screen } = await renderWithServices(<Keys />);
    show({ driver: "me" });
    screen.setState({ singleKeys: false });
    await userEvent.keyboard("w?");
    await expect.element(help).not.toBeInTheDocument();
    expect(sent.filter(({ type }) => type === "hold")).toEqual([]);
    await userEvent.keyboard("{Control>}{Enter}{/Control}");
    expect(sent).toContainEqual({ type: "run" });
  });
});
