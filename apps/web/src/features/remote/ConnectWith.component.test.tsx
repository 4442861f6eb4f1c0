import { quickstartIds, quickstarts } from "@corridor/quickstarts";
import { expect, it, onTestFinished, vi } from "vitest";
import { page, userEvent } from "vitest/browser";
import { robotAddress } from "../../model/remote/robot-address.ts";
import { expectAccessible } from "../../shell/testing/expect-accessible.ts";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import type { ListedScript } from "../../simulator/protocol/worker-messages.ts";
import { ConnectWith } from "./ConnectWith.tsx";
import { keyIdOf } from "./key-id.ts";
import type { Ask } from "./owner-calls.ts";
import { dropUrlKey, tabStorage } from "./url-key.ts";

const KEY = "drv_secret-key-1234";
const URL_KEY = "url_secret-key-5678";

const kind = page.getByRole("combobox", { name: "Connect with" });
const text = page.getByRole("textbox", { name: "Script" });
const copy = page.getByRole("button", { name: "Copy" });

/** Ids differ, because the page remembers which clients have reached a robot. */
let robots = 0;

interface Service {
  gateways?: string[];
  /** status of the response to a request for a key */
  keyStatus?: number;
}

async function renderConnect({ gateways = ["ros", "mcp", "soap"], keyStatus = 201 }: Service = {}) {
  const id = `robot-${++robots}`;
  const session = {
    id,
    ownerKey: "own_secret",
    driverKey: KEY,
    address: `https://host/r/${id}#${KEY}`,
    lastApplied: 0,
  };
  const address = robotAddress(session);
  if (address === null) throw new Error("no address");
  const requests: string[] = [];
  const copied: string[] = [];
  const answer: Ask = async (url, { method = "GET", body = "" }) => {
    if (method === "GET") return Response.json({ gateways });
    requests.push(`${method} ${url} ${body}`);
    const made = { id: keyIdOf(URL_KEY), kind: "drive", key: URL_KEY, address: null };
    const urls = { ros: `wss://host/r/${id}/ros/${URL_KEY}`, mcp: null };
    return Response.json({ ...made, urls }, { status: keyStatus });
  };
  vi.stubGlobal("fetch", answer);
  vi.spyOn(navigator.clipboard, "writeText").mockImplementation(async (written) => {
    copied.push(written);
  });
  onTestFinished(() => {
    vi.restoreAllMocks();
    vi.unstubAllGlobals();
  });
  const services = await renderWithServices(<ConnectWith address={address} session={session} />);
  await expect.element(page.getByRole("link", { name: "How to write a script" })).toBeVisible();
  return { ...services, id, requests, copied };
}

function scriptOf(client: string): ListedScript {
  return {
    id: "k3J9x2aB",
    driver: "Zx81qP",
    name: null,
    client,
    connections: 1,
    seenAt: Date.now(),
    last: null,
    lastProblem: null,
    isBlocked: false,
  };
}

function options(): string[] {
  return [...(kind.element() as HTMLSelectElement).options].map(({ text: label }) => label);
}

it("copies every text with its key, and displays it without", async () => {
  const { id, copied } = await renderConnect();
  await expect.poll(options).toHaveLength(quickstartIds.length);
  for (const chosen of quickstartIds) {
    await kind.selectOptions(chosen);
    await copy.click();
    const parts = { origin: "https://host", id, key: KEY, urlKey: URL_KEY };
    await expect.poll(() => copied.at(-1)).toBe(quickstarts[chosen].text(parts));
    await expect.element(text).toHaveValue(expect.stringMatching(/•••• •••• (1234|5678)/));
    await expect.element(text).not.toHaveValue(expect.stringContaining("secret-key"));
  }
  expect(copied).toHaveLength(quickstartIds.length);
});

it("creates a key for URLs when the first text with one is copied, and reuses it", async () => {
  const { id, requests, copied } = await renderConnect();
  await kind.selectOptions("rosbridge");
  await expect.element(text).toHaveValue(`wss://host/r/${id}/ros/•••• •••• ••••`);
  expect(requests).toEqual([]);
  await copy.click();
  await expect.poll(() => copied).toHaveLength(1);
  await copy.click();
  await expect.poll(() => copied).toEqual([`wss://host/r/${id}/ros/${URL_KEY}`, copied[0]]);
  const created = `POST /api/v1/robots/${id}/keys {"kind":"drive","use":"url"}`;
  expect(requests).toEqual([created]);
  // The owner revokes it in the list of keys.
  dropUrlKey(tabStorage, keyIdOf(URL_KEY));
  await copy.click();
  await expect.poll(() => requests).toEqual([created, created]);
});

it("says that the key could not be made, until another kind is chosen", async () => {
  const { copied } = await renderConnect({ keyStatus: 409 });
  await kind.selectOptions("rosbridge");
  await copy.click();
  const failed = page.getByText("That did not work. Try again in a moment.");
  await expect.element(failed).toBeVisible();
  expect(copied).toEqual([]);
  await kind.selectOptions("go");
  await expect.element(failed).not.toBeInTheDocument();
});

it("offers no text for a gateway that is off", async () => {
  await renderConnect({ gateways: ["mcp"] });
  await expect.poll(options).toContain("Claude Code (MCP)");
  expect(options().filter((label) => /ROS|rosbridge|SOAP/.test(label))).toEqual([]);
  expect(options()).toContain("Micromouse program");
});

it("marks the kinds whose first message has arrived, also after the script is no longer listed", async () => {
  const { remote } = await renderConnect();
  const mark = page.getByRole("status").filter({ hasText: "First message arrived" });
  await expect.element(mark).not.toBeInTheDocument();
  remote.setState({ scripts: [scriptOf("ROS")] });
  await expect.poll(options).toContain("roslibpy (ROS) ✓");
  await expect.element(mark).not.toBeInTheDocument();
  await kind.selectOptions("roslib");
  await expect.element(mark).toBeVisible();
  remote.setState({ scripts: [scriptOf("MCP")] });
  await expect.element(mark).toBeVisible();
  await kind.selectOptions("cursor");
  await expect.element(mark).toBeVisible();
  await kind.selectOptions("micromouse");
  await expect.element(mark).not.toBeInTheDocument();
  await expectAccessible();
});

it("is chosen and copied by keyboard", async () => {
  const { id, copied } = await renderConnect();
  await expect.poll(options).toHaveLength(quickstartIds.length);
  (kind.element() as HTMLSelectElement).focus();
  await userEvent.keyboard("{ArrowDown}");
  await expect.element(kind).toHaveValue("javascript");
  await userEvent.tab();
  await userEvent.keyboard("{Enter}");
  await expect.poll(() => copied.join("")).toContain(`/api/v1/robots/${id}`);
});
