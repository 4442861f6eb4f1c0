import { isBlock, type MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { page, userEvent } from "vitest/browser";
import { undo } from "../../model/workspace/workspace-store.ts";
import { expectAccessible } from "../../shell/testing/expect-accessible.ts";
import { StageArea } from "../../shell/StageArea.tsx";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import { messageIn } from "../../shell/testing/message-in.ts";
import { SpokenRun } from "../speech/SpokenRun.tsx";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Room",
  blocks: ["....", ".#..", "...."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 3, row: 2 }],
};

/** The stage with the live region and the messages, and the keyboard's cursor on the start. */
async function renderStage() {
  const part = await renderWithServices(
    <>
      <div style={{ display: "grid", width: 800, height: 500 }}>
        <StageArea />
      </div>
      <SpokenRun />
    </>,
    { maze },
  );
  part.show({ pose: { x: 50, y: 50, heading: 90 } });
  square("row 1, column 1").element().focus();
  return part;
}

/** @param place such as "row 1, column 1" */
function square(place: string) {
  return page.getByRole("gridcell", { name: new RegExp(`^${place},`) });
}

async function expectCursor(name: string): Promise<void> {
  const cell = page.getByRole("gridcell", { name });
  await expect.element(cell).toHaveFocus();
  // The only square that Tab reaches.
  await expect.element(cell).toHaveAttribute("tabindex", "0");
}

const spoken = page.getByRole("status");

describe("the cursor in the maze", () => {
  it("starts on the start, and each square says what is on it", async () => {
    await renderStage();
    await expectCursor("row 1, column 1, open, start, facing right, robot here, facing right");
    await expect
      .element(page.getByRole("grid", { name: "Maze" }))
      .toHaveAccessibleDescription(
        "Arrow keys move from square to square. Space or Enter uses the chosen tool.",
      );
    await expectAccessible();
  });

  it.each([
    { keys: "{ArrowRight}", to: "row 1, column 2, open" },
    { keys: "{ArrowDown}{ArrowRight}", to: "row 2, column 2, block" },
    { keys: "{ArrowRight}{ArrowRight}{ArrowLeft}", to: "row 1, column 2, open" },
    { keys: "{End}", to: "row 1, column 4, open" },
    { keys: "{End}{PageDown}", to: "row 3, column 4, open, goal" },
    { keys: "{Control>}{End}{/Control}{Home}", to: "row 3, column 1, open" },
  ])("moves to “$to” with $keys", async ({ keys, to }) => {
    await renderStage();
    await userEvent.keyboard(keys);
    await expectCursor(to);
  });

  it("stops at the edges", async () => {
    await renderStage();
    await userEvent.keyboard("{ArrowUp}{ArrowLeft}");
    await expectCursor("row 1, column 1, open, start, facing right, robot here, facing right");
    await userEvent.keyboard("{Control>}{End}{/Control}{ArrowDown}{ArrowRight}");
    await expectCursor("row 3, column 4, open, goal");
  });

  it("follows the robot's place in the names of the squares", async () => {
    const { show } = await renderStage();
    show({ pose: { x: 150, y: 50, heading: 180 } });
    await expect
      .element(square("row 1, column 2"))
      .toHaveAccessibleName("row 1, column 2, open, robot here, facing down");
    await expectCursor("row 1, column 1, open, start, facing right");
  });
});

describe("Space and Enter", () => {
  it("add and remove a block, and say so, with the focus still on the square", async () => {
    const { workspace } = await renderStage();
    await userEvent.keyboard("{ArrowRight}{ArrowRight} ");
    await expectCursor("row 1, column 3, block");
    await expect.element(spoken).toHaveTextContent("row 1, column 3, block");
    expect(isBlock(workspace.getState().maze, 2, 0)).toBe(true);
    await userEvent.keyboard("{Enter}");
    await expectCursor("row 1, column 3, open");
    await expect.element(spoken).toHaveTextContent("row 1, column 3, open");
    undo(workspace);
    await expectCursor("row 1, column 3, block");
  });

  it("refuse to bury the robot, and say why", async () => {
    const { show, screen, workspace } = await renderStage();
    show({ pose: { x: 150, y: 50, heading: 90 } });
    await userEvent.keyboard("{ArrowRight}{Enter}");
    expect(messageIn(screen).text).toMatch(/^The robot is on this square\./);
    expect(workspace.getState().maze).toBe(maze);
    await expectCursor("row 1, column 2, open, robot here, facing right");
  });

  it("set the goal where the Goal tool is chosen, by keyboard", async () => {
    await renderStage();
    page.getByRole("radio", { name: "Blocks" }).element().focus();
    await userEvent.keyboard("{ArrowRight}{ArrowRight}");
    await expect.element(page.getByRole("radio", { name: "Goal" })).toBeChecked();
    square("row 1, column 1").element().focus();
    await userEvent.keyboard("{ArrowRight}{Enter}");
    await expectCursor("row 1, column 2, open, goal");
  });

  it("measure from square to square with the Measure tool, and Escape hides the tape", async () => {
    const { screen, workspace } = await renderStage();
    screen.setState({ tool: "measure" });
    await userEvent.keyboard("{ArrowRight}{Enter}");
    await expect.element(spoken).toHaveTextContent("Measuring from row 1, column 2, open.");
    await userEvent.keyboard("{ArrowRight}{ArrowRight}{Enter}");
    await expect.element(spoken).toMatchTextContent(/^200 cm, 2 squares/);
    await userEvent.keyboard("{Escape}");
    await expect.element(spoken).toHaveTextContent("");
    expect(workspace.getState().maze).toBe(maze);
  });
});

describe("Clear maze", () => {
  const clear = page.getByRole("button", { name: "Clear maze" });
  const dialog = page.getByRole("dialog", { name: "Clear this maze?" });

  it("asks first, and Escape keeps the maze and returns the focus", async () => {
    const { workspace } = await renderStage();
    clear.element().focus();
    await userEvent.keyboard("{Enter}");
    await expect.element(dialog).toBeVisible();
    await userEvent.keyboard("{Escape}");
    await expect.element(dialog).not.toBeInTheDocument();
    await expect.element(clear).toHaveFocus();
    expect(workspace.getState().maze).toBe(maze);
  });

  it("removes the blocks but neither start nor goals, and puts the robot back", async () => {
    const { workspace, sent } = await renderStage();
    await clear.click();
    await dialog.getByRole("button", { name: "Clear maze" }).click();
    await expect.element(dialog).not.toBeInTheDocument();
    const { blocks, start, goals } = workspace.getState().maze;
    expect(blocks).toEqual(["....", "....", "...."]);
    expect({ start, goals }).toEqual({ start: maze.start, goals: maze.goals });
    expect(sent).toContainEqual({ type: "reset" });
    undo(workspace);
    expect(workspace.getState().maze.blocks).toEqual(maze.blocks);
  });
});

describe("Resize", () => {
  const dialog = page.getByRole("dialog", { name: "Resize the maze" });
  const columns = dialog.getByRole("textbox", { name: "Columns" });

  it("shows the size, explains an invalid one, and moves the focus to it", async () => {
    const { workspace } = await renderStage();
    await page.getByRole("button", { name: "Resize" }).click();
    await expect.element(columns).toHaveValue("4");
    await columns.fill("257");
    dialog.getByRole("textbox", { name: "Rows" }).element().focus();
    await userEvent.keyboard("{Enter}");
    await expect.element(columns).toHaveFocus();
    await expect.element(columns).toHaveAccessibleDescription("Type a whole number from 1 to 256.");
    expect(workspace.getState().maze).toBe(maze);
  });

  it("says which goals a smaller maze loses, and offers to undo it", async () => {
    const { screen, workspace } = await renderStage();
    await page.getByRole("button", { name: "Resize" }).click();
    await columns.fill("3");
    await userEvent.keyboard("{Enter}");
    await expect.element(dialog).not.toBeInTheDocument();
    const { text, action } = messageIn(screen);
    expect(text).toBe("1 goal was outside the maze and was removed.");
    expect(action?.label).toBe("Undo");
    action?.run();
    expect(workspace.getState().maze).toEqual(maze);
  });
});
