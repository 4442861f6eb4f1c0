/** A student's page that joins a class. */
import { joinedClassSchema } from "@corridor/protocol";
import { expect, type Locator, type Page } from "playwright/test";
import { CLASS_KEY } from "../../apps/web/src/model/classes/class-key.ts";
import { CorridorPage } from "../pages/corridor-page.ts";

/** Opens the page of a student who has just joined, and waits until it is in the class. */
export async function enterClass(page: Page, code: string, origin = ""): Promise<CorridorPage> {
  await openAsStudent(page, code, origin);
  return openedClass(page);
}

/**
 * Opens the page of a student who has just joined, in any language. The student joins without the
 * page that asks for the letters, which takes as long to load.
 */
export async function openAsStudent(page: Page, code: string, origin = ""): Promise<void> {
  const joins = `${origin}/api/v1/joins`;
  const answer = await page.request.post(joins, { data: { code } });
  const joined = joinedClassSchema.parse(await answer.json());
  // A document of the same origin, without scripts.
  await page.goto(`${origin}/robots.txt`);
  await page.evaluate(([key, text]) => sessionStorage.setItem(key, text), [
    CLASS_KEY,
    JSON.stringify(joined),
  ] as const);
  await page.goto(`${origin}/`);
}

/** Joins with the code in the address, as after a scan of its QR code, and starts. */
export async function scanCode(page: Page, code: string, origin = ""): Promise<CorridorPage> {
  await page.goto(`${origin}/join#${code}`);
  return joinByForm(page);
}

/** Joins with the letters in the field, and starts. */
export async function joinByForm(page: Page): Promise<CorridorPage> {
  await page.getByRole("button", { name: "Join" }).click();
  await page.getByRole("link", { name: "Start" }).click();
  return openedClass(page);
}

/** The button with the student's name, which opens the class menu. */
export function classButton(page: Page): Locator {
  return page.getByRole("button", { name: /, in class/ });
}

async function openedClass(page: Page): Promise<CorridorPage> {
  const corridor = new CorridorPage(page);
  await corridor.waitUntilReady();
  await expect(classButton(page)).toBeVisible();
  return corridor;
}
