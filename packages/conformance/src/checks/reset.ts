/** `reset` puts the robot at its start. Optional, because a physical robot may be unable to. */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { waitForRetryAfter, type Host, type RequestOptions } from "../host.ts";
import { must, NotTestable, validate } from "../mismatch.ts";
import { moveToStart, mustHaveReadings, mustStand, readings } from "../pen.ts";

/** Ticks of half a second: time that may pass between a reset and the next snapshot. */
const FEW_TICKS = 30;
/** ms of a motion, so that the tick before a reset is much later than the one after it */
const MOTION_MS = 1_000;

export const reset: CheckGroup = {
  title: "Reset",
  checks: [
    {
      promise: "reset",
      name: "reset puts the robot at its start, and ends as completed with the distance 0",
      needs: ["reset"],
      run: async (host) => {
        await moveToStart(host);
        await resetNow(host);
        const start = await readings(host);
        await host.sendAndWait({ action: "move", distance: 60 });
        await host.sendAndWait({ action: "drive", left: 0, right: 0, milliseconds: MOTION_MS });
        const end = await resetNow(host);
        const isRight = end.state === "completed" && end.distance === 0;
        must(isRight, "completed with the distance 0", end);
        await mustHaveReadings(host, start, "after a reset");
        const { tick, bumps } = await host.snapshot();
        must(tick <= FEW_TICKS && bumps === 0, "a new run, with tick and bumps 0", { tick, bumps });
        await mustStand(host);
      },
    },
    {
      promise: "reset-replaces",
      name: "reset ends the running and all waiting commands as superseded",
      needs: ["reset"],
      run: async (host) => {
        const { seq } = await host.send({ action: "turn", degrees: 3_600 });
        await host.waitForStart(seq);
        const waiting = await host.send({ action: "left 90" });
        await resetNow(host);
        for (const each of [seq, waiting.seq]) {
          const { state } = await host.record(each);
          must(state === "superseded", "superseded", state);
        }
      },
    },
    {
      promise: "reset-rate",
      name: "a second reset within a second is rejected with 429, and its key stays free",
      needs: ["reset"],
      run: async (host) => {
        const key = host.newKey();
        const { seq } = await startReset(host);
        const early = await host.requestOnce("/commands", resetWith(key));
        must(early.status === 429, "429 for a second reset", `${early.status} ${early.text}`);
        must(early.header("retry-after") !== "", "a header Retry-After", "none");
        await waitForRetryAfter(early);
        const later = await host.request("/commands", resetWith(key));
        must(later.status === 202, "202 after a second", `${later.status} ${later.text}`);
        for (const each of [seq, seq + 1]) await host.waitForEnd(each);
      },
    },
    {
      promise: "reset-not-supported",
      name: "a host that cannot reset itself rejects reset with 422, and the robot stands",
      run: async (host) => {
        const { notOffered } = await host.features();
        if (!notOffered.some(({ feature }) => feature === "reset")) return;
        const before = await readings(host);
        const { status, text } = await host.request("/commands", resetWith());
        const isRight = status === 422 && text.includes("/problems/not-supported");
        must(isRight, "422 not-supported", `${status} ${text}`);
        await mustHaveReadings(host, before, "as before");
      },
    },
  ],
};

function resetWith(key?: string): RequestOptions {
  const headers = key === undefined ? {} : { "Idempotency-Key": key };
  return { method: "POST", body: { action: "reset" }, headers };
}

/** @returns the record of a reset, once the robot has ended it */
async function resetNow(host: Host): Promise<CommandRecord> {
  return host.waitForEnd((await startReset(host)).seq);
}

/** Sends a reset. The host may request a wait. @throws NotTestable if the owner forbids it */
async function startReset(host: Host): Promise<CommandRecord> {
  const { status, text, json } = await host.request("/commands", resetWith());
  if (status === 403) {
    throw new NotTestable(
      "the robot's owner has forbidden resets. Allow them and run the kit again",
    );
  }
  must(status === 202, "202 for reset", `${status} ${text}`);
  return validate(commandRecordSchema, json, "a command record");
}
