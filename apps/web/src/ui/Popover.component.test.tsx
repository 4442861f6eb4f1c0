import { expect, it } from "vitest";
import { page, userEvent } from "vitest/browser";
import { render } from "vitest-browser-react";
import { Button } from "./Button.tsx";
import { Popover, usePopover } from "./Popover.tsx";

function Menu() {
  const menu = usePopover();
  return (
    <>
      <Button {...menu.trigger}>View</Button>
      <Popover {...menu.panel} label="View">
        <details>
          <summary>More</summary>
          <button>Grid</button>
        </details>
      </Popover>
    </>
  );
}

const trigger = page.getByRole("button", { name: "View" });
const menu = page.getByRole("dialog", { name: "View" });
const more = page.getByText("More");

it("has its content in the moment in which it opens, before its toggle event", async () => {
  await render(<Menu />);
  const dialog = document.querySelector("dialog");
  if (dialog === null) throw new Error("The menu has no dialog.");
  const contentAtToggle = new Promise<string | null>((resolve) => {
    dialog.addEventListener("toggle", () => resolve(dialog.textContent), {
      once: true,
      capture: true,
    });
  });
  await trigger.click();
  expect(await contentAtToggle).toBe("MoreGrid");
  await expect.element(trigger).toHaveAttribute("aria-expanded", "true");
});

it("stays open when a part of it is folded out", async () => {
  await render(<Menu />);
  await trigger.click();
  await more.click();
  await expect.element(page.getByRole("button", { name: "Grid" })).toBeVisible();
  await expect.element(menu).toBeVisible();
});

it("closes on Escape with the focus on its button and nothing left inside", async () => {
  await render(<Menu />);
  await trigger.click();
  await more.click();
  await userEvent.keyboard("{Escape}");
  await expect.element(menu).not.toBeInTheDocument();
  expect(document.activeElement).toBe(trigger.element());
  await expect.element(trigger).toHaveAttribute("aria-expanded", "false");
  expect(document.querySelector("dialog")?.textContent).toBe("");
});
