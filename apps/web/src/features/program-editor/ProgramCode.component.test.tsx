import type { ProgramDocument, Rule } from "@corridor/program";
import { expect, it } from "vitest";
import { page } from "vitest/browser";
import { expectAccessible } from "../../shell/testing/expect-accessible.ts";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import { ProgramHeader } from "./ProgramHeader.tsx";

const rule: Rule = { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" };

function programOf(rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "Wall", default: "forward", rules };
}

const open = page.getByRole("button", { name: "Show as code" });
const code = page.getByRole("textbox", { name: "The program as code" });

it("the code gets the address of a robot when it opens, and displays it without its key", async () => {
  const { sent, remote } = await renderWithServices(<ProgramHeader />, {
    program: programOf([rule]),
  });
  expect(sent).toEqual([]);
  await open.click();
  await expect.element(code).toHaveValue(expect.stringContaining("/r/ID#KEY"));
  await expect.element(page.getByText(/The address of your robot is missing\./)).toBeVisible();
  expect(sent).toMatchObject([{ type: "remote-open", session: null }]);
  const session = { id: "r1", ownerKey: "o", driverKey: "d_secret-key-1234", lastApplied: 0 };
  const address = "https://host/r/r1#d_secret-key-1234";
  remote.setState({ status: { kind: "waiting" }, session: { ...session, address } });
  await expect
    .element(code)
    .toHaveValue(expect.stringContaining("https://host/r/r1#•••• •••• 1234"));
  await expectAccessible();
});

it("a program whose motion needs too many conditions has a sentence instead of code", async () => {
  await renderWithServices(<ProgramHeader />, { program: programOf(Array(200).fill(rule)) });
  await open.click();
  await expect.element(page.getByText(/This program has too many lines\./)).toBeVisible();
  await expect.element(code).not.toBeInTheDocument();
  await expect.element(page.getByRole("button", { name: "Copy" })).not.toBeInTheDocument();
});
