/**
 * Page object of the simulator. Locates elements by role and name. Squares are counted from 0 and
 * lines from 1, as in documents and on the line badges.
 */
import { expect, type Locator, type Page } from "playwright/test";
import { MazeGrid } from "./maze-grid.ts";
import { ProgramPanel } from "./program-panel.ts";
import { TimelinePanel } from "./timeline-panel.ts";

export interface ChosenFile {
  name: string;
  mimeType: string;
  buffer: Buffer;
}

export type Driver = "Me" | "Program" | "Remote";

export class CorridorPage {
  readonly page: Page;
  readonly maze: MazeGrid;
  readonly program: ProgramPanel;
  readonly transport: Locator;
  readonly timeline: TimelinePanel;
  readonly messages: Locator;

  constructor(page: Page) {
    this.page = page;
    this.maze = new MazeGrid(page);
    this.program = new ProgramPanel(page);
    this.transport = page.getByRole("region", { name: "Run" });
    this.timeline = new TimelinePanel(page, this.transport);
    this.messages = page.getByRole("region", { name: "Messages" });
  }

  /** Opens an address of the page and waits until the robot is displayed. */
  async open(address = "/"): Promise<void> {
    await this.page.goto(address);
    await this.waitUntilReady();
  }

  async reload(): Promise<void> {
    await this.page.reload();
    await this.waitUntilReady();
  }

  async waitUntilReady(): Promise<void> {
    // `expect` describes the whole page after each attempt, while the page is loading.
    await this.robotPose.waitFor();
    await this.maze.grid.waitFor();
  }

  // Controls.

  get run(): Locator {
    return this.transport.getByRole("button", { name: "Run", exact: true });
  }

  get pause(): Locator {
    return this.transport.getByRole("button", { name: "Pause", exact: true });
  }

  get step(): Locator {
    return this.transport.getByRole("button", { name: "Step", exact: true });
  }

  get reset(): Locator {
    return this.transport.getByRole("button", { name: "Reset", exact: true });
  }

  get speed(): Locator {
    return this.transport.getByRole("combobox", { name: "Speed" });
  }

  get share(): Locator {
    return this.page.getByRole("button", { name: "Share", exact: true });
  }

  /** The button with the maze's name, which opens the maze menu. */
  get mazeMenu(): Locator {
    return this.page.getByRole("button", { name: /, Maze menu$/ });
  }

  driver(name: Driver): Locator {
    return this.page.getByRole("group", { name: "Who drives?" }).getByRole("radio", { name });
  }

  /** Selects the driver with the mouse, and waits until the simulator accepts the choice. */
  async selectDriver(name: Driver): Promise<void> {
    await this.driver(name).click();
    await expect(this.driver(name)).toBeChecked();
  }

  /** An on-screen drive key: forward, left, stop, right or reverse. */
  driveKey(name: string): Locator {
    return this.page
      .getByRole("group", { name: "Hold to drive" })
      .getByRole("button", { name, exact: true });
  }

  dialog(name: string): Locator {
    return this.page.getByRole("dialog", { name });
  }

  /** Selects a preset maze by its title. */
  async choosePreset(title: string): Promise<void> {
    await this.page.getByRole("button", { name: "Presets", exact: true }).click();
    await this.dialog("Presets")
      .getByRole("button", { name: new RegExp(`^${title}`) })
      .click();
    await expect(this.mazeMenu).toHaveAccessibleName(`${title}, Maze menu`);
  }

  // Displayed state.

  /** "Robot at 50, 650, facing right" */
  get robotPose(): Locator {
    return this.page.getByText(/^Robot at /);
  }

  /** The robot's x coordinate in cm. */
  async robotX(): Promise<number> {
    return Number(/^Robot at (-?\d+)/.exec((await this.robotPose.textContent()) ?? "")?.[1]);
  }

  /** Simulated time, "Time 0:39.6". */
  get clock(): Locator {
    return this.transport.getByText(/^Time \d+:\d\d\.\d$/);
  }

  /** Driving time of a script, "Time 0:12.3 driving". */
  get drivingTime(): Locator {
    return this.transport.getByText(/^Time \d+:\d\d\.\d driving$/);
  }

  /** Waiting time of a script, "0:40.1 waiting". */
  get waitingTime(): Locator {
    return this.transport.getByText(/^\d+:\d\d\.\d waiting$/);
  }

  get bumps(): Locator {
    return this.transport.getByText(/^\d+ bumps?$/);
  }

  /** The note that describes the goal or the newest bump. */
  get runNote(): Locator {
    return this.transport.getByRole("note");
  }

  /** The live region for all announcements except errors. */
  get announcement(): Locator {
    return this.page.locator("#spoken");
  }

  /** The status of the connection to scripts, announced to screen readers. */
  get connectionStatus(): Locator {
    return this.page.getByRole("region", { name: "Remote" }).getByRole("status");
  }

  /** The reading of a sensor in cm. */
  sensor(name: "front" | "right" | "back" | "left"): Locator {
    return this.page
      .getByLabel("Distances in cm")
      .locator("div", { has: this.page.getByText(name, { exact: true }) })
      .getByRole("definition");
  }

  /** The card of a bump that was caused by a line, counted from 1. */
  bumpCard(line: number): Locator {
    return this.page.getByRole("region", { name: `Bump: look at line ${line}` });
  }

  message(text: string | RegExp): Locator {
    return this.messages.getByText(text);
  }

  /** Dismisses all messages, so that none covers the next click target. */
  async dismissMessages(): Promise<void> {
    // Phones show the newest message only.
    const dismiss = this.messages.getByRole("button", { name: "Dismiss", includeHidden: true });
    // Clicks all in one call: a message may disappear by itself between two clicks.
    await dismiss.evaluateAll((buttons: HTMLElement[]) => {
      for (const button of buttons) button.click();
    });
    await expect(dismiss).toHaveCount(0);
  }

  /** Whether the newest edit is stored on the device. */
  get saveState(): Locator {
    return this.page.getByText(/^(Saved on this device|Saving|Not saved)$/).first();
  }

  /** The link of the share dialog for the current state. Closes the dialog. */
  async shareLink({ withProgram }: { withProgram: boolean }): Promise<string> {
    await this.share.click();
    const dialog = this.dialog("Share this maze");
    await dialog.getByRole("checkbox", { name: /^My program/ }).setChecked(withProgram);
    const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();
    await this.page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    return link;
  }

  /**
   * Selects files in the browser's file chooser.
   * @param by tap: with a finger on a phone, where the entry is in another menu
   */
  async openFiles(files: readonly ChosenFile[], by: "click" | "tap" = "click"): Promise<void> {
    const opener = by === "tap" ? this.page.getByRole("button", { name: "More" }) : this.mazeMenu;
    await opener[by]();
    const chooser = this.page.waitForEvent("filechooser");
    await this.dialog(by === "tap" ? "More" : "Maze menu")
      .getByRole("button", { name: /^Open file…/ })
      [by]();
    await (await chooser).setFiles([...files]);
  }

  /** Waits until the robot has not moved for 12 frames. */
  async waitForRobotToStop(): Promise<void> {
    await expect
      .poll(async () => {
        const before = await this.robotPose.textContent();
        await this.waitForFrames(12);
        return (await this.robotPose.textContent()) === before;
      })
      .toBe(true);
  }

  /** Waits for a number of animation frames. */
  async waitForFrames(count: number): Promise<void> {
    await this.page.evaluate(async (waitForFrames) => {
      for (let frame = 0; frame < waitForFrames; frame++) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
    }, count);
  }
}
