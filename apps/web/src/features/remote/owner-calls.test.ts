import { describe, expect, it } from "vitest";
import { secondsLeft, watchAddress, withNewKey, type Ask } from "./owner-calls.ts";

const id = "A".repeat(22);
const session = {
  id,
  ownerKey: "own_secret",
  driverKey: "drv_old",
  address: `https://host/r/${id}#drv_old`,
  lastApplied: 7,
};

function service(answer: () => Response | Promise<Response>) {
  const asked: string[] = [];
  const ask: Ask = async (url, { method = "GET", headers, body = "" }) => {
    asked.push(`${method} ${url} ${headers["Authorization"] ?? ""} ${body}`.trim());
    return answer();
  };
  return { asked, ask };
}

describe("a new key for scripts", () => {
  it("replaces the old one, and the session goes on", async () => {
    const address = `https://host/r/${id}#drv_new`;
    const made = { id: "k3J9x2", kind: "drive", key: "drv_new", address };
    const { asked, ask } = service(() => Response.json(made, { status: 201 }));
    expect(await withNewKey(ask, session)).toEqual({ ...session, driverKey: "drv_new", address });
    expect(asked).toEqual([
      `POST /api/v1/robots/${id}/keys Bearer own_secret {"kind":"drive","replace":true}`,
    ]);
  });

  it("is made for onlookers beside it", async () => {
    const address = `https://host/r/${id}#wch_new`;
    const made = { id: "k3J9x2", kind: "watch", key: "wch_new", address };
    const { asked, ask } = service(() => Response.json(made, { status: 201 }));
    expect(await watchAddress(ask, session)).toBe(address);
    expect(asked[0]).toContain('{"kind":"watch","replace":true}');
  });

  it.each([
    { what: "nothing answers", answer: () => Promise.reject(new TypeError("offline")) },
    { what: "files alone answer", answer: () => new Response("<html>") },
    { what: "the service refuses", answer: () => Response.json({}, { status: 507 }) },
  ])("is not to be had where $what, and the time left neither", async ({ answer }) => {
    const { ask } = service(answer);
    expect(await withNewKey(ask, session)).toBeNull();
    expect(await watchAddress(ask, session)).toBeNull();
    expect(await secondsLeft(ask, session)).toBeNull();
  });
});

describe("the time that a robot has left", () => {
  it("is what the service says", async () => {
    const { ask, asked } = service(() => Response.json({ endsInSeconds: 6_720 }));
    expect(await secondsLeft(ask, session)).toBe(6_720);
    expect(asked).toEqual([`GET /api/v1/robots/${id} Bearer own_secret`]);
  });
});
