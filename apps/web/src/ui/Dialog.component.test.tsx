import { useState } from "react";
import { I18nextProvider } from "react-i18next";
import { expect, it } from "vitest";
import { page, userEvent } from "vitest/browser";
import { render } from "vitest-browser-react";
import { en } from "../text/en/index.ts";
import { createI18n } from "../text/i18n.ts";
import { Button } from "./Button.tsx";
import { Dialog } from "./Dialog.tsx";

/** A page with two buttons around the one that opens a dialog. */
function Page({ isText = false }: { isText?: boolean }) {
  const [isOpen, setIsOpen] = useState(false);
  return (
    <>
      <Button>Before</Button>
      <Button onClick={() => setIsOpen(true)}>Open</Button>
      <Button>After</Button>
      <Dialog
        isOpen={isOpen}
        onClose={() => setIsOpen(false)}
        title="Name the maze"
        width="narrow"
        isText={isText}
        footer={isText ? undefined : <Button>Save</Button>}
      >
        {isText ? <p>Only text.</p> : <input aria-label="Name" />}
      </Dialog>
    </>
  );
}

const button = (name: string) => page.getByRole("button", { name });
const dialog = page.getByRole("dialog", { name: "Name the maze" });

async function renderPage(props: { isText?: boolean } = {}): Promise<void> {
  await render(
    <I18nextProvider i18n={createI18n(en)}>
      <Page {...props} />
    </I18nextProvider>,
  );
}

async function open(): Promise<void> {
  button("Open").element().focus();
  await userEvent.keyboard("{Enter}");
  await expect.element(dialog).toBeVisible();
}

it("opens with its title as its name and the focus inside", async () => {
  await renderPage();
  await open();
  expect(dialog.element().contains(document.activeElement)).toBe(true);
});

it("keeps Tab and Shift+Tab on its own controls", async () => {
  await renderPage();
  await open();
  const reached = new Set<string>();
  for (const key of ["{Tab}", "{Shift>}{Tab}{/Shift}"]) {
    for (let press = 0; press < 8; press++) {
      await userEvent.keyboard(key);
      const { activeElement } = document;
      // Between the last and the first control, the browser's own controls have the focus.
      if (activeElement === null || activeElement === document.body) continue;
      expect(dialog.element().contains(activeElement)).toBe(true);
      reached.add(activeElement.getAttribute("aria-label") ?? activeElement.textContent);
    }
  }
  expect([...reached].toSorted()).toEqual(["Close", "Name", "Save"]);
});

it.each([
  { by: "Escape", close: () => userEvent.keyboard("{Escape}") },
  { by: "its Close button", close: () => button("Close").click() },
])("closes with $by, and returns the focus to its button", async ({ close }) => {
  await renderPage();
  await open();
  await close();
  await expect.element(dialog).not.toBeInTheDocument();
  await expect.element(button("Open")).toHaveFocus();
});

it("closes with a press beside it, but not with a press on its content", async () => {
  await renderPage();
  await open();
  await page.getByRole("heading", { name: "Name the maze" }).click();
  await expect.element(dialog).toBeVisible();
  await userEvent.click(document.body, { position: { x: 5, y: 5 }, force: true });
  await expect.element(dialog).not.toBeInTheDocument();
});

it("opens again after it was closed with Escape", async () => {
  await renderPage();
  await open();
  await userEvent.keyboard("{Escape}");
  await expect.element(dialog).not.toBeInTheDocument();
  await open();
});

it("can be scrolled by keys where it has text only", async () => {
  await renderPage({ isText: true });
  await open();
  await userEvent.keyboard("{Tab}");
  const text = page.getByRole("region", { name: "Name the maze" });
  await expect.element(text).toHaveFocus();
});
