import { expect, it, onTestFinished, vi } from "vitest";
import { page } from "vitest/browser";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import type { ListedCommand, RemoteView } from "../../simulator/protocol/worker-messages.ts";
import { CommandLog } from "./CommandLog.tsx";

/** The worker's list with the newest command in a state. Each message has other objects. */
function viewOf(newest: ListedCommand["state"]): RemoteView {
  const commands = Array.from({ length: 5 }, (_, index): ListedCommand => ({
    seq: 5 - index,
    key: null,
    action: "move",
    command: { action: "move", distance: 200 },
    state: index === 0 ? newest : "completed",
    reason: null,
    acceptedAt: "2026-01-01T12:00:00.000Z",
    pose: null,
    distance: null,
    duplicate: false,
    ttl: 10_000,
  }));
  const status = { kind: "off" } as const;
  return { status, session: null, commands, scripts: [], isPaused: false, mayReset: true };
}

it("renders only the command that changes: a script sends several a second", async () => {
  const { receive } = await renderWithServices(<CommandLog />);
  const running = page.getByText("running", { exact: true });
  receive({ type: "remote", remote: viewOf("started") });
  await expect.element(running).toBeVisible();
  // Each row that is rendered formats its time, by a method that is a property with a getter.
  const prototype: { readonly format: unknown } = Intl.DateTimeFormat.prototype;
  const formatted = vi.spyOn(prototype, "format", "get");
  onTestFinished(() => formatted.mockRestore());
  receive({ type: "remote", remote: viewOf("completed") });
  await expect.element(running).not.toBeInTheDocument();
  expect(formatted).toHaveBeenCalledTimes(1);
});
