import { describe, expect, it } from "vitest";
import { keyIdOf } from "./key-id.ts";
import {
  unblockScript,
  pauseDriving,
  permitReset,
  offeredGateways,
  secondsLeft,
  blockScript,
  createWatchAddress,
  withNewKey,
  type Ask,
} from "./owner-calls.ts";

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
  const old = keyIdOf(session.driverKey);

  it("replaces only the old one, and the session continues", async () => {
    const address = `https://host/r/${id}#drv_new`;
    const made = { id: "k3J9x2", kind: "drive", key: "drv_new", address, urls: null };
    const { asked, ask } = service(() => Response.json(made, { status: 201 }));
    expect(await withNewKey(ask, session)).toEqual({ ...session, driverKey: "drv_new", address });
    expect(asked).toEqual([
      `POST /api/v1/robots/${id}/keys Bearer own_secret {"kind":"drive","replace":"${old}"}`,
    ]);
  });

  it("is created even if the old one is gone because a response was lost", async () => {
    const address = `https://host/r/${id}#drv_new`;
    const made = { id: "k3J9x2", kind: "drive", key: "drv_new", address, urls: null };
    const answers = [Response.json({}, { status: 409 }), Response.json(made, { status: 201 })];
    const { asked, ask } = service(() => answers.shift() ?? Response.error());
    expect(await withNewKey(ask, session)).toMatchObject({ driverKey: "drv_new" });
    expect(asked[1]).toBe(`POST /api/v1/robots/${id}/keys Bearer own_secret {"kind":"drive"}`);
  });

  it("can be created for viewers as well", async () => {
    const address = `https://host/r/${id}#wch_new`;
    const made = { id: "k3J9x2", kind: "watch", key: "wch_new", address, urls: null };
    const { asked, ask } = service(() => Response.json(made, { status: 201 }));
    expect(await createWatchAddress(ask, session)).toBe(address);
    expect(asked[0]).toContain('{"kind":"watch","replace":true}');
  });

  it.each([
    { what: "nothing answers", answer: () => Promise.reject(new TypeError("offline")) },
    { what: "files alone answer", answer: () => new Response("<html>") },
    { what: "the service refuses", answer: () => Response.json({}, { status: 507 }) },
  ])("is not available if $what, nor is the remaining time", async ({ answer }) => {
    const { ask } = service(answer);
    expect(await withNewKey(ask, session)).toBeNull();
    expect(await createWatchAddress(ask, session)).toBeNull();
    expect(await secondsLeft(ask, session)).toBeNull();
    expect(await offeredGateways(ask, session)).toBeNull();
  });
});

describe("the stored data of a robot", () => {
  it("has the remaining time and the gateways", async () => {
    const { asked, ask } = service(() =>
      Response.json({ endsInSeconds: 60, gateways: ["ros", 1, "soap"] }),
    );
    expect(await secondsLeft(ask, session)).toBe(60);
    expect(await offeredGateways(ask, session)).toEqual(["ros", "soap"]);
    expect(asked).toEqual(Array(2).fill(`GET /api/v1/robots/${id} Bearer own_secret`));
  });

  it("has no gateways if the service does not send them", async () => {
    const { ask } = service(() => Response.json({ endsInSeconds: 60 }));
    expect(await offeredGateways(ask, session)).toBeNull();
  });
});

describe("a script", () => {
  const anna = { driver: "Zx81qP", name: "Anna", client: "Python" };

  it("is blocked by its key and name, and unblocked by its id", async () => {
    const { asked, ask } = service(() => new Response(null, { status: 204 }));
    expect(await blockScript(ask, session, anna)).toBe(true);
    expect(await unblockScript(ask, session, "k3J9x2aB")).toBe(true);
    expect(asked).toEqual([
      `POST /api/v1/robots/${id}/blocked Bearer own_secret {"driver":"Zx81qP","name":"Anna","client":"Python"}`,
      `DELETE /api/v1/robots/${id}/blocked/k3J9x2aB Bearer own_secret`,
    ]);
  });

  it("cannot drive while all scripts are paused, and can afterwards", async () => {
    const { asked, ask } = service(() => new Response(null, { status: 204 }));
    expect(await pauseDriving(ask, session, true)).toBe(true);
    expect(await pauseDriving(ask, session, false)).toBe(true);
    expect(asked).toEqual([
      `PUT /api/v1/robots/${id}/pause Bearer own_secret`,
      `DELETE /api/v1/robots/${id}/pause Bearer own_secret`,
    ]);
  });

  it("may not reset the robot while the owner forbids it", async () => {
    const { asked, ask } = service(() => new Response(null, { status: 204 }));
    expect(await permitReset(ask, session, false)).toBe(true);
    expect(await permitReset(ask, session, true)).toBe(true);
    expect(asked).toEqual([
      `DELETE /api/v1/robots/${id}/script-reset Bearer own_secret`,
      `PUT /api/v1/robots/${id}/script-reset Bearer own_secret`,
    ]);
  });

  it("stays the same if the service does not respond or refuses", async () => {
    const refused = service(() => Response.json({}, { status: 409 }));
    expect(await blockScript(refused.ask, session, anna)).toBe(false);
    const silent = service(() => Promise.reject(new TypeError("offline")));
    expect(await unblockScript(silent.ask, session, "k3J9x2aB")).toBe(false);
  });
});

describe("the time that a robot has left", () => {
  it("is the response of the service", async () => {
    const { ask, asked } = service(() => Response.json({ endsInSeconds: 6_720 }));
    expect(await secondsLeft(ask, session)).toBe(6_720);
    expect(asked).toEqual([`GET /api/v1/robots/${id} Bearer own_secret`]);
  });
});
