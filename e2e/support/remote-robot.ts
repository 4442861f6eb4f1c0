/** The robot of a page as scripts use it: its address and API calls. */
import { expect, type Page } from "playwright/test";

/** Selects Remote as the driver and copies the robot's address through the clipboard. */
export async function copyAddress(page: Page): Promise<string> {
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  expect(address).toMatch(/\/r\/[\w-]{22}#\w+/);
  return address;
}

export async function setSpeed(page: Page, speed: string): Promise<void> {
  await page.getByRole("combobox", { name: "Speed" }).selectOption(speed);
}

export async function api(
  address: string,
  path: string,
  body?: unknown,
  name?: string,
): Promise<Response> {
  const { origin, pathname, hash } = new URL(address);
  const id = pathname.slice("/r/".length);
  return fetch(`${origin}/api/v1/robots/${id}${path}`, {
    method: body === undefined ? "GET" : "POST",
    headers: {
      authorization: `Bearer ${hash.slice(1)}`,
      "content-type": "application/json",
      ...(name !== undefined && { "script-name": name }),
    },
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
  });
}
