/** Students join a class on `/join`, with the letters that the teacher shows. */
import type { Locator, Page } from "playwright/test";
import names from "../apps/web/src/text/en/names.json" with { type: "json" };
import { expect, test } from "./fixtures.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";

/** Letters of no class: codes are random, and the chance of this one is 1 in 64 million. */
const NO_CLASS = "ZZZ ZZZ";

function lettersOf(page: Page): Locator {
  return page.getByRole("textbox", { name: "Letters on the board" });
}

interface Visit {
  page: Page;
  relay: string;
}

async function join(page: Page, letters: string): Promise<void> {
  await lettersOf(page).fill(letters);
  await page.keyboard.press("Enter");
}

async function joinsAndReloads({ page, relay }: Visit): Promise<void> {
  const { code } = await ClassTeacher.start(relay);
  await page.goto("/join");
  await expect(lettersOf(page)).toBeFocused();
  await join(page, `${code.slice(0, 3)} - ${code.slice(3)}`.toLowerCase());
  const title = page.getByRole("heading", { name: /^Your name in this class is / });
  await expect(title).toBeFocused();
  const name = (await title.textContent())?.replace("Your name in this class is ", "") ?? "";
  expect(Object.values(names.words)).toContain(name);
  await page.reload();
  await expect(
    page.getByRole("heading", { name: `Your name in this class is ${name}` }),
  ).toBeVisible();
  await page.getByText("What my teacher sees").click();
  await expect(page.getByText("Deleted when the lesson ends.")).toBeVisible();
  await expectNoAxeViolations(page, "joined");
  await page.getByRole("link", { name: "Start" }).click();
  await expect(page.getByRole("button", { name: "Run" })).toBeVisible();
}

async function joinsByAddress({ page, relay }: Visit): Promise<void> {
  const { code } = await ClassTeacher.start(relay, ["Team 4"]);
  await page.goto(`/join#${code}`);
  await expect(lettersOf(page)).toHaveValue(`${code.slice(0, 3)} ${code.slice(3)}`);
  await page.getByRole("button", { name: "Join" }).click();
  await expect(
    page.getByRole("heading", { name: "Your name in this class is Team 4" }),
  ).toBeVisible();
  expect(new URL(page.url()).hash).toBe("");
}

async function refusesWithAdvice({ page, relay }: Visit): Promise<void> {
  const teacher = await ClassTeacher.start(relay, ["Only one"]);
  await page.goto("/join");
  const alert = page.getByRole("alert");
  await join(page, NO_CLASS);
  await expect(alert).toHaveText("No class has these letters now. Look at the board again.");
  await expect(lettersOf(page)).toHaveValue(NO_CLASS);
  await expect(lettersOf(page)).toBeFocused();
  await expectNoAxeViolations(page, "wrong letters");
  await join(page, "BCDF GHJK");
  await expect(alert).toHaveText("These are the letters of a robot. Type them into a script.");
  await teacher.direct("PUT", "/lock");
  await join(page, teacher.code);
  await expect(alert).toHaveText("This class is locked. Ask your teacher to unlock it.");
  await teacher.direct("DELETE", "/lock");
  await join(page, teacher.code);
  await expect(
    page.getByRole("heading", { name: "Your name in this class is Only one" }),
  ).toBeVisible();
  await page.goto(`/join#${teacher.code}`);
  await page.getByRole("button", { name: "Join" }).click();
  await expect(alert).toHaveText("This class is full. It has 1 student.");
  await teacher.direct("DELETE");
  await join(page, teacher.code);
  await expect(alert).toHaveText("No class has these letters now. Look at the board again.");
}

async function offersReload({ page, relay }: Visit): Promise<void> {
  const { code } = await ClassTeacher.start(relay);
  await page.route("**/api/v1/joins", (route) =>
    route.fulfill({ status: 201, json: { class: "of a later version" } }),
  );
  await page.goto(`/join#${code}`);
  await page.getByRole("button", { name: "Join" }).click();
  await expect(page.getByRole("alert")).toContainText("This page is older than the class.");
  await page.unroute("**/api/v1/joins");
  await page.getByRole("button", { name: "Reload" }).click();
  await page.getByRole("button", { name: "Join" }).click();
  await expect(page.getByRole("heading", { name: /^Your name in this class is / })).toBeVisible();
}

async function readsThatItIsOffline({ page }: Visit): Promise<void> {
  await page.goto("/join");
  await expect(lettersOf(page)).toBeVisible();
  await page.context().setOffline(true);
  await join(page, NO_CLASS);
  await expect(page.getByRole("alert")).toContainText("You are offline.");
  await page.context().setOffline(false);
}

async function takesOtherNames({ page, relay }: Visit): Promise<void> {
  const teacher = await ClassTeacher.start(relay, ["One", "Two", "Three", "Four"]);
  await page.goto(`/join#${teacher.code}`);
  await page.getByRole("button", { name: "Join" }).click();
  const title = page.getByRole("heading", { name: /^Your name in this class is / });
  const other = page.getByRole("button", { name: /^Another name/ });
  let name = await title.textContent();
  for (const left of [1, 0]) {
    await other.click();
    await expect(other).toHaveText(`Another name (${left} left)`);
    await expect(title).not.toHaveText(name ?? "");
    name = await title.textContent();
  }
  await expect(other).toHaveAttribute("aria-disabled", "true");
  await page.reload();
  await expect(title).toHaveText(name ?? "");
  await other.click();
  await expect(other).toHaveText("Another name (0 left)");
  await expect(title).toHaveText(name ?? "");
  expect(
    (await teacher.read()).students.map(
      ({ name: { text } }) => `Your name in this class is ${text}`,
    ),
  ).toEqual([name]);
}

async function readsThatClassHasEnded({ page, relay }: Visit): Promise<void> {
  const teacher = await ClassTeacher.start(relay);
  await page.goto(`/join#${teacher.code}`);
  await page.getByRole("button", { name: "Join" }).click();
  const other = page.getByRole("button", { name: "Another name" });
  await expect(other).toBeVisible();
  await teacher.direct("DELETE");
  await other.click();
  await expect(page.getByRole("alert")).toHaveText(/The lesson is over|You are no longer/);
}

test("a student joins with the letters on the board, and takes another name before the start", async ({
  page,
  relay,
}) => {
  const visit = { page, relay };
  await test.step("a student joins with small letters, and stays in the class after a reload", () =>
    joinsAndReloads(visit));
  await test.step("the code of an address is in the field, and is gone once the student has joined", () =>
    joinsByAddress(visit));
  await test.step("a student takes another name before the start, at most twice", () =>
    takesOtherNames(visit));
  await test.step("a page that is older than the relay offers to reload", () =>
    offersReload(visit));
});

test("a student who cannot join reads why", async ({ page, pageErrors, relay }) => {
  pageErrors.ignoreFailedRequests();
  const visit = { page, relay };
  await test.step("a student without a network reads what still works", () =>
    readsThatItIsOffline(visit));
  await test.step("each refusal says what to do, and the letters stay in the field", () =>
    refusesWithAdvice(visit));
  await test.step("a student whose class has ended reads it when asking for another name", () =>
    readsThatClassHasEnded(visit));
});

test("fits a phone and 320 px, also in a right-to-left language", async ({
  openWindow,
  pageErrors,
  relay,
}) => {
  pageErrors.ignoreFailedRequests();
  const { code } = await ClassTeacher.start(relay);
  const { page } = await openWindow(phone);
  for (const locale of ["en", "ar"]) {
    await page.goto(`/join?lang=${locale}#ZZZZZZ`);
    await expect(page.locator("html")).toHaveAttribute("lang", locale);
    await page.getByRole("textbox").press("Enter");
    await expect(page.getByRole("alert")).toBeVisible();
    await expect(page.getByRole("textbox")).toHaveCSS("direction", "ltr");
    expect(await smallTouchTargets(page)).toEqual([]);
    for (const width of [390, 320]) {
      await page.setViewportSize({ width, height: 568 });
      await expect.poll(() => horizontalOverflow(page), `${locale}, ${width} px`).toEqual([]);
    }
    await page.getByRole("textbox").fill(code);
    await page.getByRole("textbox").press("Enter");
    await expect(page.locator("details")).toBeVisible();
    expect(await smallTouchTargets(page)).toEqual([]);
    expect(await horizontalOverflow(page), locale).toEqual([]);
  }
});
