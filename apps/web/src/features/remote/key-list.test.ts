import { expect, it } from "vitest";
import { agoText } from "./ago-text.ts";
import { keyIdOf } from "./key-id.ts";
import { listed, listKeys, revokeKey } from "./key-calls.ts";

// cspell:ignore Stunden

const at = (minute: number): string => new Date(Date.UTC(2026, 0, 1, 12, minute)).toISOString();
const keys = [
  {
    id: "watch1",
    kind: "watch" as const,
    use: "url" as const,
    createdAt: at(20),
    lastUsedAt: null,
  },
  { id: "owner1", kind: "own" as const, use: null, createdAt: at(0), lastUsedAt: at(29) },
  { id: "paired", kind: "drive" as const, use: null, createdAt: at(10), lastUsedAt: at(31) },
  { id: "first1", kind: "drive" as const, use: null, createdAt: at(0), lastUsedAt: at(25) },
];
const owner = { id: "A".repeat(22), ownerKey: "own_secret", driverKey: "drv_secret" };
const MINUTE = 60_000;

it("lists the keys that were given away, the address's own first, with their ages", () => {
  expect(listed({ keys }, "first1", Date.parse(at(30)))).toEqual([
    {
      id: "first1",
      kind: "drive",
      isForUrl: false,
      madeAgo: 30 * MINUTE,
      usedAgo: 5 * MINUTE,
      isShown: true,
    },
    // The clocks of two relays can differ slightly.
    {
      id: "paired",
      kind: "drive",
      isForUrl: false,
      madeAgo: 20 * MINUTE,
      usedAgo: 0,
      isShown: false,
    },
    {
      id: "watch1",
      kind: "watch",
      isForUrl: true,
      madeAgo: 10 * MINUTE,
      usedAgo: null,
      isShown: false,
    },
  ]);
});

it("recognizes the key of the address by its id, even if paired keys are older", () => {
  const shown = listed({ keys }, "paired", Date.parse(at(30)));
  expect(shown.map(({ id, isShown }) => [id, isShown])).toEqual([
    ["paired", true],
    ["first1", false],
    ["watch1", false],
  ]);
});

it("counts by the clock of the service, and shows nothing if that does not respond", async () => {
  const headers = { date: new Date(Date.parse(at(30))).toUTCString() };
  const found = await listKeys(async () => Response.json({ keys }, { headers }), owner);
  expect(found?.[0]).toMatchObject({ madeAgo: 30 * MINUTE });
  const ofAddress = { ...keys[3], id: keyIdOf(owner.driverKey) };
  const list = { keys: [...keys, ofAddress] };
  const shown = await listKeys(async () => Response.json(list, { headers }), owner);
  expect(shown?.[0]).toMatchObject({ id: ofAddress.id, isShown: true });
  expect(await listKeys(async () => Response.json({}, { status: 401 }), owner)).toBeNull();
  expect(await listKeys(() => Promise.reject(new TypeError("offline")), owner)).toBeNull();
});

it("revokes by the id", async () => {
  const asked: string[] = [];
  const ask = async (url: string, { method = "GET" }: { method?: string }) => {
    asked.push(`${method} ${url}`);
    return new Response(null, { status: 204 });
  };
  expect(await revokeKey(ask, owner, "paired")).toBe(true);
  expect(asked).toEqual([`DELETE /api/v1/robots/${owner.id}/keys/paired`]);
});

it.each([
  { ms: 10_000, language: "en", text: "this minute" },
  { ms: 5.5 * MINUTE, language: "en", text: "5 minutes ago" },
  { ms: 130 * MINUTE, language: "de", text: "vor 2 Stunden" },
  { ms: 5 * MINUTE, language: "zh-Hans", text: "5分钟前" },
])("says $text", ({ ms, language, text }) => {
  expect(agoText(ms, language)).toBe(text);
});

it("uses Latin digits in Arabic", () => {
  expect(agoText(15 * MINUTE, "ar")).toContain("15");
});
