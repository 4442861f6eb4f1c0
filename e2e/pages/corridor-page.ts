/**
 * The page as its user finds it: by role and name. Squares are counted from 0 and lines from 1, as
 * in documents and on the badges.
 */
import { expect, type Locator, type Page } from "playwright/test";
import { MazeGrid } from "./maze-grid.ts";
import { ProgramPanel } from "./program-panel.ts";
import { TimelineStrip } from "./timeline-strip.ts";

export type Driver = "Me" | "Program" | "Remote";

export class CorridorPage {
  readonly page: Page;
  readonly maze: MazeGrid;
  readonly program: ProgramPanel;
  readonly transport: Locator;
  readonly timeline: TimelineStrip;
  readonly messages: Locator;

  constructor(page: Page) {
    this.page = page;
    this.maze = new MazeGrid(page);
    this.program = new ProgramPanel(page);
    this.transport = page.getByRole("region", { name: "Run" });
    this.timeline = new TimelineStrip(page, this.transport);
    this.messages = page.getByRole("region", { name: "Messages" });
  }

  /** Opens an address of the page and waits until the robot is there. */
  async open(address = "/"): Promise<void> {
    await this.page.goto(address);
    await this.isReady();
  }

  async reload(): Promise<void> {
    await this.page.reload();
    await this.isReady();
  }

  async isReady(): Promise<void> {
    await expect(this.robotPlace).toBeVisible();
    await expect(this.maze.grid).toBeVisible();
  }

  // What the reader presses.

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

  /** Hands the robot over, with the mouse. The choice is taken once the simulator agrees. */
  async letDrive(name: Driver): Promise<void> {
    await this.driver(name).click();
    await expect(this.driver(name)).toBeChecked();
  }

  /** A key on the screen: forward, left, stop, right or reverse. */
  driveKey(name: string): Locator {
    return this.page
      .getByRole("group", { name: "Hold to drive" })
      .getByRole("button", { name, exact: true });
  }

  dialog(name: string): Locator {
    return this.page.getByRole("dialog", { name });
  }

  /** Chooses a maze of the menu by its title. */
  async choosePreset(title: string): Promise<void> {
    await this.page.getByRole("button", { name: "Presets", exact: true }).click();
    await this.dialog("Presets")
      .getByRole("button", { name: new RegExp(`^${title}`) })
      .click();
    await expect(this.mazeMenu).toHaveAccessibleName(`${title}, Maze menu`);
  }

  // What the reader sees.

  /** "Robot at 50, 650, facing right" */
  get robotPlace(): Locator {
    return this.page.getByText(/^Robot at /);
  }

  /** The robot's place along the maze, in cm. */
  async robotX(): Promise<number> {
    return Number(/^Robot at (-?\d+)/.exec((await this.robotPlace.textContent()) ?? "")?.[1]);
  }

  /** Simulated time, "Time 0:39.6". */
  get clock(): Locator {
    return this.transport.getByText(/^Time \d+:\d\d\.\d$/);
  }

  /** What a script drove, "Time 0:12.3 driving". */
  get driving(): Locator {
    return this.transport.getByText(/^Time \d+:\d\d\.\d driving$/);
  }

  /** How long a script let the robot wait, "0:40.1 waiting". */
  get waiting(): Locator {
    return this.transport.getByText(/^\d+:\d\d\.\d waiting$/);
  }

  get bumps(): Locator {
    return this.transport.getByText(/^\d+ bumps?$/);
  }

  /** The goal or the newest bump in words, to be read when one comes to it. */
  get story(): Locator {
    return this.transport.getByRole("note");
  }

  /** What those who listen are told: the one live region for all that is no error. */
  get spoken(): Locator {
    return this.page.locator("#spoken");
  }

  /** What a screen reader is told of the connection to scripts. */
  get connection(): Locator {
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

  /** Dismisses all messages, so that none covers what is pressed next. */
  async dismissMessages(): Promise<void> {
    const dismiss = this.messages.getByRole("button", { name: "Dismiss" });
    // All at once: a message may leave by itself while the one before it is being clicked.
    await dismiss.evaluateAll((buttons: HTMLElement[]) => {
      for (const button of buttons) button.click();
    });
    await expect(dismiss).toHaveCount(0);
  }

  /** Whether the device has the newest edit. */
  get saveState(): Locator {
    return this.page.getByText(/^(Saved on this device|Saving|Not saved)$/).first();
  }

  /** The link of the share dialog as it stands now; the dialog is closed again. */
  async shareLink({ withProgram }: { withProgram: boolean }): Promise<string> {
    await this.share.click();
    const dialog = this.dialog("Share this maze");
    await dialog.getByRole("checkbox", { name: /^My program/ }).setChecked(withProgram);
    const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();
    await this.page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    return link;
  }

  /** Waits until the robot has stood still for a dozen frames. */
  async robotStands(): Promise<void> {
    await expect
      .poll(async () => {
        const before = await this.robotPlace.textContent();
        await this.frames(12);
        return (await this.robotPlace.textContent()) === before;
      })
      .toBe(true);
  }

  /** Lets the page draw a number of frames. */
  async frames(count: number): Promise<void> {
    await this.page.evaluate(async (frames) => {
      for (let frame = 0; frame < frames; frame++) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
    }, count);
  }
}
